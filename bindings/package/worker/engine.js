// SPDX-License-Identifier: MIT
// The only file that touches the WebAssembly instance: makes it, calls it, and turns its results
// into plain objects and errors. An instance that has failed by itself, or whose memory has grown
// large (it never shrinks), is dropped; the next call makes a new one from the compiled module.

import { isGltf } from '../base/contents.js';
import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { inModelUnits, unitOf } from '../base/lengths.js';
import { blocksOfPieces } from '../base/pieces.js';
import {
  compressionOf, makesImagesLighter, namesGltf, withoutVainBaking, withPresetSettled,
} from './preset_job.js';
import { toTheEnd } from './whole_progress.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */
/** @typedef {import('../base/messages.js').Job} Job */
/** @typedef {import('../base/messages.js').Loaded} Loaded */
/** @typedef {import('../base/messages.js').Mesh} Mesh */
/** @typedef {import('../base/messages.js').MeshAttribute} MeshAttribute */
/** @typedef {import('../base/messages.js').ProgressEvent} ProgressEvent */

// Memory that is kept for the next run, in bytes: getting it from the system takes a tenth of the
// time of a draft of ten thousand vertices.
const keptMemory = 64 * 2 ** 20;

// The script of each engine, loaded when needed: the small one's does not open files.
const scripts = {
  arrays: () => import('./arrays_script.js'),
  whole: () => import('./whole_script.js'),
};

/** @param {Loaded} loaded @returns {Promise<any>} */
export async function instantiate({ engine, module }) {
  const { createInstance } = await scripts[engine]();
  return new Promise((resolve, reject) => {
    /**
     * @param {WebAssembly.Imports} imports
     * @param {(instance: WebAssembly.Instance) => void} use
     */
    const instantiateWasm = (imports, use) => {
      WebAssembly.instantiate(module, imports).then(use).catch(reject);
      return {};
    };
    createInstance({ instantiateWasm }).then(resolve, reject);
  });
}

/** The mesh with its attributes in a list, as the instance takes them. @param {Mesh} mesh */
function withList({ attributes = {}, ...mesh }) {
  return { ...mesh, attributes: Object.entries(attributes).map(
    ([semantic, { array, itemSize }]) => ({ semantic, array, itemSize })) };
}

/**
 * The values in an array of the model's type; values for integers are rounded only here.
 * @param {Float32Array} values
 * @param {import('../base/messages.js').NumberArray | undefined} model
 */
function likeModel(values, model) {
  if (!model || model instanceof Float32Array) return values;
  if (model instanceof Float64Array) return Float64Array.from(values);
  const Kind = /** @type {any} */ (model.constructor);
  return new Kind(values.map(Math.round));
}

/** @param {Uint32Array} values @param {import('../base/messages.js').Indices | undefined} model */
const likeIndices = (values, model) =>
  (model instanceof Uint16Array ? Uint16Array.from(values) : values);

/** @param {any} mesh as it comes back @param {Mesh} model as it went in @returns {Mesh} */
function meshLike(mesh, model) {
  const { positions, indices, quads } = mesh;
  const isSmall = positions.length / 3 <= 2 ** 16;
  /** @type {Record<string, MeshAttribute>} */
  const attributes = {};
  for (const { semantic, array, itemSize } of mesh.attributes) {
    attributes[semantic] =
      { array: likeModel(array, model.attributes?.[semantic]?.array), itemSize };
  }
  return {
    positions: model.positions instanceof Float32Array ? Float32Array.from(positions) : positions,
    indices: isSmall ? likeIndices(indices, model.indices) : indices,
    attributes,
    ...(mesh.groups ? { groups: likeIndices(mesh.groups, model.groups) } : {}),
    ...(quads ? { quads: isSmall ? likeIndices(quads, model.indices) : quads } : {}),
  };
}

/** The core's error. Where an edge length asked for the vertices, so does the way out.
 * @param {{ code: import('../base/errors.js').ErrorCode, message: string, hint: string }} error
 * @param {object} job */
