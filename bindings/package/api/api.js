// SPDX-License-Identifier: MIT
// All public functions, of arrays and of files, for any platform.

import { RemeshError } from '../base/errors.js';
import { ArraysApi, compilerOf, refuseOthers, runNames, start } from './arrays_api.js';
import { Client } from './client.js';
import {
  buffersOf, copyMesh, copyOperands, fileBuffers, fileRequest, isBytes,
} from './inputs.js';
import { legible } from '../base/legible.js';
import {
  bakeNames, checkOptions, checkOwn, checkRepair, convertNames, unwrapNames,
} from '../base/options.js';

/**
 * @import { AtlasReport, BooleanOperation, BooleanReport, FileRequest, Inspection, Mesh,
 *   NamedBytes,   Picture, RepairReport, Warning } from '../base/messages.js'
 */
/** @import { RemeshOptions } from '../base/options.js' */
/** @import { RemeshResult, Runner, WasmSource } from './arrays_api.js' */
/** @import { Platform, RunOptions } from './client.js' */
/** @import { Bytes, FileOptions, OutputOptions } from './inputs.js' */
/** @import { Compile } from './modules.js' */

/**
 * @typedef {object} InitOptions
 * @property {string | URL} [wasmUrl] Where remesher.wasm is, the whole engine, if not beside the
 *   script.
 * @property {BufferSource} [wasmBinary] Its bytes, if they are there already.
 * @property {WasmSource} [arrays] Only the small engine for arrays is loaded, and this is where
 *   remesher_arrays.wasm is: `{}` for beside the script. The whole one is loaded with the first
 *   file.
 * @property {import('./client.js').Codecs} [codecs] What `remesher/codecs` exports: images are
 *   decoded and encoded by what the bundler has put beside the worker.
 */

/** @typedef {import('../base/option_lists.js').RepairName} RepairName */
/** @typedef {Pick<RemeshOptions, RepairName>} RepairOptions */

/**
 * @typedef {object} InspectOptions
 * @property {boolean} [faults] Whether to look for faults, and for the repair that would mend them.
 * @property {boolean} [edges] Whether to tell the edges by kind: of arrays, whose vertices have
 *   numbers.
 */

/**
 * @typedef {object} RepairResult
 * @property {Mesh} mesh Arrays of the types that were given.
 * @property {RepairReport} report The input, the repairs, the output.
 */

/**
 * @typedef {object} ConvertFileResult
 * @property {string} name The file's name.
 * @property {Uint8Array} bytes The file.
 * @property {NamedBytes[]} files This file first, then those it refers to (a .bin, a .mtl) and
 *   those of levels of detail, by names that lead nowhere but into one folder.
 * @property {Warning[]} warnings The faults of the result.
 * @property {import('../base/messages.js').Compression} [compression] If it was asked for.
 */

/** @typedef {Pick<RemeshOptions, 'compress' | 'units'>} ConvertOptions */

/** @typedef {{ card: import('../base/messages.js').Card }} Carded */

/**
 * @typedef {Omit<ConvertFileResult, 'warnings' | 'compression'>
 *   & { report: RemeshResult['report'] & Carded }} RemeshFileResult
 */

/**
 * @typedef {Omit<ConvertFileResult, 'warnings' | 'compression'>
 *   & { report: RepairResult['report'] & Carded }} RepairFileResult
 */

/**
 * The files of a Boolean, as FileOptions are of one file.
 * @typedef {object} OperandOptions
 * @property {string} [nameA] The first file's name; its extension, before a .gz, tells the format.
 * @property {string} [nameB] The second file's name.
 * @property {Record<string, Bytes>} [resourcesA] Files that the first one refers to, by the names
 *   it uses for them.
 * @property {Record<string, Bytes>} [resourcesB] Files that the second one refers to.
 */

/**
 * @typedef {object} BooleanResult
 * @property {Mesh} mesh Arrays of the types of the first mesh; coordinates are doubles if either
 *   mesh has doubles.
 * @property {BooleanReport} report The input, the cuts, the output.
 */

/**
 * @typedef {Omit<ConvertFileResult, 'warnings' | 'compression'> & Pick<BooleanResult, 'report'>}
 *   BooleanFilesResult
 */

/** @typedef {import('../base/option_lists.js').BakeName} BakeName */
/** @typedef {Pick<RemeshOptions, BakeName>} BakeOptions */
/** @typedef {Pick<RemeshOptions, 'textureSize'>} UnwrapOptions */

/**
 * An image with four bytes per texel, row after row from the top.
 * @typedef {object} BakedMap
 * @property {number} width Texels.
 * @property {number} height Texels.
 * @property {Uint8Array} data The bytes.
 */

/**
 * @typedef {object} BakeResult
 * @property {Mesh} mesh The low mesh with texture coordinates, normals and tangents.
 * @property {{ normal?: BakedMap, baseColor?: BakedMap, surface?: BakedMap, emissive?: BakedMap }}
 *   maps The baked maps; `surface` is occlusion, roughness and metal.
 * @property {AtlasReport} report What went in and what came out.
 */

