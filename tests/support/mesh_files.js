// SPDX-License-Identifier: MIT
// Reads the surfaces in files by itself, byte by byte, so that tests of files need not trust the
// package's own readers: GLB and glTF, OBJ, OFF, PLY (as the package writes it) and binary STL.

/** Faces hold numbers of positions. stored: the positions as a glTF stores them, unplaced.
 * materials: one name for each face, '' for none. objects: names of objects and groups, or of nodes
 * and meshes.
 * @typedef {{ positions: number[][], stored?: number[][], faces: number[][],
 *   materials: string[], objects: string[] }} Surface */

const textOf = (bytes) => Buffer.from(bytes).toString('latin1');

/** Coordinates row by row. @param {ArrayLike<number>} values @returns {number[][]} */
export const rowsOf = (values) => Array.from({ length: values.length / 3 }, (_, i) =>
  [...values.slice(3 * i, 3 * i + 3)]);

/** @returns {Surface} */
function readObj(bytes) {
  const surface = { positions: [], faces: [], materials: [], objects: [] };
  let material = '';
  for (const line of textOf(bytes).split('\n')) {
    const [keyword, ...words] = line.trim().split(/\s+/);
    if (keyword === 'v') surface.positions.push(words.slice(0, 3).map(Number));
    if (keyword === 'o' || keyword === 'g') surface.objects.push(words.join(' '));
    if (keyword === 'usemtl') material = words.join(' ');
    if (keyword !== 'f') continue;
    surface.faces.push(words.map((word) => Number(word.split('/')[0]) - 1));
    surface.materials.push(material);
  }
  return surface;
}

/** @returns {Surface} */
function readOff(bytes) {
  const [kind, counts, ...lines] = textOf(bytes).split('\n');
  const [vertices, faces] = counts.split(' ').map(Number);
  if (!kind.endsWith('OFF')) throw new Error(`an OFF begins with ${kind}`);
  const numbers = lines.map((line) => line.trim().split(/\s+/).map(Number));
  return {
    positions: numbers.slice(0, vertices).map((row) => row.slice(0, 3)),
    faces: numbers.slice(vertices, vertices + faces).map(([count, ...row]) => row.slice(0, count)),
    materials: Array(faces).fill(''), objects: [],
  };
}

const plyTypes = {
  char: ['getInt8', 1], int8: ['getInt8', 1], uchar: ['getUint8', 1], uint8: ['getUint8', 1],
  short: ['getInt16', 2], int16: ['getInt16', 2], ushort: ['getUint16', 2],
  uint16: ['getUint16', 2], int: ['getInt32', 4], int32: ['getInt32', 4], uint: ['getUint32', 4],
  uint32: ['getUint32', 4], float: ['getFloat32', 4], float32: ['getFloat32', 4],
  double: ['getFloat64', 8], float64: ['getFloat64', 8],
};

/** The next number of a type, from text or from bytes. */
function plySource(bytes, isText, isLittle) {
  const words = isText ? textOf(bytes).trim().split(/\s+/) : [];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 0;
  return (type) => {
    if (isText) return Number(words[at++]);
    const [get, size] = plyTypes[type];
    at += size;
    return view[get](at - size, isLittle);
  };
}

/** @returns {Surface} */
function readPly(bytes) {
  const end = textOf(bytes).indexOf('end_header\n') + 'end_header\n'.length;
  const elements = [];
  let format = '';
  for (const line of textOf(bytes.subarray(0, end)).split('\n')) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'format') [, format] = words;
    if (words[0] === 'element') {
      elements.push({ name: words[1], count: Number(words[2]), properties: [] });
    }
    if (words[0] === 'property') elements.at(-1).properties.push(words.slice(1));
  }
  const next = plySource(bytes.subarray(end), format === 'ascii', format.includes('little'));
  const rows = {};
  for (const { name, count, properties } of elements) {
    rows[name] = Array.from({ length: count }, () => Object.fromEntries(properties.map((words) =>
      [words.at(-1), words[0] === 'list'
        ? Array.from({ length: next(words[1]) }, () => next(words[2])) : next(words[0])])));
  }
  return {
    positions: rows.vertex.map(({ x, y, z }) => [x, y, z]),
    faces: rows.face.map((row) => row.vertex_indices ?? row.vertex_index),
    materials: rows.face.map(() => ''), objects: [],
  };
}

/** @returns {Surface} each triangle has corners of its own */
function readStl(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = view.getUint32(80, true);
  const positions = [];
  for (let triangle = 0; triangle < count; ++triangle) {
    for (let number = 3; number < 12; number += 3) {
      positions.push([0, 1, 2].map((k) =>
        view.getFloat32(84 + 50 * triangle + 4 * (number + k), true)));
    }
  }
  return { positions, faces: Array.from({ length: count }, (_, t) => [3 * t, 3 * t + 1, 3 * t + 2]),
    materials: Array(count).fill(''), objects: [] };
}

