// SPDX-License-Identifier: MIT
// One model, its latest result, and at most one run: a new run ends the one before it. Knows the
// package and nothing of the page. Every method rejects with AbortError when it was overtaken.
import { convertFile, inspect, remeshFile } from 'remesher';
import { extensionOf } from './files.js';

/** @typedef {import('./models.js').Model} Model */
/** @typedef {import('remesher').RemeshFileResult} RemeshFileResult */
/** @typedef {import('remesher').RemeshOptions} RemeshOptions */
/** @typedef {import('remesher').ProgressEvent} ProgressEvent */
/** @typedef {import('remesher').NamedBytes} NamedBytes */

/** @param {Model} model what every call says of a file */
const describe = ({ name, resources }) => ({
  name, resources: Object.fromEntries(resources.map(({ name: key, bytes }) => [key, bytes])),
});

export class Session {
  #controller = new AbortController();
  /** @type {(event: ProgressEvent) => void} */
  #onProgress;
  /** @type {Model | null} */
  model = null;
  /** What an address can name the model by; null for the visitor's own. @type {string | null} */
  source = null;
  /** @type {import('remesher').Inspection | null} of the model */
  inspection = null;
  /** @type {RemeshOptions} of the latest result */
  options = {};
  /** @type {RemeshFileResult | null} as GLB */
  result = null;

  /** @param {(event: ProgressEvent) => void} onProgress */
  constructor(onProgress) {
    this.#onProgress = onProgress;
  }

  #begin() {
    this.cancel();
    this.#controller = new AbortController();
    return this.#controller.signal;
  }

  cancel() {
    this.#controller.abort();
  }

  /** Makes this the model, and reports on it; a file that cannot be read leaves the old one.
   * @param {Model} model @param {string | null} source */
  async open(model, source) {
    const signal = this.#begin();
    const report = await inspect(model.bytes, { ...describe(model), signal });
    Object.assign(this, { model, source, inspection: report, result: null });
    return report;
  }

  /** The model as glTF, for the viewer: the file itself, or a conversion.
   * @param {'direct' | 'converted'} way */
  async originalAsGltf(way) {
    const model = this.#opened();
    if (way === 'direct' && ['glb', 'gltf'].includes(extensionOf(model.name))) return model;
    const { signal } = this.#controller;
    const { bytes } = await convertFile(model.bytes, { ...describe(model), output: 'glb', signal });
    return { bytes, resources: [] };
  }

  #opened() {
    if (!this.model) throw new Error('There is no model');
    return this.model;
  }

  /** @param {RemeshOptions} options @param {string} output */
  #remesh(options, output) {
    return this.remeshOther(this.#opened(), { ...options, output });
  }

  /** Remeshes a model that is not opened, and keeps nothing of it.
   * @param {Model} model
   * @param {RemeshOptions & import('remesher').OutputOptions} options */
  remeshOther(model, options) {
    const onProgress = this.#onProgress;
    const signal = this.#begin();
    return remeshFile(model.bytes, { ...describe(model), ...options, onProgress, signal });
  }

  /** @param {RemeshOptions} options */
  async run(options) {
    const result = await this.#remesh(options, 'glb');
    this.result = result;
    this.options = options;
    return result;
  }

  /** The latest result's files in a format. A format other than the shown one is made from the
   * original again, so that it keeps what only that format can say; the same input and options
   * give the same mesh.
   * @param {string} format @returns {Promise<NamedBytes[]>} */
  async filesAs(format) {
    if (!this.result) throw new Error('There is no result');
    if (format === 'glb') return this.result.files;
    return (await this.#remesh(this.options, format)).files;
  }
}
