// SPDX-License-Identifier: MIT
// What the edges of a triangle soup tell, once equal positions are one vertex: where the surface is
// open, where more than two triangles meet, where neighbours face opposite ways, and how sharply
// it bends.

/** Three coordinates a vertex, three vertices a triangle.
 * @typedef {{ positions: Float32Array, indices: Uint32Array }} Soup */

/** The number of the first vertex at each vertex's place. @param {Float32Array} positions */
function welded(positions) {
  /** @type {Map<string, number>} */
  const first = new Map();
  const result = new Uint32Array(positions.length / 3);
  for (let v = 0; v < result.length; ++v) {
    // Adding 0 makes one of both zeros.
    const key = `${positions[3 * v] + 0},${positions[3 * v + 1] + 0},${positions[3 * v + 2] + 0}`;
    const known = first.get(key);
    if (known === undefined) first.set(key, v);
    result[v] = known ?? v;
  }
  return result;
}

/** A unit normal for each triangle. @param {Soup} soup */
function normalsOf({ positions, indices }) {
  const normals = new Float32Array(indices.length);
  const at = (/** @type {number} */ corner, /** @type {number} */ axis) =>
    positions[3 * indices[corner] + axis];
  for (let i = 0; i < indices.length; i += 3) {
    const [ux, uy, uz] = [0, 1, 2].map((axis) => at(i + 1, axis) - at(i, axis));
    const [vx, vy, vz] = [0, 1, 2].map((axis) => at(i + 2, axis) - at(i, axis));
    const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const size = Math.hypot(...normal) || 1;
    normals.set(normal.map((x) => x / size), i);
  }
  return normals;
}

/** The corners from which each edge starts, by its two vertices.
 * @param {Soup} soup @param {Uint32Array} vertices */
function edgesOf({ indices }, vertices) {
  const count = vertices.length;
  /** @type {Map<number, number[]>} */
  const edges = new Map();
  for (let corner = 0; corner < indices.length; ++corner) {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    const [a, b] = [vertices[indices[corner]], vertices[indices[next]]];
    if (a === b) continue;
    const key = Math.min(a, b) * count + Math.max(a, b);
    const corners = edges.get(key);
    if (corners) corners.push(corner);
    else edges.set(key, [corner]);
  }
  return edges;
}

/** Pairs of points, six numbers each.
 * @param {Soup} soup @param {number[]} corners where each starts */
function segments({ positions, indices }, corners) {
  const result = new Float32Array(6 * corners.length);
  corners.forEach((corner, i) => {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    const [a, b] = [3 * indices[corner], 3 * indices[next]];
    result.set(positions.subarray(a, a + 3), 6 * i);
    result.set(positions.subarray(b, b + 3), 6 * i + 3);
  });
  return result;
}

/** Bends below this, in degrees, are nobody's feature. */
const leastBend = 5;

/**
 * Segments are pairs of points, six numbers each; `bends` in degrees, largest first, one for each
 * segment of `sharp`.
 * @typedef {{ boundary: Float32Array, nonManifold: Float32Array, flipped: Float32Array,
 *   sharp: Float32Array, bends: Float32Array }} Edges
 */

/** @param {Soup} soup @returns {Edges} */
export function findEdges(soup) {
  const vertices = welded(soup.positions);
  const normals = normalsOf(soup);
  const start = (/** @type {number} */ corner) => vertices[soup.indices[corner]];
  /** @type {Record<'boundary' | 'nonManifold' | 'flipped', number[]>} */
  const found = { boundary: [], nonManifold: [], flipped: [] };
  /** @type {{ corner: number, bend: number }[]} */
  const bent = [];
  for (const [corner, other, third] of edgesOf(soup, vertices).values()) {
    if (third !== undefined) found.nonManifold.push(corner);
    else if (other === undefined) found.boundary.push(corner);
    else if (start(corner) === start(other)) found.flipped.push(corner);
    else {
      const [i, j] = [corner - corner % 3, other - other % 3];
      const cosine = normals[i] * normals[j] + normals[i + 1] * normals[j + 1]
        + normals[i + 2] * normals[j + 2];
      const bend = Math.acos(Math.max(-1, Math.min(1, cosine))) * 180 / Math.PI;
      if (bend >= leastBend) bent.push({ corner, bend });
    }
  }
  bent.sort((a, b) => b.bend - a.bend);
  return {
    boundary: segments(soup, found.boundary),
    nonManifold: segments(soup, found.nonManifold),
    flipped: segments(soup, found.flipped),
    sharp: segments(soup, bent.map(({ corner }) => corner)),
    bends: Float32Array.from(bent, ({ bend }) => bend),
  };
}