/**
 * The files of a bake, as FileOptions are of one file.
 * @typedef {object} BakeFileOptions
 * @property {string} [name] The high file's name; its extension, before a .gz, tells the format.
 * @property {string} [nameLow] The low file's name.
 * @property {Record<string, Bytes>} [resources] Files that the high one refers to, by the names it
 *   uses for them.
 * @property {Record<string, Bytes>} [resourcesLow] Files that the low one refers to.
 */

/**
 * @typedef {object} UnwrapResult
 * @property {Mesh} mesh The mesh with texture coordinates: its vertices in their order, then copies
 *   of those on seams.
 * @property {AtlasReport} report What went in and what came out.
 */

/**
 * @typedef {Omit<ConvertFileResult, 'warnings'> & Pick<UnwrapResult, 'report'>} AtlasFileResult
 */

/** @typedef {Platform & { compileWhole: Compile }} WholePlatform */

const fileNames = /** @type {const} */ (['name', 'resources']);
const outputNames = /** @type {const} */ (['output', 'metres']);

/** Each function is documented where it is exported, in index.js. */
export class Api extends ArraysApi {
  #platform;
  #client;

  /** @param {WholePlatform} platform @param {Runner} [client] who runs the jobs */
  constructor(platform, client = new Client(platform)) {
    super(platform, client);
    this.#platform = platform;
    this.#client = client;
    client.modules.offer('whole', platform.compileWhole);
  }

  /**
   * @param {InitOptions} [options]
   * @returns {Promise<void>}
   */
  async init(options = {}) {
    refuseOthers(options, ['wasmUrl', 'wasmBinary', 'arrays', 'codecs']);
    const { arrays, codecs } = options;
    if (arrays !== undefined) refuseOthers(arrays, ['wasmUrl', 'wasmBinary']);
    const compileWhole = compilerOf(options, this.#platform);
    const compileArrays = compilerOf(arrays ?? {}, this.#platform);
    if (codecs !== undefined) this.#client.bring(requireCodecs(codecs));
    if (arrays) {
      if (compileWhole) this.#client.modules.offer('whole', compileWhole);
      await start(this.#client, 'arrays', compileArrays);
    } else {
      await start(this.#client, 'whole', compileWhole);
    }
  }

  /**
   * @param {Bytes} bytes
   * @param {RemeshOptions & FileOptions & OutputOptions & RunOptions} [options]
   * @returns {Promise<RemeshFileResult>}
   */
  async remeshFile(bytes, options = {}) {
    const checked = checkOptions(options, { others: [...runNames, ...fileNames, ...outputNames] });
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
    const checked = checkRepair(options, [...runNames, ...fileNames, ...outputNames]);
    const file = await fileRequest(bytes, options);
    const { files, report } = await this.#client.run(
      { kind: 'repairFile', file, options: checked }, fileBuffers(file), options);
    return { ...files[0], files, report };
  }

  /**
   * @param {Mesh} a
   * @param {Mesh} b
   * @param {BooleanOperation} operation
   * @param {RunOptions} [options]
   * @returns {Promise<BooleanResult>}
   */
  async boolean(a, b, operation, options = {}) {
    refuseOthers(options, runNames);
    const operands = copyOperands(a, b);
    const { meshes, report } = await this.#client.run(
      { kind: 'boolean', operands, operation: requireOperation(operation) },
      operands.flatMap(buffersOf), options);
    return { mesh: meshes[0], report };
  }

  /**
   * @param {Bytes} a
   * @param {Bytes} b
   * @param {BooleanOperation} operation
   * @param {OperandOptions & OutputOptions & RunOptions} [options]
   * @returns {Promise<BooleanFilesResult>}
   */
  async booleanFiles(a, b, operation, options = {}) {
    refuseOthers(options, [...runNames, 'nameA', 'nameB', 'resourcesA', 'resourcesB', 'output']);
    const { nameA, nameB, resourcesA, resourcesB, output } = options;
    /** @type {[FileRequest, FileRequest]} */
    const files = [await fileRequest(a, { name: nameA, resources: resourcesA, output }),
      await fileRequest(b, { name: nameB, resources: resourcesB })];
    const { files: made, report } = await this.#client.run(
      { kind: 'booleanFiles', files, operation: requireOperation(operation) },
      files.flatMap(fileBuffers), options);
    return { ...made[0], files: made, report };
  }

  /**
   * @param {Mesh} high
   * @param {Mesh} low
   * @param {BakeOptions & RunOptions} [options]
   * @returns {Promise<BakeResult>}
   */
  async bake(high, low, options = {}) {
    const checked = checkOwn(options, { names: bakeNames, others: runNames, what: 'Baking' });
    /** @type {[Mesh, Mesh]} */
    const meshes = [copyMesh(high), copyMesh(low)];
    const { meshes: made, maps, report } = await this.#client.run(
      { kind: 'bake', meshes, options: checked }, meshes.flatMap(buffersOf), options);
    const entries = maps.map((/** @type {Picture} */ { name, width, height, texels }) =>
      [name, { width, height, data: texels }]);
    return { mesh: made[0], maps: Object.fromEntries(entries), report };
  }

