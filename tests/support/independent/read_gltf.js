// SPDX-License-Identifier: MIT
// Reads the triangles of glTF and GLB, without the engine: nodes with their transforms, accessors
// (sparse, normalized), strips and fans, quads by FB_ngon_encoding, levels of detail by MSFT_lod.

const readers = { 5120: ['getInt8', 1, 127], 5121: ['getUint8', 1, 255],
  5122: ['getInt16', 2, 32767], 5123: ['getUint16', 2, 65535], 5125: ['getUint32', 4, 1],
  5126: ['getFloat32', 4, 1] };
const widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

const unread = ['KHR_draco_mesh_compression', 'EXT_meshopt_compression',
  'KHR_meshopt_compression', 'EXT_mesh_gpu_instancing'];

/** @param {Uint8Array} bytes @param {Record<string, Uint8Array>} resources */
function open(bytes, resources) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const isBinary = view.getUint32(0, true) === 0x46546c67;
  const length = isBinary ? view.getUint32(12, true) : bytes.length;
  const start = isBinary ? 20 : 0;
  const tree = JSON.parse(new TextDecoder().decode(bytes.subarray(start, start + length)));
  const chunk = isBinary ? bytes.subarray(start + length + 8) : undefined;
  const buffers = (tree.buffers ?? []).map(({ uri, byteLength }) => {
    if (uri === undefined) return chunk.subarray(0, byteLength);
    if (uri.startsWith('data:')) return Buffer.from(uri.slice(uri.indexOf(',') + 1), 'base64');
    const file = resources[decodeURIComponent(uri)] ?? resources[uri];
    if (!file) throw new Error(`the file ${uri} is missing`);
    return file;
  });
  const names = (tree.extensionsUsed ?? []).filter((name) => unread.includes(name));
  if (names.length > 0) throw new Error(`${names} cannot be read`);
  return { tree, buffers };
}

function numbersOf({ tree, buffers }, place, { componentType, count, width, normalized }) {
  const values = new Float64Array(count * width);
  if (place.bufferView === undefined) return values;
  const { buffer, byteOffset = 0, byteStride } = tree.bufferViews[place.bufferView];
  const bytes = buffers[buffer];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [read, size, one] = readers[componentType];
  const stride = byteStride ?? size * width;
  const start = byteOffset + (place.byteOffset ?? 0);
  for (let i = 0; i < values.length; i += 1) {
    const at = start + Math.floor(i / width) * stride + (i % width) * size;
    const value = view[read](at, true);
    values[i] = normalized ? Math.max(-1, value / one) : value;
  }
  return values;
}

/** The values of an accessor. */
function valuesOf(opened, number) {
  const accessor = opened.tree.accessors[number];
  const width = widths[accessor.type];
  const { componentType, count, normalized, sparse } = accessor;
  const values = numbersOf(opened, accessor, { componentType, count, width, normalized });
  if (!sparse) return values;
  const rows = numbersOf(opened, sparse.indices,
    { componentType: sparse.indices.componentType, count: sparse.count, width: 1 });
  const changed = numbersOf(opened, sparse.values,
    { componentType, count: sparse.count, width, normalized });
  rows.forEach((row, i) =>
    values.set(changed.subarray(i * width, (i + 1) * width), row * width));
  return values;
}

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** a · b of matrices by columns. */
const product = (a, b) => Array.from({ length: 16 }, (_, i) => {
  const [column, row] = [i >> 2, i & 3];
  return [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + row] * b[4 * column + k], 0);
});

/** @param {any} node @returns {number[]} its matrix by columns */
export function matrixOf({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1],
  scale = [1, 1, 1] }) {
  if (matrix) return matrix;
  const [x, y, z, w] = rotation;
  const turn = [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),
    2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
    2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)];
  const column = (k) => [0, 1, 2].map((i) => turn[3 * k + i] * scale[k]);
  return [...column(0), 0, ...column(1), 0, ...column(2), 0, ...translation, 1];
}

const isIdentity = (matrix) => matrix.every((value, i) => value === identity[i]);

/** The positions in the world. Without a transform not a bit changes. */
function moved(positions, m) {
  if (isIdentity(m)) return positions;
  return positions.map((_, i) => {
    const [p, k] = [i - (i % 3), i % 3];
    return m[k] * positions[p] + m[4 + k] * positions[p + 1] + m[8 + k] * positions[p + 2]
      + m[12 + k];
  });
}

