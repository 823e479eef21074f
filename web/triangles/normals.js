// SPDX-License-Identifier: MIT
// Normals for a geometry without them: smooth over small bends, split at creases, so that a cube
// looks like a cube and a sphere like a sphere.
import { BufferAttribute } from 'three';
import { breath } from '../base/breath.js';
import { positionsOf } from './positions.js';

/** @typedef {import('three').BufferGeometry} BufferGeometry */
/** faces: area-weighted normals, three numbers a face; sizes: their lengths; list: the corners of
 * vertex v from start[v] to start[v + 1]; normals: three numbers a corner, filled in portions.
 * @typedef {{ corners: ArrayLike<number>, faces: Float32Array, sizes: Float32Array,
 *   start: Uint32Array, list: Uint32Array, normals: Float32Array }} Work */

const creaseCosine = Math.cos(40 * Math.PI / 180);
/** Number of corners between two pauses. */
const portion = 60_000;

/** @param {Float32Array} p three a vertex @param {ArrayLike<number>} corners */
function faceNormals(p, corners) {
  const faces = new Float32Array(corners.length);
  const sizes = new Float32Array(corners.length / 3);
  for (let f = 0; f < corners.length; f += 3) {
    const [a, b, c] = [3 * corners[f], 3 * corners[f + 1], 3 * corners[f + 2]];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    faces[f] = uy * vz - uz * vy;
    faces[f + 1] = uz * vx - ux * vz;
    faces[f + 2] = ux * vy - uy * vx;
    sizes[f / 3] = Math.hypot(faces[f], faces[f + 1], faces[f + 2]);
  }
  return { faces, sizes };
}

/** The corners around each vertex, as one list with offsets.
 * @param {ArrayLike<number>} corners @param {number} vertices */
function cornersByVertex(corners, vertices) {
  const start = new Uint32Array(vertices + 1);
  for (let i = 0; i < corners.length; ++i) ++start[corners[i] + 1];
  for (let v = 0; v < vertices; ++v) start[v + 1] += start[v];
  const next = start.slice();
  const list = new Uint32Array(corners.length);
  for (let i = 0; i < corners.length; ++i) list[next[corners[i]]++] = i;
  return { start, list };
}

/** Finds the normals of some corners: the sum over the faces around the vertex, except faces across
 * a crease from the corner's own. @param {Work} work @param {number} first @param {number} end
 * @returns {boolean} whether there are creases */
function smooth({ corners, faces, sizes, start, list, normals }, first, end) {
  let hasCreases = false;
  for (let corner = first; corner < end; ++corner) {
    const own = corner - corner % 3, vertex = corners[corner];
    let x = faces[own], y = faces[own + 1], z = faces[own + 2];
    for (let k = start[vertex]; k < start[vertex + 1]; ++k) {
      const other = list[k] - list[k] % 3;
      if (list[k] === corner) continue;
      const dot = faces[own] * faces[other] + faces[own + 1] * faces[other + 1]
        + faces[own + 2] * faces[other + 2];
      const isCrease = dot < creaseCosine * sizes[own / 3] * sizes[other / 3];
      hasCreases ||= isCrease;
      if (isCrease) continue;
      x += faces[other];
      y += faces[other + 1];
      z += faces[other + 2];
    }
    const length = Math.hypot(x, y, z) || 1;
    normals.set([x / length, y / length, z / length], 3 * corner);
  }
  return hasCreases;
}

/** One normal a vertex, for a geometry without creases. @param {Work} work
 * @param {number} vertices */
function perVertex({ start, list, normals }, vertices) {
  const result = new Float32Array(3 * vertices);
  for (let v = 0; v < vertices; ++v) {
    if (start[v] === start[v + 1]) continue;
    const at = 3 * list[start[v]];
    for (let k = 0; k < 3; ++k) result[3 * v + k] = normals[at + k];
  }
  return result;
}

/** The geometry itself with normals, or, if it has creases, a copy with one vertex per corner.
 * @param {BufferGeometry} geometry @returns {Promise<BufferGeometry>} */
export async function withNormals(geometry) {
  if (geometry.getAttribute('normal') || !geometry.index) {
    if (!geometry.getAttribute('normal')) geometry.computeVertexNormals();
    return geometry;
  }
  const corners = geometry.index.array;
  const { count } = geometry.attributes.position;
  const work = { corners, normals: new Float32Array(3 * corners.length),
    ...faceNormals(positionsOf(geometry), corners), ...cornersByVertex(corners, count) };
  let hasCreases = false;
  for (let first = 0; first < corners.length; first += portion) {
    await breath();
    hasCreases = smooth(work, first, Math.min(corners.length, first + portion)) || hasCreases;
  }
  await breath();
  const result = hasCreases ? geometry.toNonIndexed() : geometry;
  const normals = hasCreases ? work.normals : perVertex(work, count);
  return result.setAttribute('normal', new BufferAttribute(normals, 3));
}
