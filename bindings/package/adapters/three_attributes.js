// SPDX-License-Identifier: MIT
// Buffer attributes of three.js as floats by glTF semantic, and back as attributes of their type.

import { BufferAttribute, DataUtils, Float16BufferAttribute } from 'three';

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { decoded, encoded } from './number_types.js';

/** @import { InterleavedBufferAttribute } from 'three' */
/** @import { NumberArray } from '../base/messages.js' */
/** @typedef {BufferAttribute | InterleavedBufferAttribute} AnyAttribute */

/** @type {Record<string, string>} */
const semantics = {
  position: 'POSITION', normal: 'NORMAL', tangent: 'TANGENT', uv: 'TEXCOORD_0', color: 'COLOR_0',
  skinIndex: 'JOINTS_0', skinWeight: 'WEIGHTS_0',
};

/**
 * The glTF semantic of an attribute, from three.js's own name or that of its GLTFLoader.
 * @param {string} name
 */
export function semanticOf(name) {
  if (Object.hasOwn(semantics, name)) return semantics[name];
  const numbered = /^uv(\d+)$/.exec(name);
  if (numbered) return `TEXCOORD_${numbered[1]}`;
  const isKnown = name.startsWith('_') || /^(color|texcoord|joints|weights)_\d+$/.test(name);
  // Names that differ in case only are two attributes here.
  return isKnown && name === name.toLowerCase() ? name.toUpperCase() : `_${name}`;
}

/** @param {AnyAttribute} attribute @returns {attribute is InterleavedBufferAttribute} */
const isInterleaved = (attribute) => 'isInterleavedBufferAttribute' in attribute;

/** @param {AnyAttribute} attribute */
const isHalf = (attribute) => 'isFloat16BufferAttribute' in attribute;

/** The numbers as they are stored, one vertex behind another. @param {AnyAttribute} attribute */
function storedNumbers(attribute) {
  const { array, itemSize } = attribute;
  if (!isInterleaved(attribute)) return /** @type {NumberArray} */ (array);
  const { data: { stride }, offset, count } = attribute;
  const numbers = new (/** @type {any} */ (array).constructor)(count * itemSize);
  for (let i = 0; i < count; i += 1) {
    for (let k = 0; k < itemSize; k += 1) {
      numbers[i * itemSize + k] = array[i * stride + offset + k];
    }
  }
  return /** @type {NumberArray} */ (numbers);
}

/** @param {AnyAttribute} attribute @param {string} name @param {number} count */
function checkAttribute(attribute, name, count) {
  if ('isGLBufferAttribute' in attribute) {
    throw new RemeshError('UNSUPPORTED', `The attribute ${legible(name)} is on the GPU alone.`,
      'Give the geometry attributes with arrays.');
  }
  if (!(attribute.count >= count)) {
    throw new RemeshError('INVALID_MESH', `The attribute ${legible(name)} has values for `
      + `${attribute.count} vertices, but there are ${count}.`);
  }
}

/**
 * @param {AnyAttribute} attribute
 * @param {string} name for messages
 * @param {number} count of vertices
 * @returns {Float32Array} a copy, normalised integers as fractions
 */
export function floatsOf(attribute, name, count) {
  checkAttribute(attribute, name, count);
  const numbers = /** @type {NumberArray} */ (
    storedNumbers(attribute).subarray(0, count * attribute.itemSize));
  return isHalf(attribute) ? Float32Array.from(numbers, DataUtils.fromHalfFloat)
    : decoded(numbers, attribute.normalized);
}

/** Positions; those of double precision keep it. @param {AnyAttribute} attribute */
export function positionsOf(attribute) {
  checkAttribute(attribute, 'position', attribute.count);
  if (attribute.itemSize !== 3) {
    throw new RemeshError('INVALID_MESH',
      `The attribute position has ${attribute.itemSize} numbers a vertex, not 3.`);
  }
  return attribute.array instanceof Float64Array
    ? Float64Array.from(/** @type {any} */ (storedNumbers(attribute)))
    : floatsOf(attribute, 'position', attribute.count);
}

/**
 * An attribute like another, with other values.
 * @param {AnyAttribute} model
 * @param {ArrayLike<number>} values
 * @returns {BufferAttribute}
 */
export function attributeLike(model, values) {
  const { array, itemSize, normalized } = model;
  const attribute = isHalf(model)
    ? new Float16BufferAttribute(Uint16Array.from(values, DataUtils.toHalfFloat), itemSize,
      normalized)
    : new BufferAttribute(encoded(values, /** @type {NumberArray} */ (array), normalized),
      itemSize, normalized);
  attribute.name = model.name;
  attribute.usage = isInterleaved(model) ? model.data.usage : model.usage;
  if (!isInterleaved(model)) attribute.gpuType = model.gpuType;
  return attribute;
}
