// SPDX-License-Identifier: MIT
// The public functions, for whichever platform they are made: each has what the caller gave checked
// and copied, and hands a job to the client.

import { Client } from './client.js';
import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import {
  buffersOf, copyMesh, copyScene, fileBuffers, fileRequest, isBytes,
} from './inputs.js';
import { checkOptions, checkRepair, requireObject } from '../base/options.js';
import { compileBinary } from './wasm_source.js';

/** @import { Inspection, Mesh, NamedBytes, PlacedMesh } from '../base/messages.js' */
/** @import { RemeshReport, RepairReport, Warning } from '../base/messages.js' */
/** @import { RemeshOptions } from '../base/options.js' */
/** @typedef {Pick<RemeshOptions, 'repair' | 'holesUpTo' | 'gap'>} RepairOptions */
/** @import { Platform, RunOptions } from './client.js' */
/** @import { Bytes, FileOptions, OutputOptions } from './inputs.js' */

/**
 * @typedef {object} InitOptions
 * @property {string | URL} [wasmUrl] Where remesher.wasm is, if not beside the script.
 * @property {BufferSource} [wasmBinary] Its bytes, if they are there already.
 * @property {import('./client.js').Codecs} [codecs] What `remesher/codecs` exports: images are
 *   decoded and encoded by what the bundler has put beside the worker.
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

/**
 * @typedef {object} ConvertFileResult
 * @property {string} name The file's name.
 * @property {Uint8Array} bytes The file.
 * @property {NamedBytes[]} files This file first, then those it refers to (a .bin, a .mtl) and
 *   those of levels of detail, by names that lead nowhere but into one folder.
 * @property {Warning[]} warnings What the result lacks.
 */

/**
 * @typedef {Omit<ConvertFileResult, 'warnings'> & Pick<RemeshResult, 'report'>}
 *   RemeshFileResult
 */

/**
 * @typedef {object} RepairResult
 * @property {Mesh} mesh Arrays of the types that were given.
 * @property {RepairReport} report What went in, what was mended, what came out.
 */

/**
 * @typedef {Omit<ConvertFileResult, 'warnings'> & Pick<RepairResult, 'report'>}
 *   RepairFileResult
 */

const runNames = /** @type {const} */ (['signal', 'onProgress', 'worker']);
const fileNames = /** @type {const} */ (['name', 'resources']);

/** What each function does is said where it is exported, in index.js. */
export class Api {
  #platform;
  #client;

  /**
   * @param {Platform} platform
   * @param {Pick<Client, 'bring' | 'load' | 'warmUp' | 'run'>} [client] who runs the jobs
   */
  constructor(platform, client = new Client(platform)) {
    this.#platform = platform;
    this.#client = client;
  }

  /**
   * @param {InitOptions} [options]
   * @returns {Promise<void>}
   */
  async init(options = {}) {
    refuseOthers(options, ['wasmUrl', 'wasmBinary', 'codecs']);
    const { wasmUrl, wasmBinary, codecs } = options;
    checkSource(wasmUrl, wasmBinary);
    if (codecs !== undefined) this.#client.bring(requireCodecs(codecs));
    if (wasmBinary) await this.#client.load(() => compileBinary(wasmBinary, 'wasmBinary'));
    else if (wasmUrl) await this.#client.load(() => this.#platform.compileUrl(wasmUrl));
    await this.#client.warmUp();
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
   * @param {Bytes} bytes
   * @param {RemeshOptions & FileOptions & OutputOptions & RunOptions} [options]
   * @returns {Promise<RemeshFileResult>}
   */
  async remeshFile(bytes, options = {}) {
    const checked = checkOptions(options, { others: [...runNames, ...fileNames, 'output'] });
    const file = await fileRequest(bytes, options);
    const { files, report } = await this.#client.run(
      { kind: 'remeshFile', file, options: checked }, fileBuffers(file), options);
    return { ...files[0], files, report };
  }

  /**
   * @param {Mesh} mesh
   * @param {RepairOptions & RunOptions} [options]
   * @returns {Promise<RepairResult>}
   */
  async repair(mesh, options = {}) {
    const checked = checkRepair(options, runNames);
    const parts = [{ mesh: copyMesh(mesh) }];
    const { meshes, report } = await this.#client.run({ kind: 'repair', parts, options: checked },
      buffersOf(parts[0].mesh), options);
    return { mesh: meshes[0], report };
  }

  /**
   * @param {Bytes} bytes
   * @param {RepairOptions & FileOptions & OutputOptions & RunOptions} [options]
   * @returns {Promise<RepairFileResult>}
   */
  async repairFile(bytes, options = {}) {
    const checked = checkRepair(options, [...runNames, ...fileNames, 'output']);
    const file = await fileRequest(bytes, options);
    const { files, report } = await this.#client.run(
      { kind: 'repairFile', file, options: checked }, fileBuffers(file), options);
    return { ...files[0], files, report };
  }

  /**
   * @param {Bytes} bytes
   * @param {FileOptions & OutputOptions & RunOptions} [options]
   * @returns {Promise<ConvertFileResult>}
   */
  async convertFile(bytes, options = {}) {
    refuseOthers(options, [...runNames, ...fileNames, 'output']);
    const file = await fileRequest(bytes, options);
    const { files, warnings } = await this.#client.run(
      { kind: 'convertFile', file }, fileBuffers(file), options);
    return { ...files[0], files, warnings };
  }

  /**
   * @param {Bytes | Mesh} bytesOrMesh
   * @param {FileOptions & RunOptions} [options]
   * @returns {Promise<Inspection>}
   */
  async inspect(bytesOrMesh, options = {}) {
    refuseOthers(options, [...runNames, ...fileNames]);
    if (isBytes(bytesOrMesh)) {
      const file = await fileRequest(bytesOrMesh, options);
      return this.#client.run({ kind: 'inspectFile', file }, fileBuffers(file), options);
    }
    const copy = copyMesh(bytesOrMesh);
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

/** @param {unknown} codecs @returns {import('./client.js').Codecs} */
function requireCodecs(codecs) {
  const { worker, load } = /** @type {any} */ (codecs ?? {});
  if (typeof worker === 'function' && typeof load === 'function') return { worker, load };
  throw new RemeshError('INVALID_OPTION', 'codecs must be what remesher/codecs exports.');
}

/** @param {object} options @param {readonly string[]} known */
function refuseOthers(options, known) {
  requireObject(options);
  const unknown = Object.keys(options).find((name) => !known.includes(name));
  if (unknown) {
    throw new RemeshError('UNKNOWN_OPTION', `There is no option ${legible(unknown)} here.`,
      `There are ${known.join(', ')}.`);
  }
}
