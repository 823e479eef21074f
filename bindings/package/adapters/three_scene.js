// SPDX-License-Identifier: MIT
// The meshes of a scene in three.js, in parts that are remeshed as one each. GLTFLoader makes
// siblings of the primitives of one mesh: meshes of one parent at one place, which share borders.
// They are one part, so that the borders do not crack. A geometry is in one part only, so that
// meshes that share it still do.

import { Matrix4 } from 'three';

/** @import { BufferGeometry, InstancedMesh, Mesh, Object3D, SkinnedMesh } from 'three' */

/**
 * @typedef {object} ScenePart
 * @property {BufferGeometry[]} geometries
 * @property {ArrayLike<number>[]} places
 * @property {number[]} finer the parts that it is a coarser level of detail of
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

/** Meshes of many geometries in one, which are left alone. @param {Object3D} object */
export function batchesIn(object) {
  let count = 0;
  object.traverse((/** @type {any} */ child) => { count += Number(Boolean(child.isBatchedMesh)); });
  return count;
}

/**
 * The LOD that shows the mesh, and the level it is; undefined if it is in no LOD or in several.
 * @param {Mesh} mesh @returns {{ lod: any, level: number } | undefined}
 */
function levelOf(mesh) {
  const found = [];
  for (let child = /** @type {any} */ (mesh); child.parent; child = child.parent) {
    const { parent } = child;
    const level = parent.isLOD
      ? parent.levels.findIndex((/** @type {any} */ { object }) => object === child) : -1;
    if (level >= 0) found.push({ lod: parent, level });
  }
  return found.length === 1 ? found[0] : undefined;
}

/**
 * For each part the first-level parts that it is a coarser level of; none unless all meshes with
 * its geometries are coarser levels of one LOD.
 * @param {Mesh[]} surfaces @param {{ geometries: BufferGeometry[] }[]} parts
 */
function finerParts(surfaces, parts) {
  const levels = surfaces.map((mesh) => ({ geometry: mesh.geometry, ...levelOf(mesh) }));
  return parts.map(({ geometries }) => {
    const own = levels.filter(({ geometry }) => geometries.includes(geometry));
    const [{ lod }] = own;
    if (!lod || !own.every((one) => one.lod === lod && (one.level ?? 0) > 0)) return [];
    const finest = new Set(levels.filter((one) => one.lod === lod && one.level === 0)
      .map(({ geometry }) => geometry));
    return parts.flatMap((part, i) =>
      (part.geometries.some((geometry) => finest.has(geometry)) ? [i] : []));
  });
}

/** @param {Matrix4} matrix made of affine ones: what rounding left in its last row goes */
function affine({ elements }) {
  return elements.map((value, i) => (i % 4 === 3 ? Number(i === 15) : value));
}

/** Where the first bone carries a skinned mesh at rest; usually all agree.
 * @param {SkinnedMesh} mesh */
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

/** Meshes with the same key are one surface; levels of a LOD are not. @param {any} mesh */
function siblingKey(mesh) {
  const isByItself = mesh.isInstancedMesh || 'isInstancedBufferGeometry' in mesh.geometry;
  if (isByItself || !mesh.parent || mesh.parent.isLOD) return mesh.uuid;
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

/** Separates geometries that have different companions. @param {Cluster[]} clusters */
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
  const parts = grouped(withoutConflicts(clusters), ({ geometries }) => keyOfSet(geometries))
    .map((same) => ({
      geometries: same[0].geometries, places: same.flatMap(({ mesh }) => placesOf(mesh)),
    }));
  const finer = finerParts(surfaces, parts);
  return parts.map((part, i) => ({ ...part, finer: finer[i] }));
}
