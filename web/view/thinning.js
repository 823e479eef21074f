// SPDX-License-Identifier: MIT
// Of a very large model a part of the triangles is drawn, spread evenly over the surface: more than
// that no screen shows. All vertices stay, and whoever asks for the surface gets all its triangles.
import { BufferAttribute } from 'three';

/** @typedef {import('three').BufferGeometry} BufferGeometry */
/** How many triangles are drawn, of how many.
 * @typedef {{ shown: number, all: number }} Thinned */

const mostShown = 1_000_000;

/** Every corner of the surface, drawn or not, as vertices; null: the vertices in turn.
 * @param {BufferGeometry} geometry @returns {ArrayLike<number> | null} */
export const allCorners = ({ index, userData }) => userData.allCorners ?? index?.array ?? null;

/** @param {BufferGeometry} geometry @returns {Uint32Array} */
function cornersOf(geometry) {
  const corners = allCorners(geometry);
  return corners ? Uint32Array.from(corners)
    : Uint32Array.from({ length: geometry.attributes.position.count }, (_, i) => i);
}

/** @param {BufferGeometry} geometry @returns {Float32Array} three a vertex */
function positionsOf({ attributes: { position } }) {
  const positions = new Float32Array(3 * position.count);
  for (let i = 0; i < position.count; ++i) {
    positions.set([position.getX(i), position.getY(i), position.getZ(i)], 3 * i);
  }
  return positions;
}

/** @param {BufferGeometry} geometry */
const triangleCount = (geometry) =>
  (allCorners(geometry)?.length ?? geometry.attributes.position.count) / 3;

/**
 * @param {BufferGeometry[]} geometries whose index is replaced where there are too many triangles
 * @param {number} [most] triangles in all
 * @returns {Promise<Thinned | null>} null if all are drawn
 */
export async function thin(geometries, most = mostShown) {
  const all = geometries.reduce((sum, geometry) => sum + triangleCount(geometry), 0);
  if (all <= most) return null;
  const { MeshoptSimplifier } = await import('meshoptimizer/simplifier');
  await MeshoptSimplifier.ready;
  let shown = 0;
  for (const geometry of geometries) {
    const corners = cornersOf(geometry);
    const wanted = 3 * Math.ceil((corners.length / 3) * (most / all));
    if (!geometry.getAttribute('normal')) geometry.computeVertexNormals();
    const [drawn] = MeshoptSimplifier.simplifySloppy(
      corners, positionsOf(geometry), 3, null, wanted, 1);
    geometry.userData.allCorners = corners;
    geometry.setIndex(new BufferAttribute(drawn, 1));
    shown += drawn.length / 3;
  }
  return { shown, all };
}
