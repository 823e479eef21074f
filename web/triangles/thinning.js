// SPDX-License-Identifier: MIT
// A very large model is drawn with fewer triangles, spread evenly over the surface: a screen cannot
// show more. All vertices stay, and allCorners still returns all triangles of the surface.
import { BufferAttribute } from 'three';
import { positionsOf } from './positions.js';

/** @typedef {import('three').BufferGeometry} BufferGeometry */
/** The number of drawn triangles, and of all.
 * @typedef {{ shown: number, all: number }} Thinned */

const mostShown = 1_000_000;

/** The vertex of every corner of the surface, drawn or not; null: corner i is vertex i.
 * @param {BufferGeometry} geometry @returns {ArrayLike<number> | null} */
export const allCorners = ({ index, userData }) => userData.allCorners ?? index?.array ?? null;

/** The number of corners, drawn or not. @param {BufferGeometry} geometry */
export const cornerCount = (geometry) =>
  allCorners(geometry)?.length ?? geometry.attributes.position.count;

/** @param {BufferGeometry} geometry @returns {Uint32Array} */
const cornersOf = (geometry) => (geometry.index ? Uint32Array.from(geometry.index.array)
  : Uint32Array.from({ length: cornerCount(geometry) }, (_, i) => i));

/** @param {BufferGeometry} geometry @param {number} share of its triangles
 * @param {typeof import('meshoptimizer/simplifier').MeshoptSimplifier} simplifier */
function thinOne(geometry, share, simplifier) {
  const corners = cornersOf(geometry);
  const wanted = 3 * Math.ceil((corners.length / 3) * share);
  if (!geometry.getAttribute('normal')) geometry.computeVertexNormals();
  const [drawn] = simplifier.simplifySloppy(corners, positionsOf(geometry), 3, null, wanted, 1);
  geometry.userData.allCorners = corners;
  geometry.setIndex(new BufferAttribute(drawn, 1));
}

/**
 * @param {BufferGeometry[]} geometries get a new index if there are too many triangles; a geometry
 *   shown in several places is listed as often
 * @param {number} [most] drawn triangles in all
 * @returns {Promise<Thinned | null>} null if all are drawn
 */
export async function thin(geometries, most = mostShown) {
  const sum = (/** @type {(geometry: BufferGeometry) => number} */ count) =>
    geometries.reduce((total, geometry) => total + count(geometry) / 3, 0);
  const all = sum(cornerCount);
  if (all <= most) return null;
  const { MeshoptSimplifier } = await import('meshoptimizer/simplifier');
  await MeshoptSimplifier.ready;
  for (const geometry of new Set(geometries)) thinOne(geometry, most / all, MeshoptSimplifier);
  return { shown: sum(({ index }) => index?.count ?? 0), all };
}
