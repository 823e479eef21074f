// SPDX-License-Identifier: MIT
// Around a run that bakes textures: images are decoded before, and encoded behind it.

import { ImageCodecs } from './image_codecs.js';
import { imagesOf, withImages } from './gltf_images.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */
/** @typedef {import('../base/messages.js').Picture} Picture */

export class Bakery {
  #codecs;

  /** @param {import('./image_codecs.js').CompileCodec} compile */
  constructor(compile) {
    this.#codecs = new ImageCodecs(compile);
  }

  /** @param {FileRequest} file @returns {Promise<FileRequest>} with its images decoded */
  async opened(file) {
    if (!/\.gl(b|tf)$/i.test(file.name)) return file;
    const pictures = [];
    for (const { name, label, bytes } of imagesOf(file)) {
      pictures.push({ name, type: '', ...await this.#codecs.decode({ name: label, bytes }) });
    }
    return { ...file, pictures };
  }

  /** @param {any} outcome as the core gives it */
  async closed({ pictures = [], ...outcome }) {
    const encoded = [];
    for (const picture of /** @type {Picture[]} */ (pictures)) {
      const { name, type } = picture;
      encoded.push({ name, type, bytes: await this.#codecs.encode(picture) });
    }
    return { ...outcome, files: withImages(outcome.files, encoded) };
  }
}
