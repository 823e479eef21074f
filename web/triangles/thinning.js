// SPDX-License-Identifier: MIT
// Of a very large model a part of the triangles is drawn, spread evenly over the surface: more than
// that no screen shows. All vertices stay, and whoever asks for the surface gets all its triangles.
import { BufferAttribute } from 'three';
import { positionsOf } from './positions.js';

/** @typedef {import('three').BufferGeometry} BufferGeometry */
/** How many triangles are drawn, of how many.
 * @typedef {{ shown: number, all: number }} Thinned */

const mostShown = 1_000_000;

/** Every corner of the surface, drawn or not, as vertices; null: the vertices in turn.
 * @param {BufferGeometry} geometry @returns {ArrayLike<number> | null} */
export const allCorners = ({ index, userData }) => userData.allCorners ?? index?.array ?? null;

/** How many they are. @param {BufferGeometry} geometry */
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
 * @param {BufferGeometry[]} geometries whose index is replaced where there are too many triangles;
 *   one that is shown in several places is there as often
 * @param {number} [most] triangles in all
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
