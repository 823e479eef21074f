// SPDX-License-Identifier: MIT
// Quads and other polygons of a triangle geometry: by FB_ngon_encoding, consecutive triangles with
// the same first corner are one polygon. Corner 3 t + i is corner i of triangle t.

/** The first triangle of each polygon, then the number of all triangles.
 * @typedef {Uint32Array} Polygons */
/** Irregular vertices, where other than four quads meet; places: three numbers each.
 * @typedef {{ places: Float32Array, valences: number[] }} Irregular */

/** Null if the file has triangles only.
 * @param {import('three').Mesh} mesh as the loader makes it @returns {Polygons | null} */
export function polygonsOf({ userData, geometry }) {
  const { index } = geometry;
  const hasPolygons = userData.gltfExtensions?.FB_ngon_encoding;
  if (!hasPolygons || !index) return null;
  const corners = index.array;
  const firsts = [];
  for (let i = 0; i < corners.length; i += 3) {
    if (!i || corners[i] !== corners[i - 3]) firsts.push(i / 3);
  }
  const count = corners.length / 3;
  return firsts.length < count ? Uint32Array.from([...firsts, count]) : null;
}

/** The corners of a polygon in order: two of its first triangle, then the third of each triangle.
 * @param {number} first triangle @param {number} end the triangle behind its last */
export function cornersOfPolygon(first, end) {
  const corners = [3 * first, 3 * first + 1];
  for (let t = first; t < end; ++t) corners.push(3 * t + 2);
  return corners;
}

/** Calls back with the corners of each polygon.
 * @param {Polygons} polygons @param {(corners: number[]) => void} visit */
export function forEachPolygon(polygons, visit) {
  for (let k = 0; k + 1 < polygons.length; ++k) {
    visit(cornersOfPolygon(polygons[k], polygons[k + 1]));
  }
}

/** The edges of polygons, each once, as pairs of corners.
 * @param {import('three').BufferGeometry} geometry @param {Polygons} polygons */
export function outlineOf(geometry, polygons) {
  const vertices = /** @type {ArrayLike<number>} */ (geometry.index?.array);
  // The edges with the same lower end vertex form a linked list, latest first.
  const latest = new Int32Array(geometry.attributes.position.count).fill(-1);
  /** @type {number[]} */
  const earlier = [];
  /** @type {number[]} */
  const ends = [];
  /** @type {number[]} */
  const edges = [];
  const isKnown = (/** @type {number} */ low, /** @type {number} */ high) => {
    let edge = latest[low];
    while (edge >= 0 && ends[edge] !== high) edge = earlier[edge];
    return edge >= 0;
  };
  forEachPolygon(polygons, (corners) => corners.forEach((corner, i) => {
    const next = corners[(i + 1) % corners.length];
    const low = Math.min(vertices[corner], vertices[next]);
    const high = Math.max(vertices[corner], vertices[next]);
    if (isKnown(low, high)) return;
    earlier.push(latest[low]);
    latest[low] = ends.push(high) - 1;
    edges.push(corner, next);
  }));
  return Uint32Array.from(edges);
}
