// SPDX-License-Identifier: MIT
// The package in browsers, and the documentation of its functions for every platform. The
// `new URL(…, import.meta.url)` is written out so that bundlers see it.

import { Api } from './api/api.js';
import * as platform from './platform_browser.js';

/**
 * The types of all inputs and results.
 * @typedef {import('./api/api.js').AtlasFileResult} AtlasFileResult
 * @typedef {import('./api/api.js').BakeFileOptions} BakeFileOptions
 * @typedef {import('./api/api.js').BakeOptions} BakeOptions
 * @typedef {import('./api/api.js').BakeResult} BakeResult
 * @typedef {import('./api/api.js').BakedMap} BakedMap
 * @typedef {import('./api/api.js').BooleanFilesResult} BooleanFilesResult
 * @typedef {import('./api/api.js').BooleanResult} BooleanResult
 * @typedef {import('./api/api.js').ConvertFileResult} ConvertFileResult
 * @typedef {import('./api/api.js').ConvertOptions} ConvertOptions
 * @typedef {import('./api/api.js').InitOptions} InitOptions
 * @typedef {import('./api/api.js').InspectOptions} InspectOptions
 * @typedef {import('./api/api.js').OperandOptions} OperandOptions
 * @typedef {import('./api/api.js').RemeshFileResult} RemeshFileResult
 * @typedef {import('./api/api.js').RepairFileResult} RepairFileResult
 * @typedef {import('./api/arrays_api.js').RemeshResult} RemeshResult
 * @typedef {import('./api/arrays_api.js').RemeshSceneResult} RemeshSceneResult
 * @typedef {import('./api/api.js').RepairOptions} RepairOptions
 * @typedef {import('./api/api.js').RepairResult} RepairResult
 * @typedef {import('./api/api.js').UnwrapOptions} UnwrapOptions
 * @typedef {import('./api/api.js').UnwrapResult} UnwrapResult
 * @typedef {import('./api/arrays_api.js').WasmSource} WasmSource
 * @typedef {import('./api/client.js').RunOptions} RunOptions
 * @typedef {import('./api/inputs.js').Bytes} Bytes
 * @typedef {import('./api/inputs.js').FileOptions} FileOptions
 * @typedef {import('./api/inputs.js').OutputOptions} OutputOptions
 * @typedef {import('./base/errors.js').ErrorCode} ErrorCode
 * @typedef {import('./base/guides.js').Guide} Guide
 * @typedef {import('./base/guides.js').GuideOrLine} GuideOrLine
 * @typedef {import('./base/messages.js').AtlasReport} AtlasReport
 * @typedef {import('./base/messages.js').AtlasSummary} AtlasSummary
 * @typedef {import('./base/messages.js').BooleanOperation} BooleanOperation
 * @typedef {import('./base/messages.js').BooleanReport} BooleanReport
 * @typedef {import('./base/messages.js').BooleanSummary} BooleanSummary
 * @typedef {import('./base/messages.js').Card} Card
 * @typedef {import('./base/messages.js').CardSide} CardSide
 * @typedef {import('./base/messages.js').Compression} Compression
 * @typedef {import('./base/messages.js').Distances} Distances
 * @typedef {import('./base/messages.js').EdgeSummary} EdgeSummary
 * @typedef {import('./base/messages.js').FaultSummary} FaultSummary
 * @typedef {import('./base/messages.js').Floats} Floats
 * @typedef {import('./base/messages.js').Indices} Indices
 * @typedef {import('./base/messages.js').Inspection} Inspection
 * @typedef {import('./base/messages.js').Memory} Memory
 * @typedef {import('./base/messages.js').Mesh} Mesh
 * @typedef {import('./base/messages.js').MeshAttribute} MeshAttribute
 * @typedef {import('./base/messages.js').MeshReport} MeshReport
 * @typedef {import('./base/messages.js').MinAngle} MinAngle
 * @typedef {import('./base/messages.js').NamedBytes} NamedBytes
 * @typedef {import('./base/messages.js').NumberArray} NumberArray
 * @typedef {import('./base/messages.js').Phase} Phase
 * @typedef {import('./base/messages.js').PlacedMesh} PlacedMesh
 * @typedef {import('./base/messages.js').ProgressEvent} ProgressEvent
 * @typedef {import('./base/messages.js').RemeshReport} RemeshReport
 * @typedef {import('./base/messages.js').RepairReport} RepairReport
 * @typedef {import('./base/messages.js').RepairSummary} RepairSummary
 * @typedef {import('./base/messages.js').RunReport} RunReport
 * @typedef {import('./base/messages.js').Switch} Switch
 * @typedef {import('./base/messages.js').Texture} Texture
 * @typedef {import('./base/messages.js').Timings} Timings
 * @typedef {import('./base/messages.js').Warning} Warning
 * @typedef {import('./base/remesh_options.js').RemeshOptions} RemeshOptions
 */

