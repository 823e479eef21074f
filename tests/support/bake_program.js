// SPDX-License-Identifier: MIT
// A program that paints textures twice: from a coloured scan, which encodes an image, and from that
// result, which decodes the image. It prints one line, which is the same if the bytes are the same.

const body = `
const columns = 24;
const lines = [];
for (let i = 0; i < columns * columns; i += 1) {
  const x = (i % columns) / columns, y = Math.floor(i / columns) / columns;
  const z = 0.8 * x * (x - 0.5) * (x - 1); // no sine: engines differ in its last digit
  lines.push([x, y, z, Math.round(255 * x), Math.round(255 * y), 90].join(' '));
}
for (let i = 0; i + columns < columns * columns; i += 1) {
  if ((i + 1) % columns === 0) continue;
  lines.push([4, i, i + 1, i + columns + 1, i + columns].join(' '));
}
const header = ['ply', 'format ascii 1.0', 'element vertex ' + columns ** 2,
  ...['x', 'y', 'z'].map((name) => 'property float ' + name),
  ...['red', 'green', 'blue'].map((name) => 'property uchar ' + name),
  'element face ' + (columns - 1) ** 2, 'property list uchar int vertex_indices', 'end_header'];
const options = { textures: 'bake', textureSize: 64, vertices: 200, output: 'glb' };
const scan = new TextEncoder().encode([...header, ...lines, ''].join('\\n'));
const first = await remeshFile(scan, { ...options, name: 'scan.ply', textureFormat: 'webp' });
const second = await remeshFile(first.bytes,
  { ...options, name: 'scan.glb', vertices: 150, textureFormat: 'png' });
const sum = (bytes) => bytes.reduce((a, b) => (31 * a + b) % 1000003, 0);
const line = [first, second].map(({ bytes }) => bytes.length + ' ' + sum(bytes)).join(' ');`;

const imports = "import { init, remeshFile } from 'remesher';\n";

/** The program for Node, which finds the codecs by itself. */
export const nodeProgram = `${imports}${body}\nconsole.log(line);\n`;

/** The program for a page, as a module whose default export is the line. */
export const pageProgram = `${imports}import { codecs } from 'remesher/codecs';
await init({ codecs });${body}\nexport default line;\n`;