function errorOf({ code, message, hint }, job) {
  const { edgeLength = undefined } = 'options' in job ? Object(job.options) : {};
  const isTooFew = code === 'TARGET_TOO_SMALL' || code === 'TARGET_BELOW_CURVES';
  return new RemeshError(code, message, isTooFew && edgeLength !== undefined
    ? 'Ask for a shorter edge length: the number of vertices follows from it.' : hint);
}

/** @typedef {import('../base/open_file.js').BlocksOf} BlocksOf */
/** @typedef {import('../base/open_file.js').FileHandle} FileHandle */
/** @typedef {import('../base/open_file.js').ReadBlock} ReadBlock */

/**
 * The platform's functions for an engine.
 * @typedef {import('../textures/image_codecs.js').CodecSource & { blocksOf?: BlocksOf }}
 *   EnginePlatform
 */

/** All bytes of a Blob. @param {string} name @param {Blob} blob */
async function allOf(name, blob) {
  try {
    return new Uint8Array(await blob.arrayBuffer());
  } catch (cause) {
    throw new RemeshError('INPUT_UNREADABLE', `${legible(name)} cannot be read.`,
      'Is the file still there, unchanged?', { cause });
  }
}

/** Called with the progress of a run; returns false to cancel it.
 * @typedef {((phase: string, fraction: number) => boolean) | undefined} Ask */

/** Called with the fraction of a file that has been read; returns false to cancel.
 * @typedef {(share: number) => boolean} OnRead */

/** The share of a run's time that reading its file takes: src/jobs/run_guards.h has the same
 * numbers. A conversion has no other progress.
 * @type {Partial<Record<Job['kind'], number>>} */
const readShares = { inspectFile: 0.2, convertFile: 1 };
const usualReadShare = 0.05;

/** Bytes that are read at once, at most: the core asks for all of a text. */
const longestBlock = 2 ** 22;

/** Blocks that tell how much of them is read.
 * @param {FileHandle} handle @param {ReadBlock} read @param {OnRead} onRead
 * @returns {{ size: number, read: ReadBlock }} */
function watched({ size }, read, onRead) {
  return { size, read(at, into) {
    for (let filled = 0; filled < into.length; filled += longestBlock) {
      const block = into.subarray(filled, filled + longestBlock);
      if (!read(at + filled, block) || !onRead((at + filled + block.length) / size)) return false;
    }
    return true;
  } };
}

/** The file as the instance takes it: with the way to its blocks, if it is read in blocks; with all
 * bytes of a Blob that this thread cannot read in blocks.
 * @param {FileRequest} file @param {BlocksOf | undefined} blocksOf @param {OnRead} onRead
 * @returns {Promise<FileRequest>} */
async function reachable(file, blocksOf, onRead) {
  const { handle } = file;
  if (!handle) return file;
  const { pieces, size } = handle;
  const read = pieces ? blocksOfPieces({ pieces, size }) : blocksOf?.(handle);
  if (read) return { ...file, blocks: watched(handle, read, onRead) };
  return { ...file, bytes: await allOf(file.name, /** @type {Blob} */ (handle.blob)) };
}

/** @param {Job} job @param {BlocksOf | undefined} blocksOf @param {Ask} ask
 * @returns {Promise<Job>} */
async function withBlocks(job, blocksOf, ask) {
  const share = readShares[job.kind] ?? usualReadShare;
  if ('file' in job) {
    let read = 0;
    return { ...job, file: await reachable(job.file, blocksOf, (part) => {
      read = Math.max(read, part);  // some formats are gone through twice
      return ask?.('read', share * read) ?? true;
    }) };
  }
  if (!('files' in job)) return job;
  const [a, b] = job.files;
  const goOn = () => true;
  return { ...job,
    files: [await reachable(a, blocksOf, goOn), await reachable(b, blocksOf, goOn)] };
}

/**
 * @param {any} instance
 * @param {Job} job
 * @param {((phase: string, fraction: number) => boolean) | undefined} ask
 */
