// SPDX-License-Identifier: MIT
// A GLB with fewer triangles, spread evenly over its surfaces, on no more vertices than they need:
// a screen cannot show more. The surfaces of the file itself are sent on request.
import { glbOf, openGlb } from '../files/glb.js';
import { fewerTriangles } from '../triangles/fewer_triangles.js';

/** A surface of the file, three numbers a vertex and three vertices a triangle.
 * @typedef {{ positions: Float32Array, corners: Uint32Array }} Whole */
/** kept: the vertices that are drawn, by their numbers in the file; vertices: of the file.
 * @typedef {{ kept: Uint32Array, vertices: number }} Kept */
/** The number of drawn triangles, and of all. @typedef {{ shown: number, all: number }} Thinned */

const triangles = 4;  // a primitive's mode
const [float, word] = [5126, 5125];
const kinds = /** @type {Record<number, any>} */ ({ 5120: Int8Array, 5121: Uint8Array,
  5122: Int16Array, 5123: Uint16Array, [word]: Uint32Array, [float]: Float32Array });
const widths = /** @type {Record<string, number>} */ ({ SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 });

/** Extensions under which the data are elsewhere, or a mesh is in more places than its nodes. */
const packed = /compression|draco|instancing/i;

/** The primitives of a mesh that are triangles. @param {any} mesh @returns {any[]} */
const surfacesIn = ({ primitives }) =>
  primitives.filter((/** @type {any} */ { mode = triangles }) => mode === triangles);

/** How many triangles a scene has, and whether they can be thinned out.
 * @param {any} tree */
export function countIn({ nodes = [], meshes = [], accessors = [], extensionsUsed = [],
  buffers = [] }) {
  const places = new Array(meshes.length).fill(0);
  for (const { mesh } of nodes) if (mesh !== undefined) places[mesh] += 1;
  let all = 0;
  for (const [i, mesh] of meshes.entries()) {
    for (const { indices, attributes } of surfacesIn(mesh)) {
      all += places[i] * Math.floor((accessors[indices ?? attributes.POSITION]?.count ?? 0) / 3);
    }
  }
  const isOther = (/** @type {any} */ { mode = triangles }) => mode > triangles;
  const isPlain = !meshes.some((/** @type {any} */ { primitives }) => primitives.some(isOther))
    && !extensionsUsed.some((/** @type {string} */ name) => packed.test(name))
    && !accessors.some((/** @type {any} */ { sparse, bufferView }) => sparse
      || bufferView === undefined)
    && buffers.length === 1 && buffers[0].uri === undefined;
  return { all, places, isPlain };
}

/** Reads accessors, and collects the contents of a smaller file. */
class Editor {
  /** @type {Uint8Array[]} */
  pieces = [];
  #length = 0;

  /** @param {any} tree changed in place @param {Uint8Array} binary */
  constructor(tree, binary) {
    this.tree = tree;
    this.binary = binary;
  }

