// SPDX-License-Identifier: MIT
// One model, its results, and at most one run: a new run ends the run before it. Uses the package,
// not the page. Every method rejects with AbortError when it was overtaken.
import { convertFile, inspect, RemeshError } from 'remesher';
import { isGltf } from 'remesher/formats';
import { optionsIn } from './purposes.js';
import { describe, resultOf, worked } from './result.js';

/** @typedef {import('../files/models.js').Model} Model */
/** @typedef {import('./address.js').Values} Values */
/** @typedef {import('remesher').RemeshOptions} RemeshOptions */
/** @typedef {import('remesher').ProgressEvent} ProgressEvent */
/** @typedef {import('remesher').NamedBytes} NamedBytes */
/** @typedef {import('./result.js').Result} Result */

/** The most results that are kept, and the most bytes of them. */
const most = { results: 12, bytes: 2 ** 28 };

/** @param {import('remesher').Warning[]} warnings */
const hasRoomForFaults = (warnings) => !warnings.some(({ code }) => code === 'FAULTS_NOT_SOUGHT');

export class Session {
  #controller = new AbortController();
  /** Aborted when another model comes; a cancelled run does not abort it, for the model stays. */
  #stay = new AbortController();
  /** @type {(event: ProgressEvent) => void} */
  #onProgress;
  #runs = 0;
  /** Whether the visitor ended the last job, and not the next one. */
  isCancelled = false;
  /** @type {Model | null} */
  model = null;
  /** The model's name in the address; null for the visitor's own file. @type {string | null} */
  source = null;
  /** @type {import('remesher').Inspection | null} of the model */
  inspection = null;
  /** The model's latest results, in order. @type {Result[]} */
  results = [];
  /** The result on the stage. @type {Result | null} */
  shown = null;
  /** The result compared with the shown one; null for the original. @type {Result | null} */
  baseline = null;
  /** Whether a result of the visitor's own file was not saved. */
  isUnsaved = false;

  /** @param {(event: ProgressEvent) => void} onProgress */
  constructor(onProgress) {
    this.#onProgress = onProgress;
  }

  #begin() {
    this.cancel();
    this.isCancelled = false;
    this.#controller = new AbortController();
    return this.#controller.signal;
  }

  cancel() {
    this.isCancelled = true;
    this.#controller.abort();
  }

  /** Makes this the model, and reports on it; a file that cannot be read leaves the old one.
   * @param {Model} model @param {string | null} source
   * @returns a report, and a signal that is aborted when the opening is cancelled or overtaken */
  async open(model, source) {
    const signal = this.#begin();
    const report = await inspect(model.content,
      { ...describe(model), signal, onProgress: this.#onProgress });
    Object.assign(this, { model, source, inspection: report, results: [], shown: null,
      baseline: null, isUnsaved: false });
    this.#runs = 0;
    this.#stay.abort();
    this.#stay = new AbortController();
    return { report, signal };
  }

  /** The model's faults; null if it has nothing to check, or if that has no room. */
  async faults() {
    const model = this.#opened();
    const signal = this.#stay.signal;
    const { faults, warnings } =
      await inspect(model.content, { ...describe(model), faults: true, signal });
    return { faults: faults ?? null, hasRoom: hasRoomForFaults(warnings) };
  }

  /** Whether faults could be looked for, as far as is known before. */
  get hasRoomForFaults() {
    return hasRoomForFaults(this.inspection?.warnings ?? []);
  }

  /** The edges of a surface by kind, as the core finds them; null for a surface that the core
   * refuses, or if another model came meanwhile.
   * @param {{ positions: Float32Array, indices: Uint32Array }} surface */
  async edgesOf({ positions, indices }) {
    const { signal } = this.#stay;
    try {
      return (await inspect({ positions, indices }, { edges: true, signal })).edges ?? null;
    } catch (error) {
      if (signal.aborted || error instanceof RemeshError) return null;
      throw error;
    }
  }

  /** The model as glTF, for the viewer: the file itself, or a conversion.
   * @param {'direct' | 'converted'} way */
  async originalAsGltf(way) {
    if (way === 'direct' && this.isGltf) return this.#opened();
    return { bytes: (await this.converted('glb', this.#onProgress)).bytes, resources: [],
      isOwned: true };
  }

  get isGltf() {
    return isGltf(this.#opened().bytes);
  }

  /** The model in another format. @param {string} output
   * @param {(event: ProgressEvent) => void} [onProgress] */
  converted(output, onProgress) {
    const model = this.#opened();
    return convertFile(model.content,
      { ...describe(model), output, metres: false, onProgress, signal: this.#stay.signal });
  }

  #opened() {
    if (!this.model) throw new Error('There is no model');
    return this.model;
  }

  /** Ends the run before, and begins the next. */
  #beginRun() {
    return { onProgress: this.#onProgress, signal: this.#begin() };
  }

  /** Works on another model, and keeps nothing of it.
   * @param {Model} model @param {Values} values as they were asked for
   * @param {import('remesher').RemeshOptions & import('remesher').OutputOptions} [more] */
  workOnOther(model, values, more = {}) {
    return worked(model, values, { ...optionsIn(values), ...more, ...this.#beginRun() });
  }

  /** Remeshes the model; the result is neither kept nor shown.
   * @param {Values} values as they were asked for
   * @param {RemeshOptions} [extra] options that neither form nor address has */
  attempt(values, extra = {}) {
    return resultOf(this.#opened(), { values, extra }, this.#beginRun());
  }

  /** Remeshes the model; the result is shown from then on.
   * @param {Values} values @param {RemeshOptions} [extra] */
  async run(values, extra = {}) {
    const result = await this.attempt(values, extra);
    if (extra.quality !== 'draft') this.#keep(result);
    this.shown = result;
    return result;
  }

  /** Keeps and shows this result instead of all before it. @param {Result} result */
  keepOnly(result) {
    this.#runs = 0;
    this.results = [];
    this.#keep(result);
    this.shown = result;
  }

  /** @param {Result} result */
  #keep(result) {
    result.number = ++this.#runs;
    this.results.push(result);
    this.isUnsaved = this.source === null;
    const size = () => this.results.reduce((sum, { size: bytes }) => sum + bytes, 0);
    const isTooMuch = () => this.results.length > most.results || size() > most.bytes;
    while (this.results.length > 1 && isTooMuch()) this.results.shift();
    if (this.baseline && !this.results.includes(this.baseline)) this.baseline = null;
  }

  /** The files of a result in a format. @param {Result} result @param {string} format
   * @param {import('remesher').ConvertOptions} [how] */
  async filesIn(result, format, how = {}) {
    const saved = await result.filesIn(format, how, () => this.#begin());
    if (result === this.shown) this.isUnsaved = false;
    return saved;
  }

  /** A result and coarser ones, each with half as many vertices as the one before.
   * @param {Result} result @param {number} levels
   * @returns {Promise<NamedBytes[]>} GLB files */
  async levels(result, levels) {
    const { report, options } = result;
    const rest = { ...options, faces: undefined, ratio: undefined, edgeLength: undefined };
    delete rest.maxError;
    const files = [];
    for (let level = 0; level < levels; ++level) {
      const vertices = Math.max(4, Math.round(report.output.vertices / 2 ** level));
      const { bytes } = level === 0 ? result
        : await this.workOnOther(this.#opened(), {}, { ...rest, vertices, output: 'glb' });
      files.push({ name: result.nameIn('glb', `lod${level}`), bytes });
    }
    if (result === this.shown) this.isUnsaved = false;
    return files;
  }
}