function call(instance, job, ask) {
  switch (job.kind) {
    case 'remesh':
      return instance.remesh(
        job.parts.map(({ mesh, places = [], finer }) =>
          ({ mesh: withList(mesh), places, finer })),
        job.options, ask);
    case 'remeshFile':
      return instance.remeshFile(job.file, job.options, ask);
    case 'repair':
      return instance.repair(withList(job.parts[0].mesh), job.options, ask);
    case 'repairFile':
      return instance.repairFile(job.file, job.options, ask);
    case 'boolean': {
      const [a, b] = job.operands.map(withList);
      return instance.boolean({ a, b, operation: job.operation }, ask);
    }
    case 'booleanFiles': {
      const [a, b] = job.files;
      return instance.booleanFiles({ a, b, operation: job.operation, output: a.output }, ask);
    }
    case 'bake': {
      const [high, low] = job.meshes.map(withList);
      return instance.bake({ high, low }, job.options, ask);
    }
    case 'bakeFile': {
      const [high, low] = job.files;
      return instance.bakeFile({ high, low, output: low.output }, job.options, ask);
    }
    case 'unwrap':
      return instance.unwrap(withList(job.mesh), job.options, ask);
    case 'unwrapFile':
      return instance.unwrapFile(job.file, job.options, ask);
    case 'convertFile':
      return instance.convertFile(job.file);
    case 'inspect':
      return job.closely
        ? instance.inspectClosely(withList(job.mesh), job.closely)
        : instance.inspect(withList(job.mesh));
    default:
      return instance.inspectFile(job.file, job.faults ?? false, ask);
  }
}

/**
 * The job with its files neither packed nor compressed.
 * @param {Job} job @returns {Promise<Job>}
 */
async function plain(job) {
  if ('file' in job) return (await scripts.whole()).opened(job);
  if (!('files' in job)) return job;
  const { opened } = await scripts.whole();
  const [a, b] = job.files;
  return { ...job, files: [(await opened({ file: a })).file, (await opened({ file: b })).file] };
}

/**
 * The types of a result of two meshes: the first one's, and doubles where either has them.
 * @param {[Mesh, Mesh]} operands @returns {Mesh}
 */
function modelOf([a, b]) {
  const isLarge = (/** @type {Mesh} */ { indices }) => indices instanceof Uint32Array;
  const positions = [a, b].find((mesh) => mesh.positions instanceof Float64Array) ?? a;
  return {
    positions: positions.positions,
    indices: isLarge(b) ? b.indices : a.indices,
    attributes: { ...b.attributes, ...a.attributes },
    groups: a.groups ?? b.groups,
  };
}

/** @typedef {import('./preset_job.js').FileJob} FileJob */

/** Refuses slabs of arrays. @param {Job} job */
function requireFileForSlabs(job) {
  if (!('options' in job) || job.options.slabs === undefined || 'file' in job) return;
  throw new RemeshError('INVALID_OPTION', 'slabs are for files, not for arrays.',
    'Give the file to remeshFile.');
}

/** Refuses to compress files of other formats than glTF. @param {Job} job */
async function requireFile(job) {
  if ('file' in job) {
    (await import('../codecs/compress.js')).requireCompressible(job.file.output);
    return;
  }
  throw new RemeshError('INVALID_OPTION', 'compress applies to files only, not to arrays.',
    'Give the file to remeshFile or repairFile.');
}

/** The file whose lengths the result has. @param {any} job its files neither packed nor
 * compressed */
const sourceOf = ({ kind, file, files }) => file ?? files?.[kind === 'bakeFile' ? 1 : 0];

/** @param {Job} job its files neither packed nor compressed */
const unitOfJob = (job) => unitOf('options' in job ? job.options : {},
  'file' in job ? job.file : undefined);

/** The job with its lengths in the model's units. @param {Job} job @returns {Job} */
function withLengthsSettled(job) {
  if (!('options' in job)) return job;
  return { ...job, options: inModelUnits(job.options, unitOfJob(job)) };
}

/** The outcome with the unit of the model in its report, if it is known. @param {Job} job
 * @param {any} outcome */
function withUnitSaid(job, outcome) {
  const unit = unitOfJob(job);
  if (unit === undefined || job.kind === 'booleanFiles' || job.kind === 'convertFile') {
    return outcome;
  }
  return outcome.report ? { ...outcome, report: { ...outcome.report, unit } }
    : { ...outcome, unit };
}

