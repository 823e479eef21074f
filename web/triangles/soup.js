// SPDX-License-Identifier: MIT
// All triangles of a scene in world coordinates, as arrays that can be sent to a worker.
import { positionsOf } from './positions.js';
import { allCorners, cornerCount } from './thinning.js';

/** Three coordinates a vertex, three vertices a triangle; polygons: null if there are none.
 * @typedef {{ positions: Float32Array, indices: Uint32Array,
 *   polygons: import('./polygons.js').Polygons | null }} Soup */

/** The polygons of all geometries together: in a geometry without any, each triangle is one.
 * @param {import('three').BufferGeometry[]} geometries */
function allPolygons(geometries) {
  if (!geometries.some(({ userData }) => userData.polygons)) return null;
  /** @type {number[]} */
  const firsts = [];
  let triangle = 0;
  for (const geometry of geometries) {
    const count = cornerCount(geometry) / 3;
    const own = geometry.userData.polygons ?? Uint32Array.from({ length: count + 1 }, (_, i) => i);
    for (let k = 0; k + 1 < own.length; ++k) firsts.push(triangle + own[k]);
    triangle += count;
  }
  return Uint32Array.from([...firsts, triangle]);
}

/** Transforms points by a matrix. @param {Float32Array} from @param {Float32Array} to
 * @param {number[]} matrix sixteen numbers in three.js's order; the last row is ignored */
function move(from, to, [a, b, c, , d, e, f, , g, h, i, , x, y, z]) {
  for (let k = 0; k < from.length; k += 3) {
    const [u, v, w] = [from[k], from[k + 1], from[k + 2]];
    to[k] = a * u + d * v + g * w + x;
    to[k + 1] = b * u + e * v + h * w + y;
    to[k + 2] = c * u + f * v + i * w + z;
  }
}

/** @param {import('three').Mesh[]} meshes
 * @param {{ isDrawn?: boolean }} [how] isDrawn: only the triangles that are drawn, no polygons
 * @returns {Soup} */
export function soupOf(meshes, { isDrawn = false } = {}) {
  const cornersOf = (/** @type {import('three').BufferGeometry} */ geometry) =>
    (isDrawn ? geometry.index?.array ?? null : allCorners(geometry));
  const counts = meshes.map(({ geometry }) => ({ vertices: geometry.attributes.position.count,
    corners: cornersOf(geometry)?.length ?? cornerCount(geometry) }));
  const sum = (/** @type {'vertices' | 'corners'} */ key) =>
    counts.reduce((total, count) => total + count[key], 0);
  const positions = new Float32Array(3 * sum('vertices'));
  const indices = new Uint32Array(sum('corners'));
  let vertex = 0, corner = 0;
  for (const [i, { geometry, matrixWorld }] of meshes.entries()) {
    const { vertices, corners } = counts[i];
    const own = cornersOf(geometry);
    for (let k = 0; k < corners; ++k) indices[corner + k] = vertex + (own ? own[k] : k);
    move(positionsOf(geometry), positions.subarray(3 * vertex, 3 * (vertex + vertices)),
      matrixWorld.elements);
    vertex += vertices;
    corner += corners;
  }
  const polygons = isDrawn ? null : allPolygons(meshes.map(({ geometry }) => geometry));
  return { positions, indices, polygons };
}
