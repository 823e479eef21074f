// SPDX-License-Identifier: MIT
// The public functions of arrays, for any platform. Each checks and copies what the caller gave and
// hands a job to the client.

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { buffersOf, copyMesh, copyScene } from './inputs.js';
import { checkOptions, requireObject } from '../base/options.js';
import { compileBinary } from './wasm_source.js';

/** @import { EngineName, Inspection, Mesh, PlacedMesh } from '../base/messages.js' */
/** @import { RemeshReport } from '../base/messages.js' */
/** @import { RemeshOptions } from '../base/options.js' */
/** @import { Client, Platform, RunOptions } from './client.js' */
/** @import { Compile } from './modules.js' */

/** @typedef {Pick<Client, 'bring' | 'modules' | 'warmUp' | 'run'>} Runner */

/**
 * @typedef {object} WasmSource
 * @property {string | URL} [wasmUrl] Where the WebAssembly is, if not beside the script.
 * @property {BufferSource} [wasmBinary] Its bytes, if they are there already.
 */

/**
 * @typedef {object} RemeshResult
 * @property {Mesh} mesh Arrays of the types that were given.
 * @property {RemeshReport} report What went in, what came out, and how far the two are apart.
 * @property {Mesh[]} lods The levels of detail that were asked for.
 */

/**
 * @typedef {object} RemeshSceneResult
 * @property {Mesh[]} meshes In the order given, arrays of the types that were given.
 * @property {RemeshReport} report On all of them together.
 * @property {Mesh[][]} lods The same meshes for each level of detail that was asked for.
 */

export const runNames =
  /** @type {const} */ (['signal', 'onProgress', 'worker']);

/** Each function is documented where it is exported, in arrays.js and index.js. */
export class ArraysApi {
  #platform;
  #client;

  /** @param {Platform} platform @param {Runner} client who runs the jobs */
  constructor(platform, client) {
    this.#platform = platform;
    this.#client = client;
  }

  /**
   * @param {WasmSource} [options]
   * @returns {Promise<void>}
   */
  async init(options = {}) {
    refuseOthers(options, ['wasmUrl', 'wasmBinary']);
    await start(this.#client, 'arrays', compilerOf(options, this.#platform));
  }

  /**
   * @param {Mesh} mesh
   * @param {RemeshOptions & RunOptions} [options]
   * @returns {Promise<RemeshResult>}
   */
  async remesh(mesh, options = {}) {
    const checked = checkOptions(options, { others: runNames });
    const { meshes, report, lods } =
      await this.#runScene([{ mesh: copyMesh(mesh) }], checked, options);
    return { mesh: meshes[0], report, lods: lods.map(([lod]) => lod) };
  }

  /**
   * @param {PlacedMesh[]} parts
   * @param {RemeshOptions & RunOptions} [options]
   * @returns {Promise<RemeshSceneResult>}
   */
  async remeshScene(parts, options = {}) {
    const checked = checkOptions(options, { others: runNames });
    return this.#runScene(copyScene(parts), checked, options);
  }

  /**
   * @param {Mesh} mesh
   * @param {RunOptions} [options]
   * @returns {Promise<Inspection>}
   */
  async inspect(mesh, options = {}) {
    refuseOthers(options, runNames);
    const copy = copyMesh(mesh);
    return this.#client.run({ kind: 'inspect', mesh: copy }, buffersOf(copy), options);
  }

  /**
   * @param {PlacedMesh[]} parts our own
   * @param {Record<string, unknown>} checked
   * @param {RunOptions} options
   * @returns {Promise<RemeshSceneResult>}
   */
  #runScene(parts, checked, options) {
    return this.#client.run({ kind: 'remesh', parts, options: checked },
      parts.flatMap(({ mesh }) => buffersOf(mesh)), options);
  }
}

/** @param {unknown} wasmUrl @param {unknown} wasmBinary */
function checkSource(wasmUrl, wasmBinary) {
  if (wasmUrl !== undefined && typeof wasmUrl !== 'string' && !(wasmUrl instanceof URL)) {
    throw new RemeshError('INVALID_OPTION', 'wasmUrl must be a string or a URL.');
  }
  if (wasmBinary !== undefined && !ArrayBuffer.isView(wasmBinary)
    && !(wasmBinary instanceof ArrayBuffer)) {
    throw new RemeshError('INVALID_OPTION', 'wasmBinary must be an ArrayBuffer or a typed array.');
  }
}

/**
 * A function that compiles the module of a source; undefined if the source names none.
 * @param {WasmSource} source
 * @param {Platform} platform
 * @returns {Compile | undefined}
 */
export function compilerOf({ wasmUrl, wasmBinary }, platform) {
  checkSource(wasmUrl, wasmBinary);
  if (wasmBinary) return () => compileBinary(wasmBinary, 'wasmBinary');
  return wasmUrl ? () => platform.compileUrl(wasmUrl) : undefined;
}

/**
 * Loads an engine, and starts the worker with it.
 * @param {Runner} client
 * @param {EngineName} engine
 * @param {Compile} [compile]
 */
export async function start(client, engine, compile) {
  await client.modules.load(engine, compile);
  await client.warmUp(engine);
}

/** @param {object} options @param {readonly string[]} known */
export function refuseOthers(options, known) {
  requireObject(options);
  const unknown = Object.keys(options).find((name) => !known.includes(name));
  if (unknown) {
    throw new RemeshError('UNKNOWN_OPTION', `There is no option ${legible(unknown)} here.`,
      `There are ${known.join(', ')}.`);
  }
}