export { RemeshError } from './base/errors.js';

const compileWhole = () => platform.compileUrl(new URL('./remesher.wasm', import.meta.url));
const api = new Api({ ...platform, compileWhole }, platform.client);

/**
 * Loads the whole engine, which serves files and arrays, and starts the worker ahead of time; with
 * `arrays` it loads the small engine, which serves until the first file. Optional, and cheap to
 * repeat: the first call decides where an engine comes from.
 *
 * @param {InitOptions} [options] Where the WebAssembly is; where bundlers put it, if not given.
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
 * Remeshes a file, given and returned as bytes.
 *
 * @example
 * const { bytes } = await remeshFile(file, { output: 'glb', vertices: 10000 });
 *
 * @param {Bytes} bytes The file.
 * @param {RemeshOptions & FileOptions & OutputOptions & RunOptions} [options] What to make of it,
 *   its name, the result's name, and how to run.
 * @returns {Promise<RemeshFileResult>} The new file and a report. Rejects with a
 *   {@link RemeshError}.
 */
export function remeshFile(bytes, options) {
  return api.remeshFile(bytes, options);
}

/**
 * Mends a mesh and does no more: its triangles stay as they are where nothing was broken. The
 * arrays are copied, and stay the caller's.
 *
 * @example
 * const { mesh, report } = await repair({ positions, indices }, { holesUpTo: 5 });
 *
 * @param {Mesh} mesh The surface, as remesh takes it.
 * @param {RepairOptions & RunOptions} [options] How to mend it, and how to run.
 * @returns {Promise<RepairResult>} The mended mesh and a report. Rejects with a
 *   {@link RemeshError}.
 */
export function repair(mesh, options) {
  return api.repair(mesh, options);
}

/**
 * Mends a file, given and returned as bytes, and does no more.
 *
 * @example
 * const { bytes } = await repairFile(file, { name: 'scan.stl', output: 'stl' });
 *
 * @param {Bytes} bytes The file.
 * @param {RepairOptions & FileOptions & OutputOptions & RunOptions} [options] How to mend it, its
 *   name, the result's name, and how to run.
 * @returns {Promise<RepairFileResult>} The mended file and a report. Rejects with a
 *   {@link RemeshError}.
 */
export function repairFile(bytes, options) {
  return api.repairFile(bytes, options);
}

/**
 * The union, difference or intersection of two bodies, exactly, with the attributes of both: what
 * one mesh lacks is white for colours, flat for normals, else zero. Triangles that nothing cuts
 * stay as they are. A mesh that is not closed, faces inwards or intersects itself counts as the
 * bodies that `repair` finds in it without remaking it. The arrays are copied, and stay the
 * caller's.
 *
 * @example
 * const { mesh } = await boolean(block, drill, 'subtract');
 *
 * @param {Mesh} a The first mesh, as remesh takes it.
 * @param {Mesh} b The second mesh, which `subtract` takes away from the first.
 * @param {BooleanOperation} operation What to make of them.
 * @param {RunOptions} [options] How to run.
 * @returns {Promise<BooleanResult>} The new mesh and a report. Rejects with a {@link RemeshError}.
 */
export function boolean(a, b, operation, options) {
  return api.boolean(a, b, operation, options);
}

/**
 * The union, difference or intersection of all that two files show, given and returned as bytes.
 *
 * @example
 * const { bytes } = await booleanFiles(block, drill, 'subtract', { output: 'part.glb' });
 *
 * @param {Bytes} a The first file.
 * @param {Bytes} b The second file.
 * @param {BooleanOperation} operation What to make of them.
 * @param {OperandOptions & OutputOptions & RunOptions} [options] The files' names, the result's
 *   name, and how to run.
 * @returns {Promise<BooleanFilesResult>} The new file and a report. Rejects with a
 *   {@link RemeshError}.
 */