  /**
   * @param {Bytes} high
   * @param {Bytes} low
   * @param {BakeOptions & BakeFileOptions & OutputOptions & RunOptions} [options]
   * @returns {Promise<AtlasFileResult>}
   */
  async bakeFile(high, low, options = {}) {
    const others = [...runNames, ...fileNames, 'nameLow', 'resourcesLow', 'output'];
    const checked = checkOwn(options, { names: bakeNames, others, what: 'Baking' });
    const { name, nameLow, resources, resourcesLow, output } = options;
    const lowName = nameLow ?? /** @type {any} */ (low)?.name;
    /** @type {[FileRequest, FileRequest]} */
    const files = [await fileRequest(high, { name, resources }),
      await fileRequest(low, { name: lowName, resources: resourcesLow, output: output ?? 'glb' })];
    const { files: made, report } = await this.#client.run(
      { kind: 'bakeFile', files, options: checked }, files.flatMap(fileBuffers), options);
    return { ...made[0], files: made, report };
  }

  /**
   * @param {Mesh} mesh
   * @param {UnwrapOptions & RunOptions} [options]
   * @returns {Promise<UnwrapResult>}
   */
  async unwrap(mesh, options = {}) {
    const checked = checkOwn(options,
      { names: unwrapNames, others: runNames, what: 'Unwrapping' });
    const copy = copyMesh(mesh);
    const { meshes, report } = await this.#client.run(
      { kind: 'unwrap', mesh: copy, options: checked }, buffersOf(copy), options);
    return { mesh: meshes[0], report };
  }

  /**
   * @param {Bytes} bytes
   * @param {UnwrapOptions & FileOptions & OutputOptions & RunOptions} [options]
   * @returns {Promise<AtlasFileResult>}
   */
  async unwrapFile(bytes, options = {}) {
    const checked = checkOwn(options,
      { names: unwrapNames, others: [...runNames, ...fileNames, ...outputNames],
        what: 'Unwrapping' });
    const file = await fileRequest(bytes, options);
    const { files, report } = await this.#client.run(
      { kind: 'unwrapFile', file, options: checked }, fileBuffers(file), options);
    return { ...files[0], files, report };
  }

  /**
   * @param {Bytes} bytes
   * @param {ConvertOptions & FileOptions & OutputOptions & RunOptions} [options]
   * @returns {Promise<ConvertFileResult>}
   */
  async convertFile(bytes, options = {}) {
    refuseOthers(options, [...runNames, ...fileNames, ...outputNames, ...convertNames]);
    const checked = checkOptions(Object.fromEntries(convertNames.map((name) =>
      [name, options[name]])));
    const file = await fileRequest(bytes, options);
    const { files, warnings, compression } = await this.#client.run(
      { kind: 'convertFile', file, options: checked }, fileBuffers(file), options);
    return { ...files[0], files, warnings, ...(compression ? { compression } : {}) };
  }

  /**
   * @param {Bytes | Mesh} bytesOrMesh
   * @param {InspectOptions & FileOptions & RunOptions} [options]
   * @returns {Promise<Inspection>}
   */
  async inspect(bytesOrMesh, options = {}) {
    refuseOthers(options, [...runNames, ...fileNames, 'faults', 'edges']);
    const faults = checkSwitch('faults', options.faults);
    const edges = checkSwitch('edges', options.edges);
    if (isBytes(bytesOrMesh)) {
      if (edges) throw edgesOfFile();
      const file = await fileRequest(bytesOrMesh, options);
      return this.#client.run({ kind: 'inspectFile', file, faults }, fileBuffers(file), options);
    }
    const { signal, onProgress, worker } = options;
    if (!faults && !edges) return super.inspect(bytesOrMesh, { signal, onProgress, worker });
    const mesh = copyMesh(bytesOrMesh);
    const job = { kind: /** @type {const} */ ('inspect'), mesh, closely: { faults, edges } };
    return this.#client.run(job, buffersOf(mesh), options);
  }
}

const operations = /** @type {const} */ (['union', 'subtract', 'intersect']);

/** @param {unknown} operation @returns {BooleanOperation} */
function requireOperation(operation) {
  const known = operations.find((name) => name === operation);
  if (known) return known;
  throw new RemeshError('INVALID_OPTION',
    `The operation must be 'union', 'subtract' or 'intersect', not ${legible(operation)}.`);
}

const edgesOfFile = () => new RemeshError('INVALID_OPTION',
  'edges are listed for arrays only: they name vertices by their numbers.',
  'Give a mesh of positions and indices.');

/** @param {string} name @param {unknown} value @returns {boolean} */
function checkSwitch(name, value = false) {
  if (typeof value === 'boolean') return value;
  throw new RemeshError('INVALID_OPTION', `${name} must be true or false.`);
}

/** @param {unknown} codecs @returns {import('./client.js').Codecs} */
function requireCodecs(codecs) {
  const { worker, load } = /** @type {any} */ (codecs ?? {});
  if (typeof worker === 'function' && typeof load === 'function') return { worker, load };
  throw new RemeshError('INVALID_OPTION', 'codecs must be what remesher/codecs exports.');
}
