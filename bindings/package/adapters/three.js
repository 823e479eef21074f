// SPDX-License-Identifier: MIT
// remesher/three: geometries and scenes of three.js.

import { remeshScene } from 'remesher/arrays';

import { RemeshError } from '../base/errors.js';
import { refuseLods } from '../base/options.js';
import { readPart, writePart } from './three_geometry.js';
import { batchesIn, sceneParts, surfacesIn } from './three_scene.js';
import { joined } from './vertex_pools.js';

/** @import { BufferGeometry, Mesh, Object3D } from 'three' */
/** @import { RemeshOptions, RemeshReport, RunOptions } from 'remesher' */

export { quadEdges, quadsOf } from './three_quads.js';

/**
 * @typedef {object} RemeshGeometryResult
 * @property {BufferGeometry} geometry A new one, indexed.
 * @property {RemeshReport} report What went in, what came out, and how far the two are apart.
 */

/**
 * @typedef {object} RemeshObjectResult
 * @property {RemeshReport} report On all meshes together.
 */

/**
 * Remeshes a geometry. Every attribute comes back in its type, morph targets too; groups, name,
 * `userData` and what is instanced stay. Only triangles in its draw range count. Interleaved
 * attributes come back separate, and positions in integers become floats where they would be too
 * coarse. With `quads: true` two triangles in a row are a quad, and `userData.quads` is true:
 * `quadsOf` tells their corners, `quadEdges` draws their edges. Quads and repair are in the whole
 * engine: import 'remesher' as well.
 *
 * @example
 * const { geometry } = await remeshGeometry(mesh.geometry, { vertices: 10000 });
 *
 * @param {BufferGeometry} geometry The surface; it stays as it is.
 * @param {Omit<RemeshOptions, 'lods'> & RunOptions} [options] What to make of it, and how to run.
 * @returns {Promise<RemeshGeometryResult>} The new geometry and a report. Rejects with a
 *   `RemeshError`.
 */
export async function remeshGeometry(geometry, options) {
  refuseLods(options);
  const part = readPart([geometry]);
  const { meshes: [mesh], report } = await remeshScene([{ mesh: joined(part.pools) }], options);
  const [result] = writePart(part, mesh).values();
  return { geometry: result, report };
}

/** Skinned and instanced meshes have bounds of their own. @param {any} mesh */
function renewBounds(mesh) {
  if (mesh.boundingBox) mesh.computeBoundingBox();
  if (mesh.boundingSphere) mesh.computeBoundingSphere();
}

/** @param {Mesh[]} surfaces @param {Map<BufferGeometry, BufferGeometry>} replacements */
function replace(surfaces, replacements) {
  for (const mesh of surfaces) {
    mesh.geometry = replacements.get(mesh.geometry) ?? mesh.geometry;
    renewBounds(mesh);
    // What GLTFLoader says of quads in the file: true of the new ones only if they are quads too.
    if (!mesh.geometry.userData.quads) delete mesh.userData.gltfExtensions?.FB_ngon_encoding;
  }
  for (const old of replacements.keys()) old.dispose();
}

/**
 * Remeshes all meshes of an object and below, in place: each gets a new geometry once all are
 * there, and the old ones are disposed of. Meshes that share a geometry still do; skins, instances,
 * morph targets and materials stay. Vertices are shared out by what charts need, then by area
 * in the world. Meshes of one parent at one place, as GLTFLoader makes of several materials, are
 * one surface. The levels of a LOD keep their proportions: numbers are the first level's. Lines,
 * points and sprites are left alone, and so are batched meshes, which a warning names.
 *
 * @example
 * const { scene } = await new GLTFLoader().loadAsync('helmet.glb');
 * const { report } = await remeshObject(scene, { ratio: 0.5 });
 *
 * @param {Object3D} object A scene, a group, a mesh.
 * @param {Omit<RemeshOptions, 'lods'> & RunOptions} [options] What to make of it, and how to run.
 * @returns {Promise<RemeshObjectResult>} A report. Rejects with a `RemeshError`; then nothing has
 *   changed.
 */
export async function remeshObject(object, options) {
  refuseLods(options);
  if (!(/** @type {any} */ (object)?.isObject3D)) {
    throw new RemeshError('INVALID_MESH', 'The object must be an Object3D of three.js.');
  }
  object.updateWorldMatrix(true, true);
  const surfaces = surfacesIn(object);
  if (surfaces.length === 0) {
    throw new RemeshError('NO_TRIANGLES', 'There are no meshes of triangles in the object.');
  }
  const parts = sceneParts(surfaces)
    .map(({ geometries, ...seen }) => ({ part: readPart(geometries), seen }));
  const { meshes, report } = await remeshScene(
    parts.map(({ part, seen }) => ({ mesh: joined(part.pools), ...seen })), options);
  replace(surfaces, new Map(parts.flatMap(({ part }, i) => [...writePart(part, meshes[i])])));
  const batches = batchesIn(object);
  if (batches > 0) {
    report.warnings.push({ code: 'NOT_TRIANGLES', count: batches, message: 'Batched meshes are '
      + 'not remeshed: give their geometries to remeshGeometry before they are batched.' });
  }
  return { report };
}
