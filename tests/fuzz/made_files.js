// SPDX-License-Identifier: MIT
// Surfaces as files of every format and kind: { name, bytes, resources }. All other attributes are
// computed from the positions, so that any surface can be any file.
import { GltfMaker } from '../support/gltf.js';
import { scans } from './made_scans.js';

const encode = (text) => new TextEncoder().encode(text);
const flat = (lists) => lists.flat();

/** A planar texture, and normals that point away from the origin. */
const texcoordsOf = ({ positions }) => Float32Array.from(flat(positions.map(([x, y]) => [x, y])));
const normalsOf = ({ positions }) => Float32Array.from(flat(positions.map((p) => {
  const length = Math.hypot(...p);
  return length > 0 ? p.map((x) => x / length) : [0, 0, 1];
})));

/** Every vertex has weight one half for one of three joints and one half for the next. */
const jointsOf = ({ positions }) => Uint8Array.from(flat(positions.map((_, i) =>
  [i % 3, (i + 1) % 3, 0, 0])));
const weightsOf = ({ positions }) => Float32Array.from(flat(positions.map(() => [0.5, 0.5, 0, 0])));

const indicesOf = ({ triangles }) => Uint16Array.from(flat(triangles));
const rounded = (values, Kind, one) => Kind.from(values, (x) =>
  Math.round(Math.max(-1, Math.min(1, x)) * one));

function plain(shape) {
  const maker = new GltfMaker();
  const primitive = {
    attributes: { POSITION: maker.add(Float32Array.from(flat(shape.positions)), 'VEC3') },
    indices: maker.addIndices(indicesOf(shape)),
  };
  return { maker: maker.show([primitive]), primitive };
}

function textured(shape) {
  const { maker, primitive } = plain(shape);
  primitive.attributes.TEXCOORD_0 = maker.add(texcoordsOf(shape), 'VEC2');
  primitive.attributes.NORMAL = maker.add(normalsOf(shape), 'VEC3');
  maker.tree.materials = [{ name: 'paint' }];
  primitive.material = 0;
  return maker;
}

function quantized(shape) {
  const maker = new GltfMaker();
  const attributes = {
    POSITION: maker.add(rounded(flat(shape.positions).map((x) => x / 4), Int16Array, 32767),
      'VEC3', { normalized: true }),
    NORMAL: maker.add(rounded(normalsOf(shape), Int8Array, 127), 'VEC3', { normalized: true }),
    COLOR_0: maker.add(Uint8Array.from(flat(shape.positions.map((_, i) => [i % 256, 255, 0, 255]))),
      'VEC4', { normalized: true }),
    TEXCOORD_0: maker.add(rounded(texcoordsOf(shape).map(Math.abs), Uint16Array, 65535), 'VEC2',
      { normalized: true }),
  };
  Object.assign(maker.tree, { extensionsUsed: ['KHR_mesh_quantization'],
    extensionsRequired: ['KHR_mesh_quantization'] });
  return maker.show([{ attributes, indices: maker.addIndices(indicesOf(shape)) }]);
}

function skinned(shape) {
  const { maker, primitive } = plain(shape);
  primitive.attributes.JOINTS_0 = maker.add(jointsOf(shape), 'VEC4');
  primitive.attributes.WEIGHTS_0 = maker.add(weightsOf(shape), 'VEC4');
  maker.tree.nodes = [{ mesh: 0, skin: 0 }, { translation: [0, 0, 1], children: [2, 3] },
    { rotation: [0, 0, 0.6, 0.8] }, { scale: [2, 2, 2] }];
  maker.tree.scenes[0].nodes = [0, 1];
  maker.tree.skins = [{ joints: [1, 2, 3] }];
  return maker;
}

