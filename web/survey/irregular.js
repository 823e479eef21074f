// SPDX-License-Identifier: MIT
// The irregular vertices inside a quad surface: those with a valence other than four.
import { forEachPolygon } from '../triangles/polygons.js';

/** @typedef {import('../triangles/soup.js').Soup} Soup */
/** @typedef {import('../triangles/polygons.js').Irregular} Irregular */

/** The valence of each vertex after welding, 0 for border vertices and duplicates.
 * @param {import('../triangles/polygons.js').Polygons} polygons
 * @param {ArrayLike<number>} vertices of the corners @param {number} count */
function valencesInside(polygons, vertices, count) {
  /** @type {Map<number, number>} */
  const uses = new Map();
  forEachPolygon(polygons, (corners) => corners.forEach((corner, i) => {
    const [a, b] = [vertices[corner], vertices[corners[(i + 1) % corners.length]]];
    const edge = Math.min(a, b) * count + Math.max(a, b);
    uses.set(edge, (uses.get(edge) ?? 0) + 1);
  }));
  const valences = new Uint32Array(count), isBorder = new Uint8Array(count);
  for (const [edge, times] of uses) {
    for (const vertex of [Math.floor(edge / count), edge % count]) {
      ++valences[vertex];
      if (times === 1) isBorder[vertex] = 1;
    }
  }
  return valences.map((valence, vertex) => (isBorder[vertex] ? 0 : valence));
}

/** @param {Soup} soup @param {Uint32Array} first for each vertex the first at its place
 * @returns {Irregular} empty if the soup has no polygons */
export function irregularVertices({ positions, indices, polygons }, first) {
  if (!polygons) return { places: new Float32Array(), valences: [] };
  const vertices = indices.map((vertex) => first[vertex]);
  const all = valencesInside(polygons, vertices, positions.length / 3);
  const found = [...all.keys()].filter((vertex) => all[vertex] && all[vertex] !== 4);
  return { places: Float32Array.from(found.flatMap((vertex) =>
    [...positions.subarray(3 * vertex, 3 * vertex + 3)])),
  valences: found.map((vertex) => all[vertex]) };
}
