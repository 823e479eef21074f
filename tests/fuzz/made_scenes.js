// SPDX-License-Identifier: MIT
// Surfaces as glTF files that show them several times or unevenly scaled, have levels of detail, or
// refer to them by number. Only cases from `firstWithScenes` on have these kinds, so that earlier
// cases stay the same.
import { GltfMaker } from '../support/gltf.js';

export const firstWithScenes = 3_000_000;

const flat = (lists) => Float32Array.from(lists.flat());
const indicesOf = ({ triangles }) => Uint16Array.from(triangles.flat());

function primitiveOf(maker, shape, indices = maker.addIndices(indicesOf(shape))) {
  return { attributes: { POSITION: maker.add(flat(shape.positions), 'VEC3') }, indices };
}

function uneven(shape) {
  const maker = new GltfMaker();
  maker.show([primitiveOf(maker, shape)]);
  maker.tree.nodes = [{ mesh: 0, scale: [20, 1, 0.3] },
    { mesh: 0, scale: [1, -3, 1], rotation: [0, 0.6, 0, 0.8], translation: [50, 0, 0] }];
  maker.tree.scenes[0].nodes = [0, 1];
  return maker;
}

/** A mesh that is shown, one hidden by scale 0, and one that is in no scene. */
function hidden(shape) {
  const maker = new GltfMaker();
  maker.show([primitiveOf(maker, shape)]);
  const another = () => ({ primitives: [primitiveOf(maker, shape)] });
  maker.tree.meshes.push(another(), another());
  maker.tree.nodes = [{ mesh: 0 }, { mesh: 1, scale: [0, 0, 0] }, { mesh: 2 }];
  maker.tree.scenes[0].nodes = [0, 1];
  return maker;
}

function levels(shape) {
  const maker = new GltfMaker();
  maker.show([primitiveOf(maker, shape)]);
  maker.tree.meshes.push({ primitives: [primitiveOf(maker, shape)] });
  maker.tree.nodes = [{ mesh: 0, extensions: { MSFT_lod: { ids: [1] } } }, { mesh: 1 }];
  maker.tree.extensionsUsed = ['MSFT_lod'];
  return maker;
}

function batch(shape) {
  const maker = new GltfMaker();
  maker.show([primitiveOf(maker, shape)]);
  const attributes = {
    TRANSLATION: maker.add(Float32Array.of(0, 0, 0, 9, 0, 0, 0, 50, 0), 'VEC3'),
    SCALE: maker.add(Float32Array.of(1, 1, 1, 2, 2, 2, 1, 5, 1), 'VEC3'),
  };
  maker.tree.nodes[0].extensions = { EXT_mesh_gpu_instancing: { attributes } };
  for (const list of ['extensionsUsed', 'extensionsRequired']) {
    maker.tree[list] = ['EXT_mesh_gpu_instancing'];
  }
  return maker;
}

/** The two halves of a surface, which meet, as separate meshes. */
function halves({ positions, triangles }) {
  const maker = new GltfMaker();
  const middle = Math.ceil(triangles.length / 2);
  const pieces = [triangles.slice(0, middle), triangles.slice(middle)];
  const meshes = pieces.filter((own) => own.length > 0).map((own) => ({
    primitives: [primitiveOf(maker, { positions: positions.map(([x, y, z]) => [x - 1, y, z]),
      triangles: own })] }));
  maker.show(meshes[0].primitives);
  Object.assign(maker.tree, { meshes,
    nodes: meshes.map((_, mesh) => ({ mesh, translation: [1, 0, 0] })) });
  maker.tree.scenes[0].nodes = meshes.map((_, i) => i);
  return maker;
}

/** One strip for each triangle, all in one list. */
function restarted(shape) {
  const maker = new GltfMaker();
  const strips = Uint16Array.from(shape.triangles.flatMap((t, i) => (i > 0 ? [65535, ...t] : t)));
  maker.show([{ ...primitiveOf(maker, shape, maker.addIndices(strips)), mode: 5 }]);
  for (const list of ['extensionsUsed', 'extensionsRequired']) {
    maker.tree[list] = ['KHR_mesh_primitive_restart'];
  }
  return maker;
}

function referring(shape) {
  const maker = new GltfMaker();
  const primitive = primitiveOf(maker, shape);
  primitive.attributes._FEATURE_ID_0 =
    maker.add(Float32Array.from(shape.positions, (_, i) => i % 4), 'SCALAR');
  primitive.material = 1;
  primitive.extensions = {
    EXT_mesh_features: { featureIds: [{ featureCount: 4, attribute: 0 }] },
    CESIUM_primitive_outline: { indices: maker.addIndices(Uint16Array.of(0, 1)) },
    ACME_never_heard_of: { triangle: 1 },
    ACME_of_no_number: { kind: 'wall' },
  };
  const [input, output] = [0, 0].map(() => maker.addIndices(Float32Array.of(0, 1)));
  Object.assign(maker.tree.accessors[input], { min: [0], max: [1] });
  const pointer = '/materials/1/pbrMetallicRoughness/roughnessFactor';
  maker.show([primitive]);
  Object.assign(maker.tree, {
    materials: [{ name: 'other' }, { name: 'own' }],
    animations: [{ samplers: [{ input, output }], channels: [{ sampler: 0,
      target: { path: 'pointer', extensions: { KHR_animation_pointer: { pointer } } } }] }],
    extensionsUsed: ['KHR_animation_pointer', ...Object.keys(primitive.extensions)],
  });
  return maker;
}

/** For each kind: writes a surface as a file. */
export const scenes = Object.fromEntries(
  Object.entries({ uneven, hidden, levels, batch, halves, restarted, referring })
    .map(([kind, make]) => [kind, (shape) => make(shape).glb()]));
