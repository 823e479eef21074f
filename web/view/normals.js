// SPDX-License-Identifier: MIT
// Normals for a geometry that came without: smooth over bends, broken at creases, so that a cube
// looks like a cube and a sphere like a sphere.
import { BufferAttribute, Vector3 } from 'three';

/** @typedef {import('three').BufferGeometry} BufferGeometry */

const creaseCosine = Math.cos(40 * Math.PI / 180);

/** Area-weighted face normals, three numbers a face.
 * @param {import('three').BufferAttribute | import('three').InterleavedBufferAttribute} position
 * @param {ArrayLike<number>} corners */
function faceNormals(position, corners) {
  const normals = new Float32Array(corners.length);
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  for (let f = 0; f < corners.length; f += 3) {
    a.fromBufferAttribute(position, corners[f]);
    b.fromBufferAttribute(position, corners[f + 1]).sub(a);
    c.fromBufferAttribute(position, corners[f + 2]).sub(a);
    b.cross(c).toArray(normals, f);
  }
  return normals;
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

/** A corner's normal: the faces around its vertex that do not bend away from its own by a crease.
 * @param {Uint32Array} around @param {number} corner @param {Float32Array} normals */
function cornerNormal(around, corner, normals) {
  const own = new Vector3().fromArray(normals, corner - corner % 3);
  const sum = own.clone(), other = new Vector3();
  let isCrease = false;
  for (const neighbor of around) {
    other.fromArray(normals, neighbor - neighbor % 3);
    const cosine = own.dot(other) / (own.length() * other.length() || 1);
    if (neighbor === corner) continue;
    if (cosine >= creaseCosine) sum.add(other);
    else isCrease = true;
  }
  return { normal: sum.normalize(), isCrease };
}

/** Returns the geometry itself with normals, or, where it has creases, one with a vertex a corner.
 * @param {BufferGeometry} geometry @returns {BufferGeometry} */
export function withNormals(geometry) {
  if (geometry.getAttribute('normal') || !geometry.index) {
    if (!geometry.getAttribute('normal')) geometry.computeVertexNormals();
    return geometry;
  }
  const position = geometry.getAttribute('position');
  const corners = geometry.index.array;
  const normals = faceNormals(position, corners);
  const { start, list } = cornersByVertex(corners, position.count);
  const result = new Float32Array(3 * corners.length);
  let hasCreases = false;
  for (let corner = 0; corner < corners.length; ++corner) {
    const around = list.subarray(start[corners[corner]], start[corners[corner] + 1]);
    const { normal, isCrease } = cornerNormal(around, corner, normals);
    normal.toArray(result, 3 * corner);
    hasCreases ||= isCrease;
  }
  if (!hasCreases) {
    geometry.computeVertexNormals();
    return geometry;
  }
  const split = geometry.toNonIndexed();
  split.setAttribute('normal', new BufferAttribute(result, 3));
  return split;
}
