// SPDX-License-Identifier: MIT
// The values that an option can have: what they must be, in words, and the form in which they
// travel to the core.

import { RemeshError } from './errors.js';
import { flatGuides } from './guides.js';
import { legible } from './legible.js';
import { lengthFrom, pixelsFrom, takesLength } from './lengths.js';

/**
 * The columns of the table of options that matter here.
 * @typedef {object} Option
 * @property {string} type
 * @property {string} [unit]
 * @property {number} [min]
 * @property {number} [max]
 * @property {number} [above]
 * @property {readonly string[]} [choices]
 * @property {string} [word]
 */

const mostLods = 16;

/** @param {Option} option @param {unknown} value */
export const isLength = (option, value) => takesLength(option) && lengthFrom(value) !== undefined;

/** The values that an option allows, in words, without their unit. @param {Option} option */
export function rangeInWords(option) {
  if (option.choices) return `one of ${option.choices.join(', ')}`;
  if (option.type === 'boolean') return 'true or false';
  if (option.type === 'shares') {
    return `1 to ${mostLods} numbers above 0, or so many with px behind them`;
  }
  if (option.type === 'floats') return 'a Float32Array or Float64Array with one value per vertex';
  if (option.type === 'indices') return 'a Uint32Array or array of triangle numbers, not empty';
  if (option.type === 'pairs') return 'a Uint32Array of vertex pairs, or an array of pairs';
  if (option.type === 'guides') return 'an array of lines, or of { points, kind }';
  const kind = option.type === 'integer' ? 'a whole number' : 'a number';
  const length = takesLength(option) ? ', a length like 0.1mm' : '';
  const off = option.word ? `${length}, or ${option.word}` : length.replace(' a', ' or a');
  const most = option.max === undefined ? '' : `, up to ${option.max}`;
  if (option.above !== undefined) return `${kind} above ${option.above}${most}${off}`;
  return `${kind} from ${option.min} to ${option.max}${off}`;
}

/** @param {unknown} value */
function areShares(value) {
  if (!(Array.isArray(value) || value instanceof Float64Array)) return false;
  if (value.length < 1 || value.length > mostLods) return false;
  return value.every((share) => Number.isFinite(share) && share > 0)
    || value.every((share) => pixelsFrom(share) !== undefined);
}

/** @param {unknown} value */
function areIndices(value) {
  if (value instanceof Uint32Array) return value.length > 0;
  return Array.isArray(value) && value.length > 0
    && value.every((index) => Number.isInteger(index) && index >= 0 && index < 2 ** 32);
}

/** @param {Option} option @param {unknown} value @returns {boolean} */
function isAllowed(option, value) {
  switch (option.type) {
    case 'boolean':
      return typeof value === 'boolean';
    case 'choice':
      return typeof value === 'string' && option.choices?.includes(value) === true;
    case 'shares':
      return areShares(value);
    case 'floats':
      return value instanceof Float32Array || value instanceof Float64Array;
    case 'indices':
      return areIndices(value);
    case 'pairs':
      return value instanceof Uint32Array || Array.isArray(value);
    case 'guides':
      return Array.isArray(value);
    default:
      return (option.word !== undefined && value === option.word)
        || isLength(option, value) || isInRange(option, value);
  }
}

/** @param {Option} option @param {unknown} value */
function isInRange(option, value) {
  if (typeof value !== 'number' || !Number.isFinite(value)) return false;
  if (option.type === 'integer' && !Number.isInteger(value)) return false;
  if (option.above !== undefined && !(value > option.above)) return false;
  return value >= (option.min ?? -Infinity) && value <= (option.max ?? Infinity);
}

/** A given value in words: '10' is not 10. @param {unknown} value */
export function inWords(value) {
  if (typeof value === 'string') return `'${legible(value)}'`;
  if (typeof value === 'function') return 'a function';
  return typeof value === 'object' && value !== null
    ? legible(value.constructor?.name ?? 'an object') : String(value);
}

/**
 * Throws unless the value is one the option can have.
 * @param {Option} option
 * @param {unknown} value
 * @param {string} label how the caller knows the option
 * @param {unknown} [given] the value as the caller wrote it
 */
export function checkValue(option, value, label, given = value) {
  if (isAllowed(option, value)) return;
  throw new RemeshError('INVALID_OPTION',
    `${label} must be ${rangeInWords(option)}, not ${inWords(given)}.`);
}

/** @param {Uint32Array | readonly (readonly number[])[]} pairs @returns {Uint32Array} a copy */
function flattened(pairs) {
  const isPair = (/** @type {unknown} */ pair) => Array.isArray(pair) && pair.length === 2
    && pair.every((vertex) => Number.isInteger(vertex) && vertex >= 0 && vertex < 2 ** 32);
  const areValid = pairs instanceof Uint32Array ? pairs.length % 2 === 0 : pairs.every(isPair);
  if (!areValid) {
    throw new RemeshError('INVALID_OPTION',
      'featureEdges must hold pairs of vertex numbers, like [[0, 1], [1, 2]].');
  }
  return pairs instanceof Uint32Array ? pairs.slice() : Uint32Array.from(pairs.flat());
}

/** The value in the form that travels to the core. @param {Option} option @param {any} value */
export function canonical(option, value) {
  if (option.type === 'floats') return Float32Array.from(value);
  if (option.type === 'indices') return Uint32Array.from(value);
  if (option.type === 'shares') {
    return pixelsFrom(value[0]) === undefined ? Float64Array.from(value) : [...value];
  }
  if (option.type === 'guides') return flatGuides(value);
  return option.type === 'pairs' ? flattened(value) : value;
}
