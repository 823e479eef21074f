// SPDX-License-Identifier: MIT
// Joins several lists of vertices, each with attributes of its own, to one mesh in groups, and
// separates them again. So borders between materials are remeshed as what they are: curves inside
// one surface. An attribute that only some pools have is zero (a colour: one) at the vertices of
// the others, and is left out there afterwards; no triangle mixes the vertices of two groups.

import { RemeshError } from '../base/errors.js';

/** @import { Floats, Mesh, MeshAttribute } from '../base/messages.js' */

/**
 * Vertices with one set of attributes, and the triangles on them.
 * @typedef {object} VertexPool
 * @property {string} label what it is called in a message
 * @property {Floats} positions
 * @property {Map<string, { values: Float32Array, itemSize: number }>} attributes by semantic
 * @property {Map<number, Uint32Array>} triangles by group; no group is in two pools
 */

/**
 * A remeshed mesh's data for a pool.
 * @typedef {object} PoolResult
 * @property {Uint32Array} vertices their numbers in the mesh, ascending
 * @property {Map<number, Uint32Array>} triangles by group, in numbers of the pool's own
 */

// A skin has four joints in each set, for the core too.
const influences = 4;

/** @param {VertexPool[]} pools @returns {[string, number][]} semantics and how wide they are */
function layout(pools) {
  /** @type {Map<string, number>} */
  const widths = new Map();
  for (const { attributes } of pools) {
    for (const [semantic, { itemSize }] of attributes) {
      const least = /^(JOINTS|WEIGHTS)_/.test(semantic) ? influences : 1;
      widths.set(semantic, Math.max(itemSize, widths.get(semantic) ?? least));
    }
  }
  // Sorted by code units, as in reading files, so that the same vertices come out.
  return [...widths].sort(([a], [b]) => (a < b ? -1 : 1));
}

/** @param {VertexPool[]} pools @param {string} semantic @param {number} itemSize */
function joinedAttribute(pools, semantic, itemSize) {
  const count = pools.reduce((sum, { positions }) => sum + positions.length / 3, 0);
  const array = new Float32Array(count * itemSize).fill(semantic.startsWith('COLOR_') ? 1 : 0);
  let first = 0;
  for (const { attributes, positions } of pools) {
    const own = attributes.get(semantic);
    const vertexCount = positions.length / 3;
    for (let i = 0; own && i < vertexCount; i += 1) {
      for (let k = 0; k < own.itemSize; k += 1) {
        const value = own.values[i * own.itemSize + k];
        array[(first + i) * itemSize + k] = Number.isFinite(value) ? value : 0;
      }
    }
    first += vertexCount;
  }
  return { array, itemSize };
}

/** @param {VertexPool[]} pools */
function joinedPositions(pools) {
  const length = pools.reduce((sum, { positions }) => sum + positions.length, 0);
  const isDouble = pools.some(({ positions }) => positions instanceof Float64Array);
  const all = isDouble ? new Float64Array(length) : new Float32Array(length);
  let first = 0;
  for (const { positions } of pools) {
    all.set(positions, first);
    first += positions.length;
  }
  return all;
}

/** @param {VertexPool} pool @param {Uint32Array} triangles */
function checkIndices({ label, positions }, triangles) {
  const count = positions.length / 3;
  const at = triangles.findIndex((vertex) => vertex >= count);
  if (at < 0) return;
  throw new RemeshError('INDEX_OUT_OF_RANGE',
    `${label}: a triangle names vertex ${triangles[at]}, but there are ${count}.`);
}

/** @param {VertexPool[]} pools @returns {Mesh} */
export function joined(pools) {
  /** @type {{ group: number, first: number, triangles: Uint32Array }[]} */
  const runs = [];
  let first = 0;
  for (const pool of pools) {
    for (const [group, triangles] of pool.triangles) {
      checkIndices(pool, triangles);
      runs.push({ group, first, triangles });
    }
    first += pool.positions.length / 3;
  }
  runs.sort((a, b) => a.group - b.group);
  const count = runs.reduce((sum, { triangles }) => sum + triangles.length, 0);
  const [indices, groups] = [new Uint32Array(count), new Uint32Array(count / 3)];
  let at = 0;
  for (const run of runs) {
    indices.set(run.triangles.map((vertex) => vertex + run.first), at);
    groups.fill(run.group, at / 3, (at + run.triangles.length) / 3);
    at += run.triangles.length;
  }
  /** @type {Record<string, MeshAttribute>} */
  const attributes = Object.fromEntries(layout(pools).map(([semantic, itemSize]) =>
    [semantic, joinedAttribute(pools, semantic, itemSize)]));
  return { positions: joinedPositions(pools), indices, attributes, groups };
}

/**
 * @param {Mesh} mesh that `joined` made, remeshed
 * @param {VertexPool} pool
 * @returns {PoolResult}
 */
export function separated({ positions, indices, groups = new Uint32Array() }, pool) {
  /** @type {Map<number, number[]>} */
  const corners = new Map([...pool.triangles.keys()].map((group) => [group, []]));
  const numbers = new Uint32Array(positions.length / 3);
  groups.forEach((/** @type {number} */ group, /** @type {number} */ t) => {
    const list = corners.get(group);
    for (let i = 3 * t; list && i < 3 * t + 3; i += 1) {
      list.push(indices[i]);
      numbers[indices[i]] = 1;
    }
  });
  const vertices = Uint32Array.from(function* used() {
    for (let i = 0; i < numbers.length; i += 1) if (numbers[i]) yield i;
  }());
  vertices.forEach((vertex, i) => (numbers[vertex] = i));
  const triangles = new Map([...corners].map(([group, list]) =>
    [group, Uint32Array.from(list, (vertex) => numbers[vertex])]));
  return { vertices, triangles };
}

/**
 * The first `itemSize` numbers of each vertex; numbers that the mesh does not have are zero.
 * @param {{ array: ArrayLike<number>, itemSize: number }} attribute of the mesh
 * @param {Uint32Array} vertices
 * @param {number} itemSize
 */
export function picked(attribute, vertices, itemSize) {
  const values = new Float32Array(vertices.length * itemSize);
  vertices.forEach((vertex, i) => {
    for (let k = 0; k < Math.min(itemSize, attribute.itemSize); k += 1) {
      values[i * itemSize + k] = attribute.array[vertex * attribute.itemSize + k];
    }
  });
  return values;
}

/**
 * @template {Floats} Numbers
 * @param {Numbers} positions of the mesh
 * @param {Uint32Array} vertices
 * @returns {Numbers}
 */
export function pickedPositions(positions, vertices) {
  const picks = new (/** @type {any} */ (positions.constructor))(3 * vertices.length);
  vertices.forEach((vertex, i) => picks.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
  return picks;
}