/** Faces of a list of corners, by the primitive's mode; the restart value ends a strip. */
function facesOf(corners, mode) {
  const faces = [];
  if (mode === 4) {
    for (let i = 0; i + 2 < corners.length; i += 3) faces.push([...corners.slice(i, i + 3)]);
    return faces;
  }
  let first = 0;
  for (let i = 0; i < corners.length; i += 1) {
    if (corners[i] === 65535 || corners[i] === 2 ** 32 - 1) first = i + 1;
    else if (i >= first + 2 && mode === 6) faces.push([corners[first], corners[i - 1], corners[i]]);
    else if (i >= first + 2) {
      faces.push((i - first) % 2 === 0 ? [corners[i - 2], corners[i - 1], corners[i]]
        : [corners[i - 1], corners[i - 2], corners[i]]);
    }
  }
  return faces;
}

/** Successive triangles that begin at the same vertex are one polygon. */
function polygons(triangles) {
  const faces = [];
  for (const [a, b, c] of triangles) {
    const last = faces.at(-1);
    if (last && last[0] === a && last.at(-1) === b) last.push(c);
    else faces.push([a, b, c]);
  }
  return faces;
}

function primitivePart(opened, primitive, name) {
  const positions = valuesOf(opened, primitive.attributes.POSITION);
  const corners = primitive.indices === undefined
    ? Array.from({ length: positions.length / 3 }, (_, i) => i)
    : Array.from(valuesOf(opened, primitive.indices));
  const triangles = facesOf(corners, primitive.mode ?? 4);
  const isNgon = primitive.extensions?.FB_ngon_encoding !== undefined;
  return { name, positions, faces: isNgon ? polygons(triangles) : triangles,
    material: primitive.material };
}

/** A mirrored part's faces are turned, as every viewer turns them. */
function placed(part, matrix, node) {
  const [a, b, c, , d, e, f, , g, h, i] = matrix;
  const isMirrored = a * (e * i - f * h) - d * (b * i - c * h) + g * (b * f - c * e) < 0;
  return { ...part, node, local: part.positions, positions: moved(part.positions, matrix),
    isMoved: !isIdentity(matrix),
    faces: isMirrored ? part.faces.map((face) => [face[0], ...face.slice(1).reverse()])
      : part.faces };
}

/**
 * The parts that the scene shows, a primitive of a node each, in the world; and in `levels` the
 * parts of the coarser levels of detail, the finer first. See figures.js for `holds`.
 * @param {Uint8Array} bytes @param {Record<string, Uint8Array>} [resources]
 */
export function readGltf(bytes, resources = {}) {
  const opened = open(bytes, resources);
  const { tree } = opened;
  const shown = { parts: [], levels: [] };
  const partsOf = (node, number, matrix) =>
    (tree.meshes[node.mesh]?.primitives ?? []).filter(({ mode = 4 }) => mode >= 4)
      .map((primitive, i) => ({ mesh: node.mesh, ...placed(
        primitivePart(opened, primitive, `${tree.meshes[node.mesh].name ?? node.mesh}/${i}`),
        matrix, number) }));
  const visit = (number, above, into) => {
    const node = tree.nodes[number];
    const matrix = product(above, matrixOf(node));
    into.push(...partsOf(node, number, matrix));
    (node.extensions?.MSFT_lod?.ids ?? []).forEach((id, level) => {
      shown.levels[level] ??= [];
      visit(id, above, shown.levels[level]);
    });
    for (const child of node.children ?? []) visit(child, matrix, into);
  };
  const scene = tree.scenes?.[tree.scene ?? 0];
  const primitives = (tree.meshes ?? []).flatMap((mesh) => mesh.primitives);
  const isMaterial = primitives.some(({ material }) => material !== undefined);
  const holds = new Set([...primitives.flatMap(({ attributes }) => Object.keys(attributes)),
    ...(isMaterial ? ['materials', 'looks'] : [])]);
  holds.delete('POSITION');
  const roots = scene?.nodes ?? (tree.nodes ?? []).map((_, i) => i);
  for (const number of roots) visit(number, identity, shown.parts);
  return { ...shown, holds };
}
