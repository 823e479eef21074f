// SPDX-License-Identifier: MIT
// Classifies the edges of a triangle soup after equal positions are welded: boundary edges, edges
// of more than two triangles, edges whose triangles face opposite ways, and sharp edges with the
// angles by which the surface bends there.

/** @typedef {import('../triangles/soup.js').Soup} Soup */

/** Positions by which vertices are welded, as in the core: a coordinate of at most 2^-50 times the
 * vertex's largest, such as the rounding error of a full turn's sine, becomes zero.
 * @param {Float32Array} positions */
function canonicalPlaces(positions) {
  const places = positions.slice();
  for (let i = 0; i < places.length; i += 3) {
    const [x, y, z] = [Math.abs(places[i]), Math.abs(places[i + 1]), Math.abs(places[i + 2])];
    const nothing = Math.max(x, y, z) * 2 ** -50;
    if (x <= nothing) places[i] = 0;
    if (y <= nothing) places[i + 1] = 0;
    if (z <= nothing) places[i + 2] = 0;
  }
  return places;
}

/** For each vertex the first vertex at its place, found in a hash table that is at most half full.
 * @param {Float32Array} positions */
export function welded(positions) {
  const places = new Uint32Array(canonicalPlaces(positions).buffer);
  const count = positions.length / 3;
  const mask = 2 ** Math.ceil(Math.log2(2 * count + 2)) - 1;
  const table = new Int32Array(mask + 1).fill(-1);
  const result = new Uint32Array(count);
  const isSame = (/** @type {number} */ a, /** @type {number} */ b) => places[a] === places[b]
    && places[a + 1] === places[b + 1] && places[a + 2] === places[b + 2];
  for (let v = 0; v < count; ++v) {
    let hash = Math.imul(places[3 * v], 0x9e3779b1) ^ Math.imul(places[3 * v + 1], 0x85ebca6b)
      ^ Math.imul(places[3 * v + 2], 0xc2b2ae35);
    hash = Math.imul(hash ^ (hash >>> 15), 0x2c1b3c6d);
    let at = (hash ^ (hash >>> 13)) & mask;
    while (table[at] >= 0 && !isSame(3 * table[at], 3 * v)) at = (at + 1) & mask;
    if (table[at] < 0) table[at] = v;
    result[v] = table[at];
  }
  return result;
}

/** A unit normal for each triangle. @param {Soup} soup */
function normalsOf({ positions: p, indices }) {
  const normals = new Float32Array(indices.length);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    const size = Math.hypot(x, y, z) || 1;
    normals[i] = x / size;
    normals[i + 1] = y / size;
    normals[i + 2] = z / size;
  }
  return normals;
}

/** Sorts corners by their keys, which are below `count`; corners of equal keys keep their order.
 * @param {Uint32Array} corners @param {Uint32Array} keys of each corner @param {number} count */
function orderedBy(corners, keys, count) {
  const start = new Uint32Array(count + 1);
  for (const corner of corners) ++start[keys[corner] + 1];
  for (let key = 0; key < count; ++key) start[key + 1] += start[key];
  const result = new Uint32Array(corners.length);
  for (const corner of corners) result[start[keys[corner]]++] = corner;
  return result;
}

/** Calls back for each edge with its corners, one per triangle, at which the edge starts.
 * @param {Uint32Array} indices @param {Uint32Array} vertices
 * @param {(corners: Uint32Array) => void} visit */
function forEachEdge(indices, vertices, visit) {
  const low = new Uint32Array(indices.length), high = new Uint32Array(indices.length);
  for (let corner = 0; corner < indices.length; ++corner) {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    const [a, b] = [vertices[indices[corner]], vertices[indices[next]]];
    low[corner] = Math.min(a, b);
    high[corner] = Math.max(a, b);
  }
  const edges = Uint32Array.from(indices.keys()).filter((corner) => low[corner] < high[corner]);
  const order = orderedBy(orderedBy(edges, high, vertices.length), low, vertices.length);
  for (let first = 0, end = 0; first < order.length; first = end) {
    const [a, b] = [low[order[first]], high[order[first]]];
    while (end < order.length && low[order[end]] === a && high[order[end]] === b) ++end;
    visit(order.subarray(first, end));
  }
}

/** Edges as pairs of points, six numbers each.
 * @param {Soup} soup @param {number[]} corners at which the edges start */
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

/** Edges that bend by fewer degrees cannot be features. */
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
  forEachEdge(soup.indices, vertices, ([corner, other, third]) => {
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
  });
  bent.sort((a, b) => b.bend - a.bend);
  return {
    boundary: segments(soup, found.boundary),
    nonManifold: segments(soup, found.nonManifold),
    flipped: segments(soup, found.flipped),
    sharp: segments(soup, bent.map(({ corner }) => corner)),
    bends: Float32Array.from(bent, ({ bend }) => bend),
  };
}
