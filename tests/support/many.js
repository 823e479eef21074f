// SPDX-License-Identifier: MIT
// Files that have many of one thing, and little of anything else.

const encode = (text) => new TextEncoder().encode(text);
const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
const faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
const numbers = (n) => Array.from({ length: n }, (_, i) => i);

const data = new Uint8Array(72);
data.set(new Uint8Array(Float32Array.from(corners.flat()).buffer));
data.set(new Uint8Array(Uint16Array.from(faces.flat()).buffer), 48);
const buffer = { byteLength: 72,
  uri: `data:application/octet-stream;base64,${Buffer.from(data).toString('base64')}` };
const views = (number) => [{ buffer: number, byteOffset: 0, byteLength: 48 },
  { buffer: number, byteOffset: 48, byteLength: 24 }];

/** Accessors of a tetrahedron in the views from this one on. */
const accessors = (view) => [
  { bufferView: view, componentType: 5126, type: 'VEC3', count: 4, min: [0, 0, 0], max: [1, 1, 1] },
  { bufferView: view + 1, componentType: 5123, type: 'SCALAR', count: 12 }];

/** The primitive of the nth pair of accessors. */
const primitive = (n, material) => ({ attributes: { POSITION: 2 * n }, indices: 2 * n + 1,
  ...(material === undefined ? {} : { material }) });

function gltf(parts, resources = {}) {
  const tree = { asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }], meshes: [{ primitives: [primitive(0)] }], accessors: accessors(0),
    bufferViews: views(0), buffers: [buffer], ...parts };
  return { name: 'many.gltf', bytes: encode(JSON.stringify(tree)), resources };
}

const meshesOf = (n) => ({
  meshes: numbers(n).map((i) => ({ name: `m${i}`, primitives: [primitive(i)] })),
  accessors: numbers(n).flatMap(() => accessors(0)),
  nodes: numbers(n).map((i) => ({ mesh: i, translation: [2 * i, 0, 0] })),
  scenes: [{ nodes: numbers(n) }],
});

function objOf(n) {
  const lines = numbers(n).flatMap((i) => [`o o${i}`, `g g${i}`, `usemtl m${i}`,
    ...corners.map(([x, y, z]) => `v ${x + 2 * i} ${y} ${z}`),
    ...faces.map((face) => `f ${face.map((v) => v + 1 + 4 * i).join(' ')}`)]);
  return `${lines.join('\n')}\n`;
}

const obj = (text, resources = {}) => ({ name: 'many.obj', bytes: encode(text), resources });

/** By what there is much of: a file with n of it. */
export const many = {
  'nodes in a chain': (n) => gltf({ nodes: numbers(n).map((i) => ({ translation: [0.001, 0, 0],
    ...(i + 1 < n ? { children: [i + 1] } : { mesh: 0 }) })) }),
  'meshes': (n) => gltf(meshesOf(n)),
  'instances': (n) => gltf({ scenes: [{ nodes: numbers(n) }],
    nodes: numbers(n).map((i) => ({ mesh: 0, translation: [2 * i, 0, 0] })) }),
  'materials': (n) => gltf({
    materials: numbers(n).map((i) => ({ name: `m${i}`, pbrMetallicRoughness: {
      baseColorFactor: [i / n, 0, 0, 1] } })),
    meshes: [{ primitives: numbers(n).map((i) => primitive(0, i)) }] }),
  'primitives': (n) => gltf({ accessors: numbers(n).flatMap(() => accessors(0)),
    meshes: [{ primitives: numbers(n).map((i) => primitive(i)) }] }),
  'buffers': (n) => gltf({ buffers: numbers(n).map(() => buffer),
    bufferViews: numbers(n).flatMap(views),
    accessors: numbers(n).flatMap((i) => accessors(2 * i)),
    meshes: [{ primitives: numbers(n).map((i) => primitive(i)) }] }),
  'images': (n) => gltf({ images: numbers(n).map((i) => ({ uri: `i${i}.png` })) },
    Object.fromEntries(numbers(n).map((i) => [`i${i}.png`, encode(`\x89PNG ${i}`)]))),
  'animated nodes': (n) => {
    const meshes = meshesOf(n);
    return gltf({ ...meshes,
      accessors: [...meshes.accessors,
        { componentType: 5126, type: 'SCALAR', count: 1, min: [0], max: [0] },
        { componentType: 5126, type: 'VEC3', count: 1 }],
      animations: [{ samplers: [{ input: 2 * n, output: 2 * n + 1 }],
        channels: numbers(n).map((node) => ({ sampler: 0, target: { node, path: 'scale' } })) }] });
  },
  'objects of an OBJ': (n) => obj(objOf(n)),
  'materials of an OBJ': (n) => obj(`mtllib a.mtl\n${objOf(n)}`, { 'a.mtl': encode(
    numbers(n).map((i) => `newmtl m${i}\nKd ${i / n} 0 0\n`).join('')) }),
  'libraries of an OBJ': (n) => obj(numbers(n).map((i) => `mtllib a${i}.mtl\n`).join('') + objOf(n),
    Object.fromEntries(numbers(n).map((i) => [`a${i}.mtl`, encode(`newmtl m${i}\nKd 1 0 0\n`)]))),
  'normals at one vertex': (n) => {
    const rim = numbers(8 * n).map((i) => 2 * Math.PI * i / (8 * n))
      .map((angle) => [Math.cos(angle), Math.sin(angle)]);
    return obj(['v 0 0 1', ...rim.flatMap(([x, y]) => [`v ${x} ${y} 0`, `vn ${x} ${y} .5`]),
      ...rim.map((_, i) => ['f', 1, i + 2, (i + 1) % rim.length + 2].join(' ')
        .replace(/ \d+/g, (vertex) => `${vertex}//${i + 1}`)),
      ''].join('\n'));
  },
  'solids of an STL': (n) => ({ name: 'many.stl', resources: {}, bytes: encode(
    `${numbers(n).flatMap((i) => [`solid s${i}`, ...faces.flatMap((face) => ['facet normal 0 0 0',
      'outer loop', ...face.map((v) => `vertex ${corners[v][0] + 2 * i} ${corners[v][1]} ${
        corners[v][2]}`), 'endloop', 'endfacet']), `endsolid s${i}`]).join('\n')}\n`) }),
};
