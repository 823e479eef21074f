// SPDX-License-Identifier: MIT
// The meshes of a scene in three.js, in parts that are remeshed as one each. GLTFLoader makes
// siblings of the primitives of one mesh: meshes of one parent at one place, which share borders.
// They are one part, lest these crack; a geometry is in one part only, so that meshes that share it
// still do.

import { Matrix4 } from 'three';

/** @import { BufferGeometry, InstancedMesh, Mesh, Object3D, SkinnedMesh } from 'three' */

/**
 * @typedef {object} ScenePart
 * @property {BufferGeometry[]} geometries
 * @property {ArrayLike<number>[]} places
 */

/** @param {BufferGeometry} geometry */
const hasTriangles = ({ index, attributes: { position }, drawRange }) =>
  position && Math.min(index?.count ?? position.count, drawRange.count) >= 3;

/** A surface of triangles, not lines in disguise. @param {any} object @returns {object is Mesh} */
const isSurface = (object) => Boolean(object.isMesh && object.geometry?.isBufferGeometry
  && hasTriangles(object.geometry) && !object.isBatchedMesh && !object.isLineSegments2
  && !object.isWireframe);

/** @param {Object3D} object @returns {Mesh[]} */
export function surfacesIn(object) {
  /** @type {Mesh[]} */
  const surfaces = [];
  object.traverse((child) => {
    if (isSurface(child)) surfaces.push(child);
  });
  return surfaces;
}

/** @param {Matrix4} matrix made of affine ones: what rounding left in its last row goes */
function affine({ elements }) {
  return elements.map((value, i) => (i % 4 === 3 ? Number(i === 15) : value));
}

/** Where its joints carry a skinned mesh at rest: usually all alike. @param {SkinnedMesh} mesh */
function skinnedPlace(mesh) {
  const { bones: [bone], boneInverses: [inverse] } = mesh.skeleton;
  if (!bone || !inverse) return mesh.matrixWorld;
  const place = new Matrix4().multiplyMatrices(bone.matrixWorld, inverse)
    .multiply(mesh.bindMatrix);
  if (mesh.bindMode !== 'detached') return place;
  return place.premultiply(mesh.bindMatrixInverse).premultiply(mesh.matrixWorld);
}

/** @param {any} mesh @returns {number[][]} */
function placesOf(mesh) {
  if (mesh.isSkinnedMesh && mesh.skeleton) return [affine(skinnedPlace(mesh))];
  if (!mesh.isInstancedMesh) return [affine(mesh.matrixWorld)];
  const instanced = /** @type {InstancedMesh} */ (mesh);
  return Array.from({ length: instanced.count }, (_, i) => {
    const matrix = new Matrix4();
    instanced.getMatrixAt(i, matrix);
    return affine(matrix.premultiply(instanced.matrixWorld));
  });
}

/** Meshes of the same are seen as one surface. @param {any} mesh */
function siblingKey(mesh) {
  if (mesh.isInstancedMesh || !mesh.parent || 'isInstancedBufferGeometry' in mesh.geometry) {
    return mesh.uuid;
  }
  return [mesh.parent.uuid, mesh.skeleton?.uuid, ...(mesh.bindMatrix?.elements ?? []),
    ...mesh.matrix.elements].join();
}

/** @template Item @param {Item[]} items @param {(item: Item) => string} keyOf */
function grouped(items, keyOf) {
  /** @type {Map<string, Item[]>} */
  const groups = new Map();
  for (const item of items) {
    const key = keyOf(item);
    groups.set(key, [...groups.get(key) ?? [], item]);
  }
  return [...groups.values()];
}

/** @param {Iterable<BufferGeometry>} geometries */
const keyOfSet = (geometries) => [...geometries].map(({ uuid }) => uuid).sort().join();

/** @typedef {{ geometries: BufferGeometry[], mesh: Mesh }} Cluster */

/** A geometry that is in company of several kinds is on its own. @param {Cluster[]} clusters */
function withoutConflicts(clusters) {
  /** @type {Map<BufferGeometry, string>} */
  const companyOf = new Map();
  /** @type {Set<BufferGeometry>} */
  const torn = new Set();
  for (const { geometries } of clusters) {
    const key = keyOfSet(geometries);
    for (const geometry of geometries) {
      if ((companyOf.get(geometry) ?? key) !== key) torn.add(geometry);
      companyOf.set(geometry, key);
    }
  }
  return clusters.flatMap(({ geometries, mesh }) => [
    geometries.filter((geometry) => !torn.has(geometry)),
    ...geometries.filter((geometry) => torn.has(geometry)).map((geometry) => [geometry]),
  ].filter((company) => company.length > 0).map((company) => ({ geometries: company, mesh })));
}

/** @param {Mesh[]} surfaces their world matrices being up to date @returns {ScenePart[]} */
export function sceneParts(surfaces) {
  const clusters = grouped(surfaces, siblingKey).map((meshes) => ({
    geometries: [...new Set(meshes.map(({ geometry }) => geometry))], mesh: meshes[0],
  }));
  return grouped(withoutConflicts(clusters), ({ geometries }) => keyOfSet(geometries))
    .map((same) => ({
      geometries: same[0].geometries, places: same.flatMap(({ mesh }) => placesOf(mesh)),
    }));
}
