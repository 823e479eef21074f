// SPDX-License-Identifier: MIT
// Rounds positions to multiples of a power of two, the same in the whole file, so that parts with a
// common border keep it, and so that encoders keep exactly what is rounded here.

/** @typedef {import('./gltf_data.js').GltfData} GltfData */

/** How far a position may move, as a share of the diagonal of its mesh: a fiftieth of a pixel where
 * the mesh is 2000 pixels high. */
const finest = 1e-5;

/** Multiples of the step that floats hold exactly. */
const mostMultiples = 2 ** 23;

/** The accessors of positions, and of their displacements by morph targets.
 * @param {GltfData} data */
function positionsOf(data) {
  /** @type {Set<number>} */
  const base = new Set();
  /** @type {Set<number>} */
  const all = new Set();
  for (const { attributes = {}, targets = [] } of data.primitives()) {
    if (attributes.POSITION !== undefined) base.add(attributes.POSITION);
    for (const one of [attributes, ...targets]) {
      if (one.POSITION !== undefined) all.add(one.POSITION);
    }
  }
  return { base: [...base], all: [...all] };
}

/** @param {Float32Array} points */
export function extentOf(points) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  let largest = 0;
  points.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3], value);
    high[i % 3] = Math.max(high[i % 3], value);
    largest = Math.max(largest, Math.abs(value));
  });
  return { low, high, diagonal: Math.hypot(...high.map((value, k) => value - low[k])), largest };
}

/** @param {Float32Array} points @param {number} step */
const rounded = (points, step) => points.map((value) => Math.round(value / step) * step);

/** Whether all points that differ still do. @param {Float32Array} points
 * @param {Float32Array} after */
export function areApart(points, after) {
  const keyOf = (/** @type {Float32Array} */ all, /** @type {number} */ i) =>
    `${all[i] + 0} ${all[i + 1] + 0} ${all[i + 2] + 0}`;
  /** @type {Map<string, string>} */
  const before = new Map();
  for (let i = 0; i < points.length; i += 3) {
    const [key, own] = [keyOf(after, i), keyOf(points, i)];
    if ((before.get(key) ?? own) !== own) return false;
    before.set(key, own);
  }
  return true;
}

/**
 * The coarsest step that moves no point farther than it may, and moves no two onto each other; none
 * if floats cannot hold its multiples.
 * @param {Float32Array[]} meshes
 * @returns {number | undefined}
 */
export function stepFor(meshes) {
  const extents = meshes.map(extentOf);
  const diagonals = extents.map(({ diagonal }) => diagonal).filter((diagonal) => diagonal > 0);
  const largest = Math.max(...extents.map((extent) => extent.largest));
  if (diagonals.length === 0 || !Number.isFinite(largest)) return undefined;
  let step = 2 ** Math.floor(Math.log2(finest * Math.min(...diagonals) * 2 / Math.sqrt(3)));
  for (; largest / step < mostMultiples; step /= 2) {
    if (meshes.every((points) => areApart(points, rounded(points, step)))) return step;
  }
  return undefined;
}

/** The largest way between points, as a share of the diagonal of the first ones.
 * @param {Float32Array} before @param {Float32Array} after */
export function shareMoved(before, after) {
  const { diagonal } = extentOf(before);
  let most = 0;
  for (let i = 0; i < before.length; i += 3) {
    most = Math.max(most, Math.hypot(...[0, 1, 2].map((k) => after[i + k] - before[i + k])));
  }
  return diagonal > 0 ? most / diagonal : 0;
}

/**
 * Rounds all positions that are floats.
 * @param {GltfData} data
 * @returns {number} the largest way that a position moves, in percent of its mesh's diagonal
 */
export function roundPositions(data) {
  const { base, all } = positionsOf(data);
  const isPlain = (/** @type {number} */ number) => data.isFloats(number);
  if (!all.every(isPlain) || base.length === 0) return 0;
  const step = stepFor(base.map((number) => data.floats(number)));
  if (step === undefined) return 0;
  let most = 0;
  for (const number of all) {
    const before = data.floats(number);
    const after = rounded(before, step);
    if (base.includes(number)) most = Math.max(most, shareMoved(before, after));
    data.setFloats(number, after);
  }
  return 100 * most;
}

/**
 * The coarsest power of two of which all values are multiples; undefined if there is none, or the
 * values are too many times as large for floats in so many bits.
 * @param {Float32Array} values
 * @returns {{ step: number, bits: number } | undefined} bits: of the largest multiple, with its
 *   sign
 */
export function gridOf(values) {
  let largest = 0;
  for (const value of values) largest = Math.max(largest, Math.abs(value));
  if (largest === 0) return { step: 1, bits: 1 };
  if (!Number.isFinite(largest)) return undefined;
  const most = 22;
  let step = 2 ** (Math.floor(Math.log2(largest)) - most);
  if (!values.every((value) => Number.isInteger(value / step))) return undefined;
  while (values.every((value) => Number.isInteger(value / (2 * step)))) step *= 2;
  return { step, bits: Math.floor(Math.log2(largest / step)) + 2 };
}