  /** @param {number} index of an accessor */
  #layout(index) {
    const accessor = this.tree.accessors[index];
    const view = this.tree.bufferViews[accessor.bufferView];
    const Kind = kinds[accessor.componentType];
    const width = widths[accessor.type];
    const bytes = width * Kind.BYTES_PER_ELEMENT;
    const at = this.binary.byteOffset + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    return { accessor, Kind, width, bytes, at, stride: view.byteStride ?? bytes };
  }

  /** The values of an accessor, as they are stored. @param {number} index */
  valuesOf(index) {
    const { accessor: { count }, Kind, width, bytes, at, stride } = this.#layout(index);
    const { buffer } = this.binary;
    if (stride === bytes && at % Kind.BYTES_PER_ELEMENT === 0) {
      return new Kind(buffer, at, count * width);
    }
    const values = new Uint8Array(count * bytes);
    for (let i = 0; i < count; ++i) {
      values.set(new Uint8Array(buffer, at + i * stride, bytes), i * bytes);
    }
    return new Kind(values.buffer);
  }

  /** The same as numbers of single precision. @param {number} index @returns {Float32Array} */
  numbersOf(index) {
    const values = this.valuesOf(index);
    if (values instanceof Float32Array) return values;
    const { accessor: { normalized }, Kind } = this.#layout(index);
    const most = 2 ** (8 * Kind.BYTES_PER_ELEMENT - (Kind.name.startsWith('I') ? 1 : 0)) - 1;
    return Float32Array.from(values, (x) => (normalized ? Math.max(-1, x / most) : x));
  }

  /** @param {Uint8Array} piece @param {number} [byteStride] @returns {number} its view */
  #add(piece, byteStride) {
    const whole = new Uint8Array(piece.length + (-piece.length & 3));
    whole.set(piece);
    this.pieces.push(whole);
    this.#length += whole.length;
    return this.tree.bufferViews.push({ buffer: 0, byteOffset: this.#length - whole.length,
      byteLength: piece.length, ...(byteStride ? { byteStride } : {}) }) - 1;
  }

  /** @param {Float32Array | Uint32Array} values @param {object} accessor the rest of it */
  addArray(values, accessor) {
    const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
    return this.tree.accessors.push({ bufferView: this.#add(bytes), ...accessor }) - 1;
  }

  /** An accessor of some of another's elements. @param {number} index @param {Uint32Array} kept */
  addSome(index, kept) {
    const { accessor, bytes, at, stride } = this.#layout(index);
    const step = bytes + (-bytes & 3);
    const from = new Uint8Array(this.binary.buffer, at);
    const some = new Uint8Array(step * kept.length);
    for (let i = 0; i < kept.length; ++i) {
      for (let k = 0; k < bytes; ++k) some[i * step + k] = from[kept[i] * stride + k];
    }
    return this.tree.accessors.push({ ...accessor, byteOffset: 0, count: kept.length,
      bufferView: this.#add(some, step) }) - 1;
  }

  /** The file: of the old views only those that are still used. */
  close() {
    const { tree, binary } = this;
    const used = new Set();
    const use = (/** @type {number | undefined} */ accessor) =>
      accessor !== undefined && used.add(tree.accessors[accessor].bufferView);
    for (const { primitives } of tree.meshes) {
      for (const { indices, attributes, targets = [] } of primitives) {
        for (const one of [{ indices }, attributes, ...targets]) Object.values(one).forEach(use);
      }
    }
    for (const { inverseBindMatrices } of tree.skins ?? []) use(inverseBindMatrices);
    for (const { samplers } of tree.animations ?? []) {
      for (const { input, output } of samplers) [input, output].forEach(use);
    }
    for (const { bufferView } of tree.images ?? []) used.add(bufferView);
    const added = this.pieces.length;
    for (const [i, view] of tree.bufferViews.entries()) {
      if (i >= tree.bufferViews.length - added) break;
      const { byteOffset = 0, byteLength } = view;
      const bytes = used.has(i) ? binary.subarray(byteOffset, byteOffset + byteLength)
        : new Uint8Array();
      const whole = new Uint8Array(bytes.length + (-bytes.length & 3));
      whole.set(bytes);
      this.pieces.push(whole);
      Object.assign(view, { byteOffset: this.#length, byteLength: bytes.length });
      this.#length += whole.length;
    }
    tree.buffers = [{ byteLength: this.#length }];
    return glbOf(tree, this.pieces);
  }
}

/** The vertices that triangles use, in order, and the triangles by their numbers among these.
 * @param {Uint32Array} drawn @param {number} vertices */
function compacted(drawn, vertices) {
  const numbers = new Uint32Array(vertices);
  for (const v of drawn) numbers[v] = 1;
  let count = 0;
  for (let v = 0; v < vertices; ++v) numbers[v] = numbers[v] ? count++ : -1;
  const kept = new Uint32Array(count);
  for (let v = 0; v < vertices; ++v) if (numbers[v] !== 2 ** 32 - 1) kept[numbers[v]] = v;
  return { kept, corners: drawn.map((v) => numbers[v]) };
}

/** @param {Uint32Array} kept @param {Float32Array} values three each */
function those(kept, values) {
  const some = new Float32Array(3 * kept.length);
  for (let i = 0; i < kept.length; ++i) {
    for (let k = 0; k < 3; ++k) some[3 * i + k] = values[3 * kept[i] + k];
  }
  return some;
}

/** @param {Uint8Array | Uint16Array | Uint32Array} indices */
const words = (indices) =>
  (indices instanceof Uint32Array ? indices : Uint32Array.from(indices));

/** Gives a primitive fewer triangles. @param {Editor} editor @param {any} primitive
 * @param {{ share: number, number: number }} how number: of the surface
 * @returns {Promise<{ whole: Whole, kept: Kept, drawn: number }>} */
async function thinOne(editor, primitive, { share, number }) {
  const { attributes, indices, targets = [] } = primitive;
  const positions = editor.numbersOf(attributes.POSITION);
  const vertices = positions.length / 3;
  const corners = indices === undefined ? Uint32Array.from({ length: vertices }, (_, i) => i)
    : words(editor.valuesOf(indices));
  const { drawn, normals } = await fewerTriangles({ positions, corners,
    wanted: 3 * Math.ceil((corners.length / 3) * share),
    needsNormals: attributes.NORMAL === undefined });
  const few = compacted(drawn, vertices);
  for (const list of [attributes, ...targets]) {
    for (const name of Object.keys(list)) list[name] = editor.addSome(list[name], few.kept);
  }
  if (normals) {
    attributes.NORMAL = editor.addArray(those(few.kept, normals),
      { componentType: float, count: few.kept.length, type: 'VEC3' });
  }
  primitive.indices = editor.addArray(few.corners,
    { componentType: word, count: few.corners.length, type: 'SCALAR' });
  delete primitive.extensions?.FB_ngon_encoding;  // the triangles are others
  primitive.extras = { ...Object(primitive.extras), whole: number };
  return { whole: { positions, corners }, kept: { kept: few.kept, vertices },
    drawn: drawn.length / 3 };
}

/**
 * @param {Uint8Array} glb of which `countIn` says that it can be thinned out
 * @param {number} most drawn triangles in all
 * @returns {Promise<{ bytes: Uint8Array<ArrayBuffer>, thinned: Thinned, parts: Kept[],
 *   wholes: Whole[] }>} parts, wholes: by the numbers that are in the primitives' extras
 */
export async function thinnedGlb(glb, most) {
  const { tree, binary } = openGlb(glb);
  const editor = new Editor(tree, binary);
  const { all, places } = countIn(tree);
  const parts = [], wholes = [];
  let shown = 0;
  for (const [i, mesh] of tree.meshes.entries()) {
    for (const primitive of surfacesIn(mesh)) {
      const { whole, kept, drawn } = await thinOne(editor, primitive,
        { share: most / all, number: wholes.length });
      wholes.push(whole);
      parts.push(kept);
      shown += drawn * places[i];
    }
  }
  return { bytes: editor.close(), thinned: { shown, all }, parts, wholes };
}
