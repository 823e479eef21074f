// SPDX-License-Identifier: MIT
// The numbers of a glTF tree: accessors as arrays, and new data in place of theirs.

/** How many numbers an element of an accessor has, by its type. */
export const components = /** @type {Record<string, number>} */ (
  { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 });
const sizes = /** @type {Record<number, number>} */ (
  { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 });

export const float = 5126;

/** Of compressed files: directions in so many bits are off by less than a twentieth of a degree,
 * texture coordinates to such a step by less than a tenth of a texel of 4096. */
export const directionBits = 12, finestTexcoord = 2 ** -16;

/** @param {number} length */
const padded = (length) => Math.ceil(length / 4) * 4;

export class GltfData {
  /** @param {any} tree @param {Uint8Array[]} contents per buffer view; grows */
  constructor(tree, contents) {
    this.tree = tree;
    this.contents = contents;
  }

  /** Whether the numbers of an accessor are all in its buffer view. @param {number} number */
  isPlain(number) {
    const { bufferView, sparse, type, componentType, count } = this.tree.accessors[number];
    return bufferView !== undefined && !sparse && count > 0
      && type in components && componentType in sizes;
  }

  /** @param {number} number */
  widthOf(number) {
    return components[this.tree.accessors[number].type];
  }

  /** Bytes of an element. @param {number} number */
  rowOf(number) {
    return this.widthOf(number) * sizes[this.tree.accessors[number].componentType];
  }

  /**
   * The elements of a plain accessor, each after so many bytes.
   * @param {number} number @param {number} [stride]
   * @returns {Uint8Array<ArrayBuffer>}
   */
  rows(number, stride = this.rowOf(number)) {
    const { bufferView, byteOffset = 0, count } = this.tree.accessors[number];
    const row = this.rowOf(number);
    const step = this.tree.bufferViews[bufferView].byteStride ?? row;
    const bytes = this.contents[bufferView];
    const result = new Uint8Array(count * stride);
    for (let i = 0; i < count; i += 1) {
      const begin = byteOffset + i * step;
      result.set(bytes.subarray(begin, begin + row), i * stride);
    }
    return result;
  }

  /** The numbers of a plain accessor of floats. @param {number} number */
  floats(number) {
    return new Float32Array(this.rows(number).buffer);
  }

  /** Whether it is plain, and of floats. @param {number} number */
  isFloats(number) {
    return this.isPlain(number) && this.tree.accessors[number].componentType === float;
  }

  /**
   * Gives an accessor data of its own.
   * @param {number} number @param {Uint8Array} bytes
   * @param {object} [view] further members of its buffer view
   */
  setRows(number, bytes, view = {}) {
    const accessor = this.tree.accessors[number];
    const { target } = this.tree.bufferViews[accessor.bufferView] ?? {};
    accessor.bufferView = this.addView(bytes, { ...(target ? { target } : {}), ...view });
    delete accessor.byteOffset;
  }

  /** @param {Uint8Array} bytes @param {object} [view] @returns {number} */
  addView(bytes, view = {}) {
    this.contents.push(bytes);
    return this.tree.bufferViews.push({ buffer: 0, ...view }) - 1;
  }

  /** Floats in place of those that it has, with their bounds if it states any.
   * @param {number} number @param {Float32Array} values */
  setFloats(number, values) {
    const accessor = this.tree.accessors[number];
    const width = this.widthOf(number);
    const bounds = (/** @type {(a: number, b: number) => number} */ pick) =>
      Array.from({ length: width }, (_, k) => {
        let result = values[k];
        for (let i = k; i < values.length; i += width) result = pick(result, values[i]);
        return result;
      });
    if (accessor.min) accessor.min = bounds(Math.min);
    if (accessor.max) accessor.max = bounds(Math.max);
    const { byteStride } = this.tree.bufferViews[accessor.bufferView];
    this.setRows(number, new Uint8Array(values.buffer),
      byteStride ? { byteStride: padded(4 * width) } : {});
  }

  /** All primitives of all meshes. @returns {any[]} */
  primitives() {
    return (this.tree.meshes ?? []).flatMap((/** @type {any} */ mesh) => mesh.primitives);
  }

  /** @param {string} name @param {'extensionsUsed' | 'extensionsRequired'} [list] */
  #declare(name, list = 'extensionsUsed') {
    const names = (this.tree[list] ??= []);
    if (!names.includes(name)) names.push(name);
  }

  /** Declares an extension that readers need. @param {string} name */
  require(name) {
    this.#declare(name);
    this.#declare(name, 'extensionsRequired');
  }
}

/** Calls `visit` with each object that names a buffer view. @param {any} value
 * @param {(holder: { bufferView: number }) => void} visit */
function forEachHolder(value, visit) {
  const waiting = [value];
  for (const one of waiting) {
    if (typeof one !== 'object' || one === null) continue;
    if (Number.isInteger(one.bufferView)) visit(one);
    for (const member of Object.values(one)) if (typeof member === 'object') waiting.push(member);
  }
}

/** Extensions that name buffer views in other ways. */
const hidden = ['EXT_structural_metadata', 'EXT_feature_metadata'];

/** Takes out the buffer views that nothing names. @param {GltfData} data */
export function dropUnusedViews(data) {
  const { tree } = data;
  if (hidden.some((name) => tree.extensionsUsed?.includes(name))) return;
  /** @type {Set<number>} */
  const used = new Set();
  forEachHolder({ ...tree, bufferViews: [] }, ({ bufferView }) => used.add(bufferView));
  const kept = [...tree.bufferViews.keys()].filter((view) => used.has(view));
  const numbers = new Map(kept.map((view, i) => [view, i]));
  forEachHolder({ ...tree, bufferViews: [] }, (holder) => {
    holder.bufferView = numbers.get(holder.bufferView) ?? holder.bufferView;
  });
  tree.bufferViews = kept.map((view) => tree.bufferViews[view]);
  data.contents = kept.map((view) => data.contents[view]);
}
