// SPDX-License-Identifier: MIT
// All triangles of a scene in world coordinates, as arrays that can be sent to a worker.
import { positionsOf } from './positions.js';

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
    const count = (geometry.index ?? geometry.attributes.position).count / 3;
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

/** Surfaces, each with its matrix, as one: three numbers a vertex; null: corner i is vertex i.
 * @param {{ positions: Float32Array, corners: ArrayLike<number> | null, matrix: number[] }[]} all
 * @returns {{ positions: Float32Array, indices: Uint32Array }} */
export function joined(all) {
  const sum = (/** @type {(one: typeof all[0]) => number} */ count) =>
    all.reduce((total, one) => total + count(one), 0);
  const positions = new Float32Array(sum((one) => one.positions.length));
  const indices = new Uint32Array(sum((one) => (one.corners ?? one.positions).length
    / (one.corners ? 1 : 3)));
  let at = 0, corner = 0;
  for (const { positions: own, corners, matrix } of all) {
    const count = corners ? corners.length : own.length / 3;
    for (let k = 0; k < count; ++k) indices[corner + k] = at / 3 + (corners ? corners[k] : k);
    move(own, positions.subarray(at, at + own.length), matrix);
    at += own.length;
    corner += count;
  }
  return { positions, indices };
}

/** The drawn triangles. @param {import('three').Mesh[]} meshes @returns {Soup} */
export function soupOf(meshes) {
  return { ...joined(meshes.map(({ geometry, matrixWorld }) => ({ positions: positionsOf(geometry),
    corners: geometry.index?.array ?? null, matrix: matrixWorld.elements }))),
  polygons: allPolygons(meshes.map(({ geometry }) => geometry)) };
}
