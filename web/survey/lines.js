// SPDX-License-Identifier: MIT
// The edges that the core has found on a surface, as lines.

/** @typedef {import('../triangles/soup.js').Soup} Soup */

/**
 * Segments are pairs of points, six numbers each; `bends` in degrees, largest first, one for each
 * segment of `sharp`.
 * @typedef {{ boundary: Float32Array, nonManifold: Float32Array, flipped: Float32Array,
 *   sharp: Float32Array, bends: Float64Array }} Edges
 */

/** @param {Float32Array} positions @param {Uint32Array} pairs of vertices */
function segments(positions, pairs) {
  const result = new Float32Array(3 * pairs.length);
  pairs.forEach((vertex, i) =>
    result.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
  return result;
}

/** @param {Soup} soup @param {import('remesher').EdgeSummary} found @returns {Edges} */
export function linesOf({ positions }, { boundary, nonManifold, flipped, bent, bends }) {
  return {
    boundary: segments(positions, boundary),
    nonManifold: segments(positions, nonManifold),
    flipped: segments(positions, flipped),
    sharp: segments(positions, bent),
    bends,
  };
}