function sparse(shape) {
  const { maker, primitive } = plain(shape);
  const colors = new Float32Array(3 * shape.positions.length).fill(0.5);
  primitive.attributes.COLOR_0 = maker.add(colors, 'VEC3');
  const accessor = maker.tree.accessors[primitive.attributes.COLOR_0];
  const componentType = 5123;
  [accessor.min, accessor.max] = [[0, 0.5, 0.5], [0.5, 0.5, 1]];
  accessor.sparse = {
    count: 2,
    indices: { bufferView: maker.addView(Uint16Array.of(0, 2)), componentType },
    values: { bufferView: maker.addView(Float32Array.of(0, 0.5, 0.5, 0.5, 0.5, 1)) },
  };
  return maker;
}

function morphing(shape) {
  const { maker, primitive } = plain(shape);
  primitive.attributes.NORMAL = maker.add(normalsOf(shape), 'VEC3');
  const pushed = Float32Array.from(flat(shape.positions.map(([x]) => [0, 0, x / 10])));
  primitive.targets = [{ POSITION: maker.add(pushed, 'VEC3') },
    { POSITION: maker.add(pushed.map((x) => -x), 'VEC3'), NORMAL: maker.add(pushed, 'VEC3') }];
  maker.tree.meshes[0].weights = [0.5, 0];
  return maker;
}

/** Two halves, each with a material, shown twice. */
function instanced(shape) {
  const { maker, primitive } = plain(shape);
  const half = Math.ceil(shape.triangles.length / 2);
  const parts = [shape.triangles.slice(0, half), shape.triangles.slice(half)]
    .filter((triangles) => triangles.length > 0);
  maker.tree.materials = [{ name: 'left' }, { name: 'right' }];
  maker.show(parts.map((triangles, material) =>
    ({ ...primitive, indices: maker.addIndices(indicesOf({ triangles })), material })));
  maker.tree.nodes.push({ mesh: 0, translation: [5, 0, 0], scale: [-1, 2, 1] });
  maker.tree.scenes[0].nodes.push(1);
  return maker;
}

function objText(shape, { positions, triangles } = shape) {
  const lines = ['mtllib made.mtl', 'o made', 'usemtl paint'];
  const normals = normalsOf(shape);
  positions.forEach((p, i) => lines.push(`v ${p.join(' ')}`, `vt ${p[0]} ${p[1]}`,
    `vn ${[...normals.subarray(3 * i, 3 * i + 3)].join(' ')}`));
  triangles.forEach((t) => lines.push(`f ${t.map((v) => `${v + 1}/${v + 1}/${v + 1}`).join(' ')}`));
  return `${lines.join('\n')}\n`;
}

function offText({ positions, triangles }, keyword, extra) {
  return [keyword, `${positions.length} ${triangles.length} 0`,
    ...positions.map((p) => [...p, ...extra].join(' ')),
    ...triangles.map((t) => `3 ${t.join(' ')}`), ''].join('\n');
}

const library = encode('newmtl paint\nKd 1 0 0\nmap_Kd made.png\n');

/** For each kind: writes a surface as a file. */
export const files = {
  plain: (shape) => plain(shape).maker.glb(),
  textured: (shape) => textured(shape).glb(),
  beside: (shape) => textured(shape).gltf(),
  embedded: (shape) => textured(shape).embedded(),
  quantized: (shape) => quantized(shape).glb(),
  skinned: (shape) => skinned(shape).glb(),
  sparse: (shape) => sparse(shape).glb(),
  morphing: (shape) => morphing(shape).glb(),
  instanced: (shape) => instanced(shape).glb(),
  obj: (shape) => ({ name: 'made.obj', bytes: encode(objText(shape)),
    resources: { 'made.mtl': library } }),
  off: (shape) => ({ name: 'made.off', bytes: encode(offText(shape, 'OFF', [])) }),
  'off with colours': (shape) =>
    ({ name: 'made.off', bytes: encode(offText(shape, 'COFF', [255, 0, 0, 255])) }),
  ...scans,
};

/** A surface as arrays. */
export function meshOf(shape) {
  return {
    positions: Float32Array.from(flat(shape.positions)),
    indices: Uint32Array.from(flat(shape.triangles)),
    attributes: {
      TEXCOORD_0: { array: texcoordsOf(shape), itemSize: 2 },
      NORMAL: { array: normalsOf(shape), itemSize: 3 },
    },
  };
}
