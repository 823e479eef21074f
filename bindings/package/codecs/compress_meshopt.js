// SPDX-License-Identifier: MIT
// EXT_meshopt_compression: each accessor becomes a compressed buffer view of its own. Triangles,
// vertices and their order stay; where primitives are quads, so do the first corners.

import { directionBits, finestTexcoord } from './gltf_data.js';
import { gridOf, roundPositions } from './rounded_positions.js';

/** @typedef {import('./gltf_data.js').GltfData} GltfData */

const extension = 'EXT_meshopt_compression';
const short = 5122;
const [unsignedByte, unsignedShort, unsignedInt] = [5121, 5123, 5125];

// Larger texture coordinates are left as they are: multiples of the finest step would need more
// bits.
const largestTexcoord = 64;

/** What accessors are for, by their numbers. @typedef {{ semantic: string, isTarget: boolean }}
 *   Role */

/** @param {GltfData} data @returns {Map<number, Role>} */
function rolesOf(data) {
  /** @type {Map<number, Role>} */
  const roles = new Map();
  for (const { attributes = {}, targets = [] } of data.primitives()) {
    for (const target of targets) {
      for (const [semantic, number] of Object.entries(target)) {
        roles.set(number, { semantic, isTarget: true });
      }
    }
    for (const [semantic, number] of Object.entries(attributes)) {
      roles.set(number, { semantic, isTarget: false });
    }
  }
  return roles;
}

/** The accessors of indices, and whether the triangles may begin with another corner.
 * @param {GltfData} data @returns {Map<number, boolean>} */
function indicesOf(data) {
  const isOfQuads = data.tree.extensionsUsed?.includes('FB_ngon_encoding') === true;
  /** @type {Map<number, boolean>} */
  const result = new Map();
  for (const { indices, mode = 4 } of data.primitives()) {
    if (indices === undefined) continue;
    result.set(indices, (result.get(indices) ?? true) && mode === 4 && !isOfQuads);
  }
  return result;
}

/**
 * A range of elements, as the encoder takes it.
 * @typedef {{ bytes: Uint8Array, count: number, byteStride: number, mode: string,
 *   filter?: string }} Range
 */

class Packer {
  /** @param {any} encoder @param {GltfData} data */
  constructor(encoder, data) {
    this.encoder = encoder;
    this.data = data;
  }

