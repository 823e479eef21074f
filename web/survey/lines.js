// SPDX-License-Identifier: MIT
// The edges that the core has found on a surface, as lines.

/** @typedef {import('../triangles/soup.js').Soup} Soup */

/**
 * Segments are pairs of points, six numbers each; `bends` in degrees, largest first, one for each
 * segment of `sharp`; corners: of a body of flat sides, see `cornersOf`.
 * @typedef {{ boundary: Float32Array, nonManifold: Float32Array, flipped: Float32Array,
 *   sharp: Float32Array, bends: Float64Array, corners: number }} Edges
 */

/** @param {Float32Array} positions @param {Uint32Array} pairs of vertices */
function segments(positions, pairs) {
  const result = new Float32Array(3 * pairs.length);
  pairs.forEach((vertex, i) =>
    result.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
  return result;
}

/** Degrees: an edge that bends less is part of a round surface. */
const leastSharp = 30;
/** The share of bent edges that may be round on a body of flat sides. */
const mostRound = 0.02;
/** The share of all edges that may be sharp: a side of two triangles or more has flat ones, too. */
const mostSharp = 0.7;
/** The sum of two unit vectors along a straight edge, at most. */
const straight = 0.2;

/** The number of corners of a body of flat sides, where its sharp edges end, meet or turn, or where
 * seams of colours or textures run: a vertex on a flat side is stored once without them, one on a
 * sharp edge at most twice. As many vertices keep its shape. 0: there are round or rough surfaces.
 * @param {Pick<Soup, 'positions' | 'indices'>} soup
 * @param {import('remesher').EdgeSummary} found */
export function cornersOf({ positions, indices }, { bent, bends, first }) {
  const firstRound = bends.findIndex((bend) => bend < leastSharp);
  const sharp = firstRound < 0 ? bends.length : firstRound;
  const isRough = sharp > mostSharp * indices.length / 2;
  if (!sharp || isRough || sharp < (1 - mostRound) * bends.length) return 0;
  const count = new Uint32Array(positions.length / 3);
  const sums = new Float32Array(positions.length);
  for (let i = 0; i < 2 * sharp; i += 2) {
    const [a, b] = [first[bent[i]], first[bent[i + 1]]];
    const along = [0, 1, 2].map((k) => positions[3 * b + k] - positions[3 * a + k]);
    const length = Math.hypot(...along) || 1;
    along.forEach((x, k) => {
      sums[3 * a + k] += x / length;
      sums[3 * b + k] -= x / length;
    });
    count[a] += 1;
    count[b] += 1;
  }
  const copies = new Uint32Array(count.length);
  for (const vertex of first) copies[vertex] += 1;
  const turns = (/** @type {number} */ v) =>
    Math.hypot(...sums.subarray(3 * v, 3 * v + 3)) > straight;
  const isCorner = (/** @type {number} */ edges, /** @type {number} */ v) => (edges
    ? edges !== 2 || copies[v] > 2 || turns(v) : copies[v] > 1);
  return count.reduce((sum, edges, v) => sum + Number(isCorner(edges, v)), 0);
}

/** @param {Soup} soup @param {import('remesher').EdgeSummary} found @returns {Edges} */
export function linesOf(soup, found) {
  const { positions } = soup;
  const { boundary, nonManifold, flipped, bent, bends } = found;
  return {
    boundary: segments(positions, boundary),
    nonManifold: segments(positions, nonManifold),
    flipped: segments(positions, flipped),
    sharp: segments(positions, bent),
    bends,
    corners: cornersOf(soup, found),
  };
}
