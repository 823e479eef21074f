// SPDX-License-Identifier: MIT
// remesher/gltf-transform: a transform for documents of glTF-Transform.

import { createTransform } from '@gltf-transform/functions';
import { remeshScene } from 'remesher/arrays';

import { RemeshError } from '../base/errors.js';
import { checkOptions, refuseLods } from '../base/options.js';
import { placesOfMeshes } from './gltf_places.js';
import { isTriangles, readPart, writePart } from './gltf_primitives.js';
import { joined } from './vertex_pools.js';

/** @import { Document, ILogger, Transform } from '@gltf-transform/core' */
/** @import { RemeshOptions, RemeshReport, RunOptions } from 'remesher' */

const name = 'remesh';

/** @param {ILogger} logger @param {RemeshReport} report */
function log(logger, { input, output, fidelity, warnings }) {
  for (const { message, count } of warnings) logger.warn(`${name}: ${message} (${count})`);
  logger.debug(`${name}: ${input.vertices} → ${output.vertices} vertices, `
    + `Hausdorff distance ${fidelity.hausdorff.toFixed(3)} % of the diagonal.`);
}

/** @param {Document} document */
function partsOf(document) {
  if (document.getRoot().listExtensionsUsed()
    .some(({ extensionName }) => extensionName === 'KHR_mesh_primitive_restart')) {
    throw new RemeshError('UNSUPPORTED', `${name}: KHR_mesh_primitive_restart is not supported.`);
  }
  const meshes = document.getRoot().listMeshes();
  const primitives = meshes.flatMap((mesh) => mesh.listPrimitives());
  const others = primitives.filter((primitive) => !isTriangles(primitive)).length;
  if (others > 0) {
    document.getLogger().warn(
      `${name}: Primitives without triangles were skipped (${others}).`);
  }
  return meshes.map(readPart).filter(({ streams }) => streams.some(({ pool }) =>
    [...pool.triangles.values()].some(({ length }) => length > 0)));
}

/**
 * Remeshes the triangles of a document: evenly shaped ones, an exact number of vertices, shared out
 * among the meshes by what charts need, then by area in the scene. The primitives of a mesh are one
 * surface, their borders kept. Attributes keep their component types; skins, morph targets,
 * instances and variants stay. Positions in integers become floats where they would be too coarse.
 * Points and lines are left alone, and so are extensions. With `quads: true` two triangles in a
 * row, from the same first corner, are a quad, and the primitive's extras say `quads: true`. Quads
 * and repair are in the whole engine: import 'remesher' as well.
 *
 * @example
 * import { remesh } from 'remesher/gltf-transform';
 * await document.transform(remesh({ ratio: 0.5 }), textureCompress({ encoder: sharp }));
 *
 * @param {Omit<RemeshOptions, 'lods'> & RunOptions} [options] Options of remeshing and of the run.
 * @returns {Transform} For `document.transform(…)`, which rejects with a `RemeshError`; then
 *   nothing has changed.
 */
export function remesh(options = {}) {
  refuseLods(options);
  checkOptions(options, { others: ['signal', 'onProgress', 'worker'] });
  return createTransform(name, async (document) => {
    const logger = document.getLogger();
    const parts = partsOf(document);
    if (parts.length === 0) {
      logger.warn(`${name}: There are no triangles.`);
      return;
    }
    const places = placesOfMeshes(document);
    const { meshes, report } = await remeshScene(parts.map(({ mesh, streams }) => ({
      mesh: joined(streams.map(({ pool }) => pool)), places: places.get(mesh) ?? [],
    })), { units: 'm', ...options });
    parts.forEach((part, i) => writePart(document, part, meshes[i]));
    log(logger, report);
  });
}
