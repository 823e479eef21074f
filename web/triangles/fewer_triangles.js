// SPDX-License-Identifier: MIT
// Fewer triangles of a surface, spread evenly over it, on the vertices that it has.
import { MeshoptSimplifier } from 'meshoptimizer/simplifier';

/** positions: three numbers a vertex; corners: three vertices a triangle; wanted: corners at most,
 * about; needsNormals: whether the vertices have none.
 * @typedef {{ positions: Float32Array, corners: Uint32Array, wanted: number,
 *   needsNormals: boolean }} Surface */

/** drawn: corners of the fewer triangles; normals: of all vertices, if they were needed.
 * @typedef {{ drawn: Uint32Array, normals: Float32Array | null }} Fewer */

/** Unit normals at the vertices: the sums of the area vectors of the triangles around them.
 * @param {Surface} surface */
function normalsOf({ positions: p, corners }) {
  const normals = new Float32Array(p.length);
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [3 * corners[i], 3 * corners[i + 1], 3 * corners[i + 2]];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    for (const at of [a, b, c]) {
      normals[at] += x;
      normals[at + 1] += y;
      normals[at + 2] += z;
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let k = i; k < i + 3; ++k) normals[k] /= length;
  }
  return normals;
}

/** @param {Surface} surface @returns {Promise<Fewer>} */
export async function fewerTriangles(surface) {
  const { positions, corners, wanted, needsNormals } = surface;
  await MeshoptSimplifier.ready;
  const [drawn] = MeshoptSimplifier.simplifySloppy(corners, positions, 3, null, wanted, 1);
  return { drawn, normals: needsNormals ? normalsOf(surface) : null };
}
