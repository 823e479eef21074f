// SPDX-License-Identifier: MIT
// All triangles of a scene in the world, as two arrays that can travel to a worker.
import { Vector3 } from 'three';
import { allCorners, cornerCount } from './thinning.js';

/** Three coordinates a vertex, three vertices a triangle.
 * @typedef {{ positions: Float32Array, indices: Uint32Array }} Soup */

/** @param {import('three').Mesh[]} meshes @returns {Soup} */
export function soupOf(meshes) {
  const counts = meshes.map(({ geometry }) =>
    ({ vertices: geometry.attributes.position.count, corners: cornerCount(geometry) }));
  const sum = (/** @type {'vertices' | 'corners'} */ key) =>
    counts.reduce((total, count) => total + count[key], 0);
  const positions = new Float32Array(3 * sum('vertices'));
  const indices = new Uint32Array(sum('corners'));
  const point = new Vector3();
  let vertex = 0, corner = 0;
  for (const [i, { geometry, matrixWorld }] of meshes.entries()) {
    const { position } = geometry.attributes;
    const own = allCorners(geometry);
    for (let k = 0; k < counts[i].corners; ++k) indices[corner++] = vertex + (own ? own[k] : k);
    for (let k = 0; k < counts[i].vertices; ++k) {
      point.fromBufferAttribute(position, k).applyMatrix4(matrixWorld);
      point.toArray(positions, 3 * vertex++);
    }
  }
  return { positions, indices };
}