/** The outcome with the textures of the glTF that was inspected, or that a run has made, in its
 * report. @param {any} outcome @param {Job} job its files neither packed nor compressed */
async function withTexturesListed(outcome, job) {
  const isInspected = job.kind === 'inspectFile' && isGltf(job.file.bytes);
  const isMade = outcome.report && outcome.files && namesGltf(outcome.files[0].name);
  if (!isInspected && !isMade) return outcome;
  const { texturesOf } = await import('../textures/gltf_images.js');
  if (isInspected) return { ...outcome, textures: texturesOf(job.file) };
  const [{ name, bytes }, ...resources] = outcome.files;
  const textures = texturesOf({ name, bytes, resources });
  return { ...outcome, report: { ...outcome.report, textures } };
}

/** The outcome with the options that a preset stood for in its report. @param {Job} job
 * @param {any} outcome */
function withPresetSaid(job, outcome) {
  if (!('options' in job) || !job.options.preset) return outcome;
  return { ...outcome, report: { ...outcome.report, preset: job.options.preset } };
}

/** Whether textures are baked, or will be if repair makes another surface.
 * @param {FileJob} job */
function mayPaint({ file, options: { textures = 'auto', repair = 'off' } }) {
  const mayBeMadeAnew = ['solid', 'wrap', 'auto'].includes(String(repair));
  return textures === 'bake' || (textures === 'auto' && mayBeMadeAnew
    && isGltf(file.bytes) && namesGltf(file.output));
}

/** Unless baking was asked for, images need not be readable: textures are kept then.
 * @param {import('../textures/bake.js').Baker} baker @param {FileJob} job */
async function openedBy(baker, { file, options }) {
  try {
    return await baker.opened(file);
  } catch (error) {
    const isOurs = error instanceof RemeshError && error.code !== 'CANCELLED';
    if (options.textures === 'bake' || !isOurs) throw error;
    return file;
  }
}

/** Says of a second run only that the whole is nearly done.
 * @param {((event: ProgressEvent) => boolean | void) | undefined} onProgress */
const atTheEnd = (onProgress) => onProgress
  && ((/** @type {ProgressEvent} */ event) => onProgress({ ...event, fraction: 1 }));

export class Engine {
  #loaded;
  #codecs;
  /** @type {Promise<any> | undefined} */
  #instance;

  /**
   * @param {Loaded} loaded
   * @param {EnginePlatform} [codecs]
   */
  constructor(loaded, codecs = {}) {
    this.#loaded = loaded;
    this.#codecs = codecs;
  }

  get name() {
    return this.#loaded.engine;
  }

  /**
   * Runs one job to its end. onProgress returns false to stop it.
   * @param {Job} job
   * @param {(event: ProgressEvent) => boolean | void} [onProgress]
   * @returns {Promise<any>}
   */
  async run(job, onProgress) {
    const { listen, end } = toTheEnd(onProgress);
    const result = await this.#result(job, listen);
    end();
    return result;
  }