  /** Directions, as normalized integers. @param {number} number @returns {Range} */
  #directions(number) {
    const { data, encoder } = this;
    const [values, width] = [data.floats(number), data.widthOf(number)];
    const count = values.length / width;
    const four = new Float32Array(4 * count);
    for (let i = 0; i < count; i += 1) {
      four.set(values.subarray(width * i, width * (i + 1)), 4 * i);
    }
    const accessor = data.tree.accessors[number];
    Object.assign(accessor, { componentType: short, normalized: true });
    delete accessor.min;
    delete accessor.max;
    data.require('KHR_mesh_quantization');
    return { bytes: encoder.encodeFilterOct(four, count, 8, directionBits), count, byteStride: 8,
      mode: 'ATTRIBUTES', filter: 'OCTAHEDRAL' };
  }

  /** Floats on a grid; undefined if they are on none. @param {number} number
   * @returns {Range | undefined} */
  #onGrid(number) {
    const { data, encoder } = this;
    const [values, width] = [data.floats(number), data.widthOf(number)];
    const grid = gridOf(values);
    if (!grid || grid.bits > 24) return undefined;
    const [count, byteStride] = [values.length / width, 4 * width];
    return { bytes: encoder.encodeFilterExp(values, count, byteStride, grid.bits, 'Clamped'),
      count, byteStride, mode: 'ATTRIBUTES', filter: 'EXPONENTIAL' };
  }

  /** Any elements, as they are. @param {number} number @param {number} byteStride
   * @returns {Range} */
  #raw(number, byteStride) {
    const { count } = this.data.tree.accessors[number];
    return { bytes: this.data.rows(number, byteStride), count, byteStride, mode: 'ATTRIBUTES' };
  }

  /** @param {number} number @param {Role} [role] @returns {Range | undefined} none if it stays */
  attribute(number, role) {
    const { data } = this;
    const row = data.rowOf(number);
    const byteStride = role ? Math.ceil(row / 4) * 4 : row;
    if (byteStride % 4 !== 0 || byteStride > 256) return undefined;
    if (!role || !data.isFloats(number)) return this.#raw(number, byteStride);
    const { semantic, isTarget } = role;
    const isDirection = (semantic === 'NORMAL' || semantic === 'TANGENT') && !isTarget;
    if (isDirection) return this.#directions(number);
    if (semantic.startsWith('TEXCOORD_')) this.#roundTexcoords(number);
    const isRounded = semantic === 'POSITION' || semantic.startsWith('TEXCOORD_');
    return (isRounded ? this.#onGrid(number) : undefined) ?? this.#raw(number, byteStride);
  }

  /** @param {number} number */
  #roundTexcoords(number) {
    const values = this.data.floats(number);
    if (!values.every((value) => Math.abs(value) <= largestTexcoord)) return;
    this.data.setFloats(number,
      values.map((value) => Math.round(value / finestTexcoord) * finestTexcoord));
  }

  /** @param {number} number @param {boolean} mayTurn @returns {Range} */
  indices(number, mayTurn) {
    const accessor = this.data.tree.accessors[number];
    if (accessor.componentType === unsignedByte) {
      const wide = Uint16Array.from(this.data.rows(number));
      this.data.setRows(number, new Uint8Array(wide.buffer));
      accessor.componentType = unsignedShort;
    }
    const byteStride = accessor.componentType === unsignedInt ? 4 : 2;
    const isTriangles = mayTurn && accessor.count % 3 === 0;
    return { bytes: this.data.rows(number), count: accessor.count, byteStride,
      mode: isTriangles ? 'TRIANGLES' : 'INDICES' };
  }

  /** @param {number} number @param {Range} range @param {object} view */
  put(number, { bytes, ...range }, view) {
    const packed = this.encoder.encodeGltfBuffer(bytes, range.count, range.byteStride, range.mode);
    this.data.setRows(number, packed, { ...view, extensions: { [extension]: { ...range } } });
  }
}

/**
 * @param {GltfData} data
 * @returns {Promise<number>} how far a position moves at most, in percent of its mesh's diagonal
 */
export async function compressByMeshopt(data) {
  const { MeshoptEncoder } = await import('../meshopt_encoder.mjs');
  await MeshoptEncoder.ready;
  const error = roundPositions(data);
  const packer = new Packer(MeshoptEncoder, data);
  const [roles, indices] = [rolesOf(data), indicesOf(data)];
  for (const number of data.tree.accessors.keys()) {
    if (!data.isPlain(number)) continue;
    const mayTurn = indices.get(number);
    const role = roles.get(number);
    const range = mayTurn === undefined ? packer.attribute(number, role)
      : packer.indices(number, mayTurn);
    if (range) packer.put(number, range, role ? { byteStride: range.byteStride } : {});
  }
  data.require(extension);
  return error;
}

/** Readers see the decoded data in a buffer that is not there. @param {any} tree */
export function setFallback(tree) {
  let length = 0;
  for (const view of tree.bufferViews) {
    const packed = view.extensions?.[extension];
    if (!packed) continue;
    const { byteOffset, byteLength } = view;
    Object.assign(packed, { buffer: 0, byteOffset, byteLength });
    Object.assign(view,
      { buffer: 1, byteOffset: length, byteLength: packed.count * packed.byteStride });
    length += Math.ceil(view.byteLength / 4) * 4;
  }
  if (length > 0) {
    tree.buffers.push({ byteLength: length, extensions: { [extension]: { fallback: true } } });
  }
}
