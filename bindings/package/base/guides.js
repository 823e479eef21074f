// SPDX-License-Identifier: MIT
// Guides: lines on or near a model that quads follow.

import { RemeshError } from './errors.js';
import { legible } from './legible.js';

/**
 * A line on or near the surface, in the model's coordinates.
 * @typedef {object} Guide
 * @property {Float64Array | Float32Array | ReadonlyArray<readonly number[]>} points Three
 *   coordinates for each point, at least two points.
 * @property {'direction' | 'loop'} [kind] direction: quads lie along it. loop: it is closed, and
 *   becomes sides of quads. If not given, loop where it ends at the place where it begins.
 * @property {string} [name] For messages; its number if not given.
 */

/** @typedef {Guide | Guide['points']} GuideOrLine a guide, or a plain line */

/** @typedef {{ points: Float64Array, kind: 'direction' | 'loop', name: string }} FlatGuide */

/** @param {string} what @returns {RemeshError} */
function wrong(what) {
  return new RemeshError('INVALID_OPTION', `guides: ${what}.`,
    'Give lines like { points: [[0, 0, 0], [1, 0, 0]], kind: \'direction\' }.');
}

/** @param {unknown} points @param {string} name @returns {Float64Array} */
function flatPoints(points, name) {
  const isFlat = points instanceof Float64Array || points instanceof Float32Array;
  if (!isFlat && !Array.isArray(points)) throw wrong(`guide ${name} has no list of points`);
  if (!isFlat && !points.every((point) => point?.length === 3)) {
    throw wrong(`a point of guide ${name} does not have three coordinates`);
  }
  const flat = Float64Array.from(isFlat ? points : points.flatMap((point) => [...point]));
  if (flat.length % 3 !== 0) {
    throw wrong(`guide ${name} has ${flat.length} coordinates, which is no multiple of three`);
  }
  if (!flat.every(Number.isFinite)) {
    throw wrong(`a coordinate of guide ${name} is not a finite number`);
  }
  if (flat.length < 6) throw wrong(`guide ${name} has fewer than two points`);
  return flat;
}

/** Whether a line ends where it begins. @param {Float64Array} points */
export function isReturning(points) {
  return [0, 1, 2].every((axis) => points[axis] === points[points.length - 3 + axis]);
}

/** @param {GuideOrLine} given @param {number} number @returns {FlatGuide} */
function flattened(given, number) {
  const isLine = Array.isArray(given) || ArrayBuffer.isView(given);
  const guide = /** @type {Guide} */ (isLine ? { points: given } : given);
  if (typeof guide !== 'object' || guide === null) throw wrong(`guide ${number} is not a line`);
  const name = legible(String(guide.name ?? number));
  const points = flatPoints(guide.points, name);
  const kind = guide.kind ?? (isReturning(points) ? 'loop' : 'direction');
  if (kind !== 'direction' && kind !== 'loop') {
    throw wrong(`guide ${name} has kind '${legible(String(kind))}'; use 'direction' or 'loop'`);
  }
  if (kind === 'loop' && points.length < (isReturning(points) ? 12 : 9)) {
    throw wrong(`the loop ${name} has fewer than three points`);
  }
  return { points, kind, name };
}

/**
 * Guides in the form that travels to the core.
 * @param {readonly GuideOrLine[]} guides @returns {FlatGuide[]}
 */
export function flatGuides(guides) {
  return guides.map((guide, i) => flattened(guide, i + 1));
}
