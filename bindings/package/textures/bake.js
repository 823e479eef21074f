// SPDX-License-Identifier: MIT
// Around a run that bakes textures: images are decoded before, and encoded behind it.

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { referencesOf } from '../codecs/resources.js';
import { ImageCodecs } from './image_codecs.js';
import { imagesOf, withImages } from './gltf_images.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */
/** @typedef {import('../base/messages.js').Picture} Picture */
/** @typedef {(event: import('../base/messages.js').ProgressEvent) => boolean | void} OnProgress */

/** What decoding and encoding take of the whole run. */
const shares = { decoding: 0.07, encoding: 0.25 };

/** Those that an OBJ's material libraries name; the core says which are missing.
 * @param {FileRequest} file */
function imagesBeside({ name: model, resources }) {
  const named = new Set(resources.flatMap(({ name, bytes }) =>
    (/\.mtl$/i.test(name) ? referencesOf(name, bytes) : [])));
  return resources.filter(({ name }) => named.has(name)).map(({ name, bytes }) =>
    ({ name, label: `${legible(model)}: Image ${legible(name)}`, bytes }));
}

export class Bakery {
  #codecs;
  #onProgress;

  /**
   * @param {import('./image_codecs.js').CodecSource} source
   * @param {OnProgress} [onProgress] returns false to stop the run
   */
  constructor(source, onProgress) {
    this.#codecs = new ImageCodecs(source);
    this.#onProgress = onProgress;
  }

  /** @param {string} phase @param {number} fraction */
  #tell(phase, fraction) {
    if (this.#onProgress?.({ phase, fraction }) !== false) return;
    throw new RemeshError('CANCELLED', 'The run was cancelled.');
  }

  /** For the run in between. @returns {OnProgress | undefined} */
  get onPainting() {
    const { decoding, encoding } = shares;
    return this.#onProgress && (({ phase, fraction }) =>
      this.#onProgress?.({ phase, fraction: decoding + (1 - decoding - encoding) * fraction }));
  }

  /** @param {FileRequest} file @returns {Promise<FileRequest>} with its images decoded */
  async opened(file) {
    const images = /\.gl(b|tf)$/i.test(file.name) ? imagesOf(file) : imagesBeside(file);
    const pictures = [];
    for (const [i, { name, label, bytes }] of images.entries()) {
      this.#tell('decode images', shares.decoding * i / images.length);
      pictures.push({ name, type: '', ...await this.#codecs.decode({ name: label, bytes }) });
    }
    return { ...file, pictures };
  }

  /** @param {any} outcome as the core gives it */
  async closed({ pictures = [], ...outcome }) {
    const encoded = [];
    for (const [i, picture] of /** @type {Picture[]} */ (pictures).entries()) {
      const { name, type } = picture;
      this.#tell('encode images', 1 - shares.encoding * (1 - i / pictures.length));
      encoded.push({ name, type, bytes: await this.#codecs.encode(picture) });
    }
    return { ...outcome, files: withImages(outcome.files, encoded) };
  }
}
