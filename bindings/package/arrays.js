// SPDX-License-Identifier: MIT
// remesher/arrays in browsers, and its documentation for every platform: the functions of arrays,
// for programs without files. Nothing here leads to the whole engine.

import { ArraysApi } from './api/arrays_api.js';
import * as platform from './platform_browser.js';

/**
 * The types of all inputs and results.
 * @typedef {import('./api/arrays_api.js').RemeshResult} RemeshResult
 * @typedef {import('./api/arrays_api.js').RemeshSceneResult} RemeshSceneResult
 * @typedef {import('./api/arrays_api.js').WasmSource} WasmSource
 * @typedef {import('./api/client.js').RunOptions} RunOptions
 * @typedef {import('./base/errors.js').ErrorCode} ErrorCode
 * @typedef {import('./base/guides.js').Guide} Guide
 * @typedef {import('./base/guides.js').GuideOrLine} GuideOrLine
 * @typedef {import('./base/messages.js').Distances} Distances
 * @typedef {import('./base/messages.js').Floats} Floats
 * @typedef {import('./base/messages.js').Indices} Indices
 * @typedef {import('./base/messages.js').Inspection} Inspection
 * @typedef {import('./base/messages.js').Memory} Memory
 * @typedef {import('./base/messages.js').Mesh} Mesh
 * @typedef {import('./base/messages.js').MeshAttribute} MeshAttribute
 * @typedef {import('./base/messages.js').MeshReport} MeshReport
 * @typedef {import('./base/messages.js').MinAngle} MinAngle
 * @typedef {import('./base/messages.js').NumberArray} NumberArray
 * @typedef {import('./base/messages.js').Phase} Phase
 * @typedef {import('./base/messages.js').PlacedMesh} PlacedMesh
 * @typedef {import('./base/messages.js').ProgressEvent} ProgressEvent
 * @typedef {import('./base/messages.js').RemeshReport} RemeshReport
 * @typedef {import('./base/messages.js').RepairSummary} RepairSummary
 * @typedef {import('./base/messages.js').RunReport} RunReport
 * @typedef {import('./base/messages.js').Timings} Timings
 * @typedef {import('./base/messages.js').Warning} Warning
 * @typedef {import('./base/remesh_options.js').RemeshOptions} RemeshOptions
 */

export { RemeshError } from './base/errors.js';

const api = new ArraysApi(platform, platform.client);

/**
 * Loads the small engine and starts the worker ahead of time. Optional, and cheap to repeat: the
 * first call decides where the engine comes from.
 *
 * @param {WasmSource} [options] Where remesher_arrays.wasm is; where bundlers put it, if not given.
 * @returns {Promise<void>} Once the next run can begin at once.
 */
export function init(options) {
  return api.init(options);
}

/**
 * Remeshes a mesh. Its arrays are copied, and stay the caller's.
 *
 * @example
 * const { mesh, report } = await remesh({ positions, indices }, { vertices: 10000 });
 *
 * @param {Mesh} mesh The surface: positions, triangles, and what else the vertices have.
 * @param {RemeshOptions & RunOptions} [options] What to make of it, and how to run.
 * @returns {Promise<RemeshResult>} The new mesh and a report. Rejects with a {@link RemeshError}.
 */
export function remesh(mesh, options) {
  return api.remesh(mesh, options);
}

/**
 * Remeshes the meshes of a scene, which share the targets as the meshes of one file do: vertices by
 * what charts need, then by area in the world.
 *
 * @example
 * const { meshes } = await remeshScene([{ mesh: body }, { mesh: lid, places: [matrix] }],
 *   { vertices: 10000 });
 *
 * @param {PlacedMesh[]} parts The meshes, and where they are shown.
 * @param {RemeshOptions & RunOptions} [options] What to make of them, and how to run.
 * @returns {Promise<RemeshSceneResult>} The new meshes and one report. Rejects with a
 *   {@link RemeshError}.
 */
export function remeshScene(parts, options) {
  return api.remeshScene(parts, options);
}

/**
 * Reports on a mesh; changes nothing.
 *
 * @example
 * const { input, warnings } = await inspect({ positions, indices });
 *
 * @param {Mesh} mesh The mesh.
 * @param {RunOptions} [options] How to run.
 * @returns {Promise<Inspection>} What there is. Rejects with a {@link RemeshError}.
 */
export function inspect(mesh, options) {
  return api.inspect(mesh, options);
}
