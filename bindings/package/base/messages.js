// SPDX-License-Identifier: MIT
// The shapes that travel: a job goes to an engine, here or in a worker; an outcome comes back.
// Everything here survives structured cloning.

/** @typedef {Float32Array | Float64Array} Floats */
/** @typedef {Uint32Array | Uint16Array} Indices */
/**
 * @typedef {Float32Array | Float64Array | Int8Array | Uint8Array | Uint8ClampedArray | Int16Array
 *   | Uint16Array | Int32Array | Uint32Array} NumberArray
 */

/**
 * Per-vertex values by glTF semantic: NORMAL, TEXCOORD_0, COLOR_0, JOINTS_0, …
 * @typedef {{ array: NumberArray, itemSize: number }} MeshAttribute
 */

/**
 * @typedef {object} Mesh
 * @property {Floats} positions three coordinates per vertex
 * @property {Indices} indices three vertices per triangle, counterclockwise from outside
 * @property {Record<string, MeshAttribute>} [attributes]
 */

/** @typedef {{ name: string, bytes: Uint8Array }} NamedBytes */

/**
 * What an engine is asked to do.
 * @typedef {{ kind: 'remesh', mesh: Mesh, options: Record<string, unknown> }
 *   | { kind: 'remeshFile', file: FileRequest, options: Record<string, unknown> }
 *   | { kind: 'convertFile', file: FileRequest }
 *   | { kind: 'inspect', mesh: Mesh }
 *   | { kind: 'inspectFile', file: FileRequest }} Job
 */

/** @typedef {NamedBytes & { resources: NamedBytes[], output: string }} FileRequest */

/** @typedef {{ phase: string, fraction: number }} ProgressEvent */
/** @typedef {{ code: import('./errors.js').ErrorCode, message: string, hint: string }} Failure */

/**
 * To the worker: first the compiled module, then jobs, one at a time.
 * @typedef {{ type: 'start', module: WebAssembly.Module }
 *   | { type: 'job', job: Job, progress: boolean }} ToWorker
 */

/**
 * From the worker: any number of progress events, then one outcome for each job.
 * @typedef {{ type: 'progress', event: ProgressEvent }
 *   | { type: 'done', result: any }
 *   | { type: 'failed', failure: Failure }} FromWorker
 */

/**
 * @typedef {object} MeshReport
 * @property {number} vertices distinct positions
 * @property {number} triangles
 * @property {number} components
 * @property {number} boundaryEdges
 * @property {number} nonManifoldEdges
 * @property {number} eulerCharacteristic
 * @property {number} degenerateTriangles
 * @property {{ worst: number, mean: number, histogram: number[] }} minAngle degrees; the histogram
 *   in percent of the triangles, 0–10 … 50–60
 * @property {number} maxAngle degrees
 * @property {number} valence6 percent of the interior vertices
 */

/** @typedef {{ code: string, message: string, count: number }} Warning */

/**
 * @typedef {object} Inspection
 * @property {string} version
 * @property {MeshReport} input
 * @property {{ read: number, build: number, remesh: number, write: number }} timings milliseconds
 * @property {{ peakBytes: number }} memory
 * @property {{ name: string, milliseconds: number }[]} phases in order; together they are the run
 * @property {Warning[]} warnings
 */

/**
 * @typedef {object} RunPart
 * @property {MeshReport} output
 * @property {{ hausdorff: number, rms: number }} fidelity two-sided, percent of the diagonal of the
 *   original's bounding box; the largest distance is the largest that samples find
 * @property {'target' | 'fidelity' | 'max-error' | 'cancelled'} stopped what ended the run
 */

/** @typedef {Inspection & RunPart} RemeshReport */

export {};
