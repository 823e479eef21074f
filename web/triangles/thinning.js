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

/** A copy. @param {BufferGeometry} geometry @returns {Uint32Array} */
const cornersOf = (geometry) => (geometry.index ? new Uint32Array(geometry.index.array)
  : Uint32Array.from({ length: cornerCount(geometry) }, (_, i) => i));

/** @typedef {import('./fewer_triangles.js').Surface} Surface */
/** @typedef {import('./fewer_triangles.js').Fewer} Fewer */

/** The page goes on meanwhile. @param {Surface} surface @returns {Promise<Fewer>} */
function fewerInWorker(surface) {
  const worker = new Worker(new URL('./thinning_worker.js', import.meta.url), { type: 'module' });
  return new Promise((resolve, reject) => {
    worker.addEventListener('message', ({ data: { fewer, error } }) => {
      worker.terminate();
      if (error) reject(new Error(error));
      else resolve(fewer);
    });
    worker.addEventListener('error', ({ message }) => reject(new Error(message)));
    worker.postMessage(surface, [surface.corners.buffer]);
  });
}

/** @param {BufferGeometry} geometry @param {number} share of its triangles
 * @param {(surface: Surface) => Promise<Fewer>} fewerOf */
async function thinOne(geometry, share, fewerOf) {
  const { corners, drawn, normals } = await fewerOf({
    positions: positionsOf(geometry), corners: cornersOf(geometry),
    wanted: 3 * Math.ceil((cornerCount(geometry) / 3) * share),
    needsNormals: !geometry.getAttribute('normal'),
  });
  if (normals) geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  geometry.userData.allCorners = corners;
  geometry.setIndex(new BufferAttribute(drawn, 1));
}

/**
 * @param {BufferGeometry[]} geometries get a new index if there are too many triangles; a geometry
 *   shown in several places is listed as often
 * @param {{ most?: number, fewerOf?: (surface: Surface) => Promise<Fewer> }} [how] most: drawn
 *   triangles in all
 * @returns {Promise<Thinned | null>} null if all are drawn
 */
export async function thin(geometries, { most = mostShown, fewerOf = fewerInWorker } = {}) {
  const sum = (/** @type {(geometry: BufferGeometry) => number} */ count) =>
    geometries.reduce((total, geometry) => total + count(geometry) / 3, 0);
  const all = sum(cornerCount);
  if (all <= most) return null;
  for (const geometry of new Set(geometries)) await thinOne(geometry, most / all, fewerOf);
  return { shown: sum(({ index }) => index?.count ?? 0), all };
}
