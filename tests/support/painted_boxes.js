// SPDX-License-Identifier: MIT
// A figure of boxes on a floor, each box a separate mesh, coloured by a palette: every side shows
// one colour of a texture, and the front of the head has eyes and a mouth of a few cells.
import { GltfMaker } from './gltf.js';
import { png } from './png.js';

const palette = [[230, 190, 150], [20, 20, 30], [200, 40, 40], [60, 90, 200], [40, 160, 70],
  [250, 220, 60], [240, 240, 240], [120, 80, 40]];
const across = 8;  // pixels of each colour

/** Each side of a box: the axis it faces along, the two it spans, and which way it faces. */
const sides = [[2, 0, 1], [0, 1, 2], [1, 2, 0]].flatMap((axes) =>
  [1, -1].map((sign) => ({ axes, sign })));

/** Six grids of cells that share no vertices; `colour(side, i, j)` is a cell's palette number. */
function box({ size, cells, colour }) {
  const mesh = { positions: [], texcoords: [], indices: [], colours: [] };
  sides.forEach(({ axes: [normal, a, b], sign }, side) => {
    for (let i = 0; i < cells[a]; i += 1) {
      for (let j = 0; j < cells[b]; j += 1) {
        const shown = colour(side, i, j);
        const first = mesh.positions.length / 3;
        for (const [s, t] of [[0, 0], [1, 0], [1, 1], [0, 1]]) {
          const place = [0, 0, 0];
          place[normal] = (sign * size[normal]) / 2;
          place[a] = size[a] * ((i + s) / cells[a] - 0.5);
          place[b] = sign * size[b] * ((j + t) / cells[b] - 0.5);
          mesh.positions.push(...place);
          mesh.texcoords.push((shown + 0.25 + 0.5 * ((i + s) / cells[a])) / palette.length,
            0.25 + 0.5 * ((j + t) / cells[b]));
        }
        mesh.indices.push(...[0, 1, 2, 0, 2, 3].map((k) => first + k));
        mesh.colours.push(shown, shown);
      }
    }
  });
  return mesh;
}

const plain = (shown) => () => shown;
const faced = (side) => side + 1;

function headColour(side, i, j) {
  if (side !== 0) return side === 2 ? 7 : 0;
  if (j === 4 && (i === 1 || i === 4)) return 1;
  return j === 1 && i > 1 && i < 4 ? 2 : 0;
}

const limb = { size: [0.3, 0.9, 0.3], cells: [2, 4, 2] };

/** The boxes, with their places. */
export const boxes = [
  { name: 'head', size: [1, 1, 1], cells: [6, 6, 6], colour: headColour, at: [0, 2.9, 0] },
  { name: 'body', size: [1, 1.4, 0.5], cells: [6, 8, 4], colour: faced, at: [0, 1.6, 0] },
  ...[[-0.7, 1.8], [0.7, 1.8], [-0.3, 0.45], [0.3, 0.45]].map(([x, y], k) =>
    ({ name: `limb ${k}`, ...limb, colour: faced, at: [x, y, 0] })),
  { name: 'floor', size: [6, 0.2, 6], cells: [4, 1, 4], colour: plain(4), at: [0, -0.1, 0] },
  { name: 'wall', size: [6, 4, 0.2], cells: [4, 3, 1], colour: plain(6), at: [0, 2, -3] },
].map((made) => ({ ...made, mesh: box(made) }));

/** The colour's number at a place of the texture. */
export const colourAt = ([u]) => Math.floor(u * palette.length);

export function paintedBoxes() {
  const maker = new GltfMaker();
  const picture = png(across * palette.length, across, (x) => palette[Math.floor(x / across)]);
  Object.assign(maker.tree, {
    images: [{ bufferView: maker.addView(picture), mimeType: 'image/png' }],
    samplers: [{ magFilter: 9728, minFilter: 9728 }],
    textures: [{ source: 0, sampler: 0 }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    meshes: boxes.map(({ name, mesh }) => ({ name, primitives: [{
      attributes: {
        POSITION: maker.add(Float32Array.from(mesh.positions), 'VEC3'),
        TEXCOORD_0: maker.add(Float32Array.from(mesh.texcoords), 'VEC2'),
      },
      indices: maker.addIndices(Uint32Array.from(mesh.indices)),
      material: 0,
    }] })),
    nodes: boxes.map(({ at }, mesh) => ({ mesh, translation: at })),
    scenes: [{ nodes: boxes.map((_, i) => i) }],
    scene: 0,
  });
  return maker.glb();
}