  /**
   * @param {Job} job
   * @param {((event: ProgressEvent) => boolean | void) | undefined} onProgress
   * @returns {Promise<any>}
   */
  async #result(job, onProgress) {
    const compress = await compressionOf(job);
    if (compress) await requireFile(job);
    requireFileForSlabs(job);
    let settled = await withPresetSettled(await plain(job), compress);
    let made = await this.#painted(withLengthsSettled(settled), onProgress);
    const bare = await withoutVainBaking(settled, made);
    if (bare) {
      settled = bare;
      made = await this.#painted(withLengthsSettled(settled), atTheEnd(onProgress));
    }
    if (made.files && makesImagesLighter(job, settled)) {
      const { withLighterImages } = await import('../textures/lighter_images.js');
      made = { ...made, files: await withLighterImages(made.files, this.#codecs) };
    }
    const outcome = withUnitSaid(settled, withPresetSaid(settled, made));
    if (!outcome.files) return withTexturesListed(outcome, settled);
    const fileOf = (/** @type {Job} */ one) => ('file' in one ? one.file : undefined);
    return (await scripts.whole()).closed(await withTexturesListed(outcome, settled),
      { isCarded: job.kind === 'remeshFile' || job.kind === 'repairFile',
        packed: fileOf(job), opened: fileOf(settled), source: sourceOf(settled), compress,
        units: 'options' in job ? job.options.units : undefined });
  }

  /**
   * @param {Job} plainJob its files neither packed nor compressed
   * @param {((event: ProgressEvent) => boolean | void) | undefined} onProgress
   * @returns {Promise<any>}
   */
  async #painted(plainJob, onProgress) {
    if (plainJob.kind === 'bakeFile') return this.#baked(plainJob, onProgress);
    const isOfFile = plainJob.kind === 'remeshFile' || plainJob.kind === 'repairFile';
    if (!isOfFile || !mayPaint(plainJob)) return this.#run(plainJob, onProgress);
    const { Baker } = await import('../textures/bake.js');
    const baker = new Baker(this.#codecs, onProgress);
    try {
      const file = await openedBy(baker, plainJob);
      const options = { textureFormat: baker.usualFormat, ...plainJob.options };
      return await baker.closed(await this.#run({ ...plainJob, file, options },
        baker.onPainting), plainJob.options.textureFormat);
    } finally {
      baker.end();
    }
  }

  /**
   * @param {Extract<Job, { kind: 'bakeFile' }>} job
   * @param {((event: ProgressEvent) => boolean | void) | undefined} onProgress
   */
  async #baked(job, onProgress) {
    const { Baker } = await import('../textures/bake.js');
    const baker = new Baker(this.#codecs, onProgress);
    try {
      const [high, low] = job.files;
      /** @type {[FileRequest, FileRequest]} */
      const files = [await baker.opened(high), low];
      const options = { textureFormat: baker.usualFormat, ...job.options };
      return await baker.closed(await this.#run({ ...job, files, options }, baker.onPainting));
    } finally {
      baker.end();
    }
  }

  /**
   * @param {Job} job its files neither packed nor compressed
   * @param {((event: ProgressEvent) => boolean | void) | undefined} onProgress
   * @returns {Promise<any>}
   */
  async #run(job, onProgress) {
    const instance = await this.#start();
    const ask = onProgress && ((/** @type {string} */ phase, /** @type {number} */ fraction) =>
      onProgress({ phase, fraction }) !== false);
    const outcome = this.#call(instance, await withBlocks(job, this.#codecs.blocksOf, ask), ask);
    if (instance.HEAPU8.length > keptMemory) this.#instance = undefined;
    if (outcome.error) throw errorOf(outcome.error, job);
    if (job.kind === 'boolean') {
      return { ...outcome, meshes: [meshLike(outcome.meshes[0], modelOf(job.operands))] };
    }
    if (job.kind === 'bake') {
      return { ...outcome, meshes: [meshLike(outcome.meshes[0], job.meshes[1])] };
    }
    if (job.kind === 'unwrap') {
      return { ...outcome, meshes: [meshLike(outcome.meshes[0], job.mesh)] };
    }
    if (job.kind !== 'remesh' && job.kind !== 'repair') return outcome;
    const alike = (/** @type {any[]} */ meshes) =>
      job.parts.map(({ mesh }, i) => meshLike(meshes[i], mesh));
    const lods = outcome.lods ? { lods: outcome.lods.map(alike) } : {};
    return { ...outcome, meshes: alike(outcome.meshes), ...lods };
  }

  async #start() {
    try {
      return await (this.#instance ??= instantiate(this.#loaded));
    } catch (cause) {
      this.#instance = undefined;
      throw new RemeshError('INTERNAL', `The WebAssembly cannot be started: ${String(cause)}.`,
        'Are its file and the script of one version?', { cause });
    }
  }

  /**
   * @param {any} instance
   * @param {Job} job
   * @param {((phase: string, fraction: number) => boolean) | undefined} ask
   */
  #call(instance, job, ask) {
    try {
      return call(instance, job, ask);
    } catch (cause) {
      this.#instance = undefined;
      throw new RemeshError('INTERNAL', `The run failed inside WebAssembly: ${String(cause)}.`,
        'Please report this as a bug, with the model if you can.', { cause });
    }
  }
}