const numberTypes = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };

/** The numbers of an accessor; rows are not padded where there are three or one each. */
function numbersOf({ bufferViews, accessors }, binary, number) {
  const { bufferView, byteOffset = 0, componentType, count, type } = accessors[number];
  const { byteOffset: start = 0 } = bufferViews[bufferView];
  const length = count * { SCALAR: 1, VEC3: 3 }[type];
  const from = binary.byteOffset + start + byteOffset;
  const Numbers = numberTypes[componentType];
  return new Numbers(binary.buffer.slice(from, from + length * Numbers.BYTES_PER_ELEMENT));
}

/** Triangles with the same first corner, one after the other, are one face. */
function joinedFaces(indices) {
  const faces = [];
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [...indices.slice(i, i + 3)];
    if (i && faces.at(-1)[0] === corners[0]) faces.at(-1).push(corners[2]);
    else faces.push(corners);
  }
  return faces;
}

/** Moves a point by a node's matrix or translation; the tests' files have no other transforms. */
const placed = ({ matrix, translation = [0, 0, 0] }, [x, y, z]) => (matrix
  ? [0, 1, 2].map((k) => matrix[k] * x + matrix[4 + k] * y + matrix[8 + k] * z + matrix[12 + k])
  : [x + translation[0], y + translation[1], z + translation[2]]);

/** @returns {Surface} */
function surfaceOfTree(tree, binary) {
  const surface = { positions: [], stored: [], faces: [], materials: [], objects: [] };
  for (const node of tree.nodes.filter(({ mesh }) => mesh !== undefined)) {
    const { name, primitives } = tree.meshes[node.mesh];
    surface.objects.push(node.name ?? name ?? '');
    for (const { attributes, indices, material, extensions } of primitives) {
      const first = surface.positions.length;
      const points = rowsOf(numbersOf(tree, binary, attributes.POSITION));
      surface.stored.push(...points);
      surface.positions.push(...points.map((point) => placed(node, point)));
      const corners = numbersOf(tree, binary, indices).map((corner) => corner + 0);
      const faces = extensions?.FB_ngon_encoding ? joinedFaces(corners)
        : rowsOf(corners);
      surface.faces.push(...faces.map((face) => face.map((corner) => first + corner)));
      surface.materials.push(...faces.map(() => tree.materials?.[material]?.name ?? ''));
    }
  }
  return surface;
}

/** @returns {Surface} */
function readGlb(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const length = view.getUint32(12, true);
  const tree = JSON.parse(Buffer.from(bytes.subarray(20, 20 + length)).toString());
  return surfaceOfTree(tree, bytes.subarray(20 + length + 8));
}

/**
 * @param {Record<string, Uint8Array>} files the model, and those that it refers to
 * @returns {Surface}
 */
export function readSurface(files) {
  const readers = { glb: readGlb, obj: readObj, off: readOff, ply: readPly, stl: readStl };
  const extensionOf = (name) => name.split('.').at(-1);
  for (const [name, bytes] of Object.entries(files)) {
    if (extensionOf(name) === 'gltf') {
      const tree = JSON.parse(Buffer.from(bytes).toString());
      return surfaceOfTree(tree, files[decodeURIComponent(tree.buffers[0].uri)]);
    }
    const read = readers[extensionOf(name)];
    if (read) return read(bytes);
  }
  throw new Error(`no model among ${Object.keys(files)}`);
}

/** A position in single precision, as text. */
const keyOf = (position) => position.map((x) => Math.fround(x) + 0).join(' ');

/** The distinct positions in single precision, sorted.
 * @param {ArrayLike<number>[]} positions */
export const placesOf = (positions) =>
  [...new Set(Array.from(positions, (position) => keyOf(Array.from(position))))].sort();

/** Every face by the positions of its corners, the least first, and its material, sorted: equal for
 * equal surfaces, however their vertices and faces are numbered.
 * @param {Surface} surface @param {{ hasMaterials?: boolean }} [how] */
export function facesByPlace({ positions, faces, materials }, { hasMaterials = false } = {}) {
  return faces.map((face, i) => {
    const keys = face.map((corner) => keyOf(positions[corner]));
    const least = keys.indexOf([...keys].sort()[0]);
    const turned = [...keys.slice(least), ...keys.slice(0, least)];
    return `${turned.join(', ')}${hasMaterials ? ` ${materials[i]}` : ''}`;
  }).sort();
}

/** The same surface of triangles: each face of more corners is cut from its first corner.
 * @param {Surface} surface @returns {Surface} */
export function triangulated(surface) {
  const cut = surface.faces.flatMap((face, i) => face.slice(2).map((corner, k) =>
    ({ face: [face[0], face[k + 1], corner], material: surface.materials[i] })));
  return { ...surface, faces: cut.map(({ face }) => face),
    materials: cut.map(({ material }) => material) };
}
