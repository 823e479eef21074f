// SPDX-License-Identifier: MIT
// Joins the pieces of a scan that `slab` has made, in the order of their slabs, as one PLY; without
// a queue:
//   node join.js piece1.ply piece2.ply > joined.ply
import { readFileSync, realpathSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const end = 'end_header\n';

/** @param {string} element @param {string} header */
const countOf = (element, header) => Number(new RegExp(`^element ${element} (\\d+)$`, 'm')
  .exec(header)?.[1]);

/** A piece, with its header apart from its vertices and its triangles.
 * @param {Uint8Array} given */
function opened(given) {
  const bytes = Buffer.from(given.buffer, given.byteOffset, given.length);
  const begin = bytes.indexOf(end) + end.length;
  const header = bytes.toString('latin1', 0, begin);
  const triangles = countOf('face', header);
  const isPlain = /^format binary_\w+_endian 1\.0$/m.test(header)
    && /element face .*\nproperty list u\w+ u?int\w* \w+\nend_header\n$/.test(header);
  if (!isPlain) throw new Error('only pieces of binary PLY without textures can be joined');
  const split = bytes.length - 13 * triangles;
  return { header, vertices: countOf('vertex', header), triangles,
    ofVertices: bytes.subarray(begin, split), ofTriangles: bytes.subarray(split) };
}

/** The triangles with vertices numbered from another one on.
 * @param {Buffer} triangles @param {number} first @param {boolean} isLittle */
function renumbered(triangles, first, isLittle) {
  const result = Buffer.from(triangles);
  for (let at = 0; at < result.length; at += 13) {
    for (let corner = at + 1; corner < at + 13; corner += 4) {
      if (isLittle) result.writeUInt32LE(result.readUInt32LE(corner) + first, corner);
      else result.writeUInt32BE(result.readUInt32BE(corner) + first, corner);
    }
  }
  return result;
}

/** @param {Uint8Array[]} given the pieces in the order of their slabs */
export function joined(given) {
  const pieces = given.map(opened);
  const [{ header }] = pieces;
  const isLittle = header.includes('binary_little_endian');
  let vertices = 0, triangles = 0;
  const faces = [];
  for (const piece of pieces) {
    faces.push(renumbered(piece.ofTriangles, vertices, isLittle));
    vertices += piece.vertices;
    triangles += piece.triangles;
  }
  const whole = header.replace(/^element vertex \d+$/m, `element vertex ${vertices}`)
    .replace(/^element face \d+$/m, `element face ${triangles}`);
  return Buffer.concat([Buffer.from(whole, 'latin1'),
    ...pieces.map(({ ofVertices }) => ofVertices), ...faces]);
}

if (realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
  process.stdout.write(joined(process.argv.slice(2).map((path) => readFileSync(path))));
}
