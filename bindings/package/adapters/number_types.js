// SPDX-License-Identifier: MIT
// Attributes as floats, to be mixed, and back in the type they came in. Rounding is that of
// src/io/gltf/gltf_encoder.cpp: halves away from zero, within the type's range, directions of unit
// length, the weights of a vertex summing to exactly one.

/** @import { Mesh, NumberArray } from '../base/messages.js' */

// The divisor of each type's normalised integers; types that are not here are no integers.
const largestOf = new Map(/** @type {[Function, number][]} */ ([
  [Int8Array, 127], [Uint8Array, 255], [Uint8ClampedArray, 255], [Int16Array, 32767],
  [Uint16Array, 65535], [Int32Array, 2 ** 31 - 1], [Uint32Array, 2 ** 32 - 1]]));
const signed = new Set(/** @type {Function[]} */ ([Int8Array, Int16Array, Int32Array]));

// Rounding its ends turns an edge of this many integer steps by less than a degree.
const shortestEdgeInSteps = 64;

// A direction this close to unit length is left as it is, bit for bit.
const unitTolerance = 1e-4;

/** @param {NumberArray} array @returns {number} 0: its numbers are no integers */
const largestIn = (array) => largestOf.get(array.constructor) ?? 0;

/**
 * @param {NumberArray} array
 * @param {boolean} isNormalized
 * @returns {Float32Array} a copy
 */
export function decoded(array, isNormalized) {
  const one = isNormalized ? largestIn(array) : 0;
  return one === 0 ? Float32Array.from(array)
    : Float32Array.from(array, (value) => Math.max(value / one, -1));
}

/**
 * @template {NumberArray} Numbers
 * @param {ArrayLike<number>} values
 * @param {Numbers} model an array of the type wanted
 * @param {boolean} isNormalized
 * @returns {Numbers}
 */
export function encoded(values, model, isNormalized) {
  const Kind = /** @type {any} */ (model.constructor);
  const one = largestIn(model);
  if (one === 0) return Kind.from(values);
  const lowest = signed.has(Kind) ? (isNormalized ? -one : -one - 1) : 0;
  return Kind.from(values, (/** @type {number} */ value) => {
    const scaled = isNormalized ? value * one : value;
    const rounded = Math.sign(scaled) * Math.round(Math.abs(scaled));
    return Math.min(Math.max(rounded, lowest), one);
  });
}

/**
 * Normals, and tangents with their side, in place; other attributes stay.
 * @param {string} semantic
 * @param {{ values: Float32Array, itemSize: number }} attribute
 */
export function makeUnitLength(semantic, { values, itemSize }) {
  if (`${semantic}${itemSize}` !== 'NORMAL3' && `${semantic}${itemSize}` !== 'TANGENT4') return;
  for (let i = 0; i < values.length; i += itemSize) {
    const direction = values.subarray(i, i + 3);
    const length = Math.hypot(...direction);
    if (!(length > 0)) direction.set([0, 0, 1]);
    else if (Math.abs(length - 1) > unitTolerance) direction.set(direction.map((x) => x / length));
    if (itemSize === 4) values[i + 3] = values[i + 3] < 0 ? -1 : 1;
  }
}

/** @typedef {{ values: Float32Array, itemSize: number, model: NumberArray, isNormalized: boolean }}
 *   Typed */

/**
 * Rounds weights in place to multiples of the smallest step of their type, so that they sum to one.
 * If all are zero, the first becomes one.
 * @param {Map<string, Typed>} attributes those of one mesh, by semantic
 */
export function normalizeWeights(attributes) {
  const sets = [...attributes].filter(([semantic]) => semantic.startsWith('WEIGHTS_'))
    .map(([, set]) => set);
  if (sets.length === 0) return;
  const one = sets[0].isNormalized ? largestIn(sets[0].model) : 0;
  const count = sets[0].values.length / sets[0].itemSize;
  for (let vertex = 0; vertex < count; vertex += 1) {
    normalizeVertex(sets.map(({ values, itemSize }) =>
      values.subarray(vertex * itemSize, (vertex + 1) * itemSize)), one);
  }
}

/** @param {Float32Array[]} sets of one vertex @param {number} one in steps; 0: there are none */
function normalizeVertex(sets, one) {
  for (const weights of one > 0 ? sets : []) {
    weights.set(weights.map((weight) => Math.round(Math.max(weight, 0) * one)));
  }
  const all = sets.flatMap((weights) => [...weights]);
  const sum = all.reduce((total, weight) => total + weight, 0);
  const largest = Math.max(...all);
  const holder = sets.find((weights) => weights.includes(largest)) ?? sets[0];
  if (one > 0) holder[holder.indexOf(largest)] += one - sum;
  else if (sum === 0) holder[0] = 1;
  for (const weights of one > 0 ? sets : []) weights.set(weights.map((steps) => steps / one));
}

/**
 * Whether a mesh keeps its shape when its positions become integers of a type.
 * @param {Mesh} mesh
 * @param {NumberArray} model
 * @param {boolean} isNormalized
 */
export function canRoundPositions({ positions, indices }, model, isNormalized) {
  const largest = largestIn(model);
  if (largest === 0) return true;
  const scale = isNormalized ? largest : 1;
  const lowest = signed.has(model.constructor) ? -largest - 0.5 : -0.5;
  if (!positions.every((value) => value * scale >= lowest && value * scale <= largest + 0.5)) {
    return false;
  }
  return indices.every((/** @type {number} */ from, /** @type {number} */ i) => {
    const to = indices[i % 3 === 2 ? i - 2 : i + 1];
    const edge = [0, 1, 2].map((k) => positions[3 * to + k] - positions[3 * from + k]);
    return Math.hypot(...edge) * scale >= shortestEdgeInSteps;
  });
}