export function booleanFiles(a, b, operation, options) {
  return api.booleanFiles(a, b, operation, options);
}

/**
 * Paints one mesh onto another: its colours, and its shape as a normal map. The low mesh keeps its
 * triangles and its vertices, in their order; its texture coordinates too, unless they overlap:
 * then, or if it has none, it gets new ones. The arrays are copied, and stay the caller's.
 *
 * @example
 * const { mesh, maps } = await bake(sculpture, lowPoly, { textureSize: 1024 });
 *
 * @param {Mesh} high The mesh to paint from; `COLOR_0` becomes `maps.baseColor`.
 * @param {Mesh} low The mesh to paint onto.
 * @param {BakeOptions & RunOptions} [options] How to paint, and how to run.
 * @returns {Promise<BakeResult>} The low mesh with texture coordinates, and its maps. Rejects with
 *   a {@link RemeshError}.
 */
export function bake(high, low, options) {
  return api.bake(high, low, options);
}

/**
 * Paints all that one file shows onto the meshes of another: colours, roughness and metal, light,
 * normals. The result is the low file as glTF.
 *
 * @example
 * const { bytes } = await bakeFile(high, low, { name: 'high.glb', nameLow: 'low.obj' });
 *
 * @param {Bytes} high The file to paint from.
 * @param {Bytes} low The file to paint onto.
 * @param {BakeOptions & BakeFileOptions & OutputOptions & RunOptions} [options] How to paint, the
 *   files' names, the result's name, and how to run.
 * @returns {Promise<AtlasFileResult>} The new file and a report. Rejects with a
 *   {@link RemeshError}.
 */
export function bakeFile(high, low, options) {
  return api.bakeFile(high, low, options);
}

/**
 * Gives a mesh new texture coordinates, as `TEXCOORD_0`: charts without overlap in one square. Its
 * triangles stay, and its vertices in their order, before copies of those on seams. The arrays are
 * copied, and stay the caller's.
 *
 * @example
 * const { mesh, report } = await unwrap({ positions, indices });
 *
 * @param {Mesh} mesh The surface, as remesh takes it.
 * @param {UnwrapOptions & RunOptions} [options] The size of the square, and how to run.
 * @returns {Promise<UnwrapResult>} The mesh and a report. Rejects with a {@link RemeshError}.
 */
export function unwrap(mesh, options) {
  return api.unwrap(mesh, options);
}

/**
 * Gives a file new texture coordinates: all its meshes together, in one square.
 *
 * @example
 * const { bytes } = await unwrapFile(file, { name: 'low.obj', output: 'obj' });
 *
 * @param {Bytes} bytes The file.
 * @param {UnwrapOptions & FileOptions & OutputOptions & RunOptions} [options] The size of the
 *   square, the file's name, the result's name, and how to run.
 * @returns {Promise<AtlasFileResult>} The new file and a report. Rejects with a
 *   {@link RemeshError}.
 */
export function unwrapFile(bytes, options) {
  return api.unwrapFile(bytes, options);
}

/**
 * Writes a file in another format; its triangles stay as they are.
 *
 * @example
 * const { bytes } = await convertFile(file, { output: 'glb' });
 *
 * @param {Bytes} bytes The file.
 * @param {ConvertOptions & FileOptions & OutputOptions & RunOptions} [options] How to compress it,
 *   its name, the result's name, and how to run.
 * @returns {Promise<ConvertFileResult>} The new file. Rejects with a {@link RemeshError}.
 */
export function convertFile(bytes, options) {
  return api.convertFile(bytes, options);
}

/**
 * Reports on a file or a mesh; changes nothing. With `faults` it also reports what is broken and
 * what would mend it; with `edges`, of a mesh, which edges are open, bad or bent.
 *
 * @example
 * const { input, warnings } = await inspect(file);
 *
 * @param {Bytes | Mesh} bytesOrMesh The file, or the mesh.
 * @param {InspectOptions & FileOptions & RunOptions} [options] Whether to look for faults, the
 *   file's name, and how to run.
 * @returns {Promise<Inspection>} What there is. Rejects with a {@link RemeshError}.
 */
export function inspect(bytesOrMesh, options) {
  return api.inspect(bytesOrMesh, options);
}
