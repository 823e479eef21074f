// SPDX-License-Identifier: MIT
// Strokes for the field that quads follow: in the middle of each quad a cross along its two
// directions. Quads lie along the field, so those of a draft show it before there are better ones.
import { forEachPolygon } from '../triangles/polygons.js';

/** @typedef {import('../triangles/soup.js').Soup} Soup */

/** The length of a stroke, as a share of the way between the middles of opposite sides. */
const share = 0.6;

/** @param {Soup} soup @returns {Float32Array} two segments a quad, six numbers each */
export function strokesOf({ positions, indices, polygons }) {
  /** @type {number[]} */
  const strokes = [];
  forEachPolygon(polygons ?? new Uint32Array(), (corners) => {
    if (corners.length !== 4) return;
    const sum = (/** @type {number[]} */ ...parts) => [0, 1, 2].map((axis) =>
      parts.reduce((all, part) => all + positions[3 * indices[corners[part]] + axis], 0));
    const middle = sum(0, 1, 2, 3).map((value) => value / 4);
    for (const [from, to] of [[sum(0, 1), sum(2, 3)], [sum(1, 2), sum(3, 0)]]) {
      for (const end of [from, to]) {
        strokes.push(...middle.map((value, axis) => value + share * (end[axis] / 2 - value)));
      }
    }
  });
  return Float32Array.from(strokes);
}
