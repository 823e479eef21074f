// SPDX-License-Identifier: MIT
// A torus like an exporter's file: two materials, separate accessors for each primitive, a texture,
// a skin of two joints, a morph target, and beside it a smaller torus that is shown twice.
import { addChart, layOut, place, texels } from './atlas_torus.js';
import { GltfMaker } from './gltf.js';
import { png } from './png.js';
import { torus } from './shapes.js';

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

const wave = (x, length) => Math.round(127 + 100 * Math.sin((2 * Math.PI * x) / length));
const texture = () => png(texels, texels, (x, y) => [wave(x, texels / 2), wave(y, texels), 90]);

/** A half of the torus as a primitive. Joint 0 moves the left half, joint 1 the right half. */
function addHalf(maker, chart, material) {
  const mesh = { positions: [], texcoords: [], indices: [] };
  addChart(mesh, chart);
  const positions = Float32Array.from(mesh.positions);
  const vertices = Array.from({ length: positions.length / 3 },
    (_, i) => [...positions.subarray(3 * i, 3 * i + 3)]);
  const rightness = vertices.map(([x]) => Math.min(Math.max(0.5 + x / 4, 0), 1));
  return {
    attributes: {
      POSITION: maker.add(positions, 'VEC3'),
      TEXCOORD_0: maker.add(Float32Array.from(mesh.texcoords), 'VEC2'),
      JOINTS_0: maker.add(Uint8Array.from(vertices.flatMap(() => [0, 1, 0, 0])), 'VEC4'),
      WEIGHTS_0: maker.add(Float32Array.from(rightness.flatMap((w) => [1 - w, w, 0, 0])), 'VEC4'),
    },
    targets: [{ POSITION: maker.add(Float32Array.from(vertices.flatMap(([x]) => [0, 0, x])),
      'VEC3') }],
    indices: maker.addIndices(Uint32Array.from(mesh.indices)),
    material,
  };
}

function addSmallTorus(maker) {
  const small = torus({ columns: 32, rows: 16, radius: 0.5, tube: 0.2 });
  const normals = Int8Array.from(small.positions, (_, i) => (i % 3 === 2 ? 127 : 0));
  return {
    attributes: {
      POSITION: maker.add(small.positions, 'VEC3'),
      NORMAL: maker.add(normals, 'VEC3', { normalized: true }),
    },
    indices: maker.addIndices(Uint16Array.from(small.indices)),
    material: 2,
  };
}

const materialOf = (factor) => ({
  pbrMetallicRoughness: { baseColorTexture: { index: 0 }, baseColorFactor: factor },
  extensions: { KHR_materials_unlit: {} },
});

/** The points where both halves meet, all around the tube. */
export const meetingPlaces = [0, 32].flatMap((i) =>
  Array.from({ length: 32 }, (_, j) => place(i, j)));

export function skinnedTorus() {
  const maker = new GltfMaker();
  const halves = layOut({ around: [0, 32, 64], across: [0, 32] });
  const big = { name: 'big', extras: { targetNames: ['lean'] },
    primitives: halves.map((half, i) => addHalf(maker, half, i)) };
  const small = { name: 'small', primitives: [addSmallTorus(maker)] };
  const inverses = maker.describe({ componentType: 5126, count: 2, type: 'MAT4',
    bufferView: maker.addView(Float32Array.from([...identity, ...identity])) });
  Object.assign(maker.tree, {
    extensionsUsed: ['KHR_materials_unlit', 'KHR_mesh_quantization'],
    extensionsRequired: ['KHR_mesh_quantization'],
    images: [{ bufferView: maker.addView(texture()), mimeType: 'image/png' }],
    textures: [{ source: 0 }],
    materials: [materialOf([1, 1, 1, 1]), materialOf([0.5, 1, 0.5, 1]), {}],
    meshes: [big, small],
    skins: [{ joints: [1, 2], inverseBindMatrices: inverses }],
    nodes: [
      { name: 'body', mesh: 0, skin: 0 }, { name: 'left', children: [2] }, { name: 'right' },
      { name: 'one', mesh: 1, translation: [0, 0, 3] },
      { name: 'two', mesh: 1, translation: [0, 0, -3], scale: [2, 2, 2] },
    ],
    scenes: [{ nodes: [0, 1, 3, 4] }],
    scene: 0,
  });
  return maker.glb();
}
