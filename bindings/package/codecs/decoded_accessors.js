// SPDX-License-Identifier: MIT
// Compressed data can be looked at only once it is decoded. Then accessors get their true bounds,
// and numbers that may have one value only get that value.

import { components, float } from './gltf_data.js';

/** @typedef {(data: DataView, at: number) => number} Read */

/** @type {Record<number, { size: number, read: Read }>} */
const types = {
  5120: { size: 1, read: (data, at) => data.getInt8(at) },
  5121: { size: 1, read: (data, at) => data.getUint8(at) },
  5122: { size: 2, read: (data, at) => data.getInt16(at, true) },
  5123: { size: 2, read: (data, at) => data.getUint16(at, true) },
  5125: { size: 4, read: (data, at) => data.getUint32(at, true) },
  5126: { size: 4, read: (data, at) => data.getFloat32(at, true) },
};

/**
 * An accessor with the bytes that it shows.
 * @typedef {{ accessor: any, stride?: number, bytes: Uint8Array }} Decoded
 */

/**
 * Calls `visit` with each number, the component of its element that it is and, to change it, a view
 * and the place there. Makes no call where numbers are missing, which the core reports.
 * @param {Decoded} decoded
 * @param {(value: number, component: number, data: DataView, at: number) => void} visit
 */
function forEachNumber({ accessor, stride, bytes }, visit) {
  const { componentType, type, count, byteOffset = 0, sparse } = accessor;
  const { size = 0, read } = types[componentType] ?? {};
  const width = components[type];
  if (!read || !width || sparse || !Number.isInteger(count) || count < 1) return;
  const step = stride ?? width * size;
  if (!(byteOffset + step * (count - 1) + width * size <= bytes.length)) return;
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let i = 0; i < count; i += 1) {
    for (let component = 0; component < width; component += 1) {
      const at = byteOffset + step * i + component * size;
      visit(read(data, at), component, data, at);
    }
  }
}

/** Corrects the bounds that an accessor states. @param {Decoded} decoded */
function tellBounds(decoded) {
  /** @type {number[]} */
  const min = [];
  /** @type {number[]} */
  const max = [];
  forEachNumber(decoded, (value, component) => {
    min[component] = Math.min(min[component] ?? value, value);
    max[component] = Math.max(max[component] ?? value, value);
  });
  if (min.length === 0 || ![...min, ...max].every(Number.isFinite)) return;
  if (decoded.accessor.min !== undefined) decoded.accessor.min = min;
  if (decoded.accessor.max !== undefined) decoded.accessor.max = max;
}

/** The last row of a matrix that moves joints is 0, 0, 0, 1, and all of it is finite.
 * @param {Decoded} decoded */
function mendMatrices(decoded) {
  forEachNumber(decoded, (value, component, data, at) => {
    const isOfLastRow = component % 4 === 3;
    if (isOfLastRow || !Number.isFinite(value)) {
      data.setFloat32(at, component % 5 === 0 ? 1 : 0, true);
    }
  });
}

/** @param {Decoded} decoded */
function mendNumbers(decoded) {
  forEachNumber(decoded, (value, _, data, at) => {
    if (!Number.isFinite(value)) data.setFloat32(at, 0, true);
  });
}

/**
 * @param {any} tree
 * @param {Uint8Array[]} contents per buffer view
 * @param {Set<number>} views the buffer views that were compressed
 */
export function settleAccessors(tree, contents, views) {
  const accessors = tree.accessors ?? [];
  /** @param {number} i @returns {Decoded[]} none if it was not compressed */
  const decoded = (i) => {
    const accessor = accessors[i];
    if (!views.has(accessor?.bufferView)) return [];
    const { byteStride } = tree.bufferViews[accessor.bufferView];
    return [{ accessor, stride: byteStride, bytes: contents[accessor.bufferView] }];
  };
  const ofFloats = (/** @type {number} */ i) =>
    decoded(i).filter(({ accessor }) => accessor.componentType === float);
  for (const { inverseBindMatrices } of tree.skins ?? []) {
    ofFloats(inverseBindMatrices).filter(({ accessor }) => accessor.type === 'MAT4')
      .forEach(mendMatrices);
  }
  for (const { samplers = [] } of tree.animations ?? []) {
    samplers.flatMap((/** @type {any} */ { input, output }) => [input, output])
      .flatMap(ofFloats).forEach(mendNumbers);
  }
  accessors.forEach((/** @type {any} */ { min, max }, /** @type {number} */ i) => {
    if (min !== undefined || max !== undefined) decoded(i).forEach(tellBounds);
  });
}
