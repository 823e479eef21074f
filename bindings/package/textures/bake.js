// SPDX-License-Identifier: MIT
// Wraps a run that bakes textures: decodes images before it, and encodes images after it.

import { isGltf } from '../base/contents.js';
import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { referencesOf } from '../codecs/resources.js';
import { imagesOf, normalsOf, withImages } from './gltf_images.js';
import { ImageWorkers } from './image_workers.js';
import { imageHeader } from './image_header.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */
/** @typedef {import('../base/messages.js').Picture} Picture */
/** @typedef {(event: import('../base/messages.js').ProgressEvent) => boolean | void} OnProgress */

/** The shares of decoding and encoding in the whole run. */
const shares = { decoding: 0.07, encoding: 0.25 };

/** By how much the quality of new images is lowered in turn while they take more bytes than those
 * they were baked from: more detail than these had, no quality brings back. */
const lowerings = [3, 6, 9];

/** @param {readonly { bytes: Uint8Array }[]} images */
const sizeOf = (images) => images.reduce((sum, { bytes }) => sum + bytes.length, 0);

/** The images that an OBJ's material libraries name; the core says which are missing.
 * @param {FileRequest} file */
function imagesBeside({ name: model, resources }) {
  const named = new Set(resources.flatMap(({ name, bytes }) =>
    (/\.mtl$/i.test(name) ? referencesOf(name, bytes) : [])));
  return resources.filter(({ name }) => named.has(name)).map(({ name, bytes }) =>
    ({ name, label: `${legible(model)}: Image ${legible(name)}`, bytes }));
}

/** Bytes that WebAssembly has for decoded images: all but what the smallest model takes. */
const mostDecoded = 2 ** 32 - 2 ** 28;

/** Decoded, images of more bytes than these are so large that no two are decoded at once. */
const fewDecoded = 2 ** 29;

/** The bytes of all texels, but for images that are too large by themselves: their decoder refuses
 * these by name. @param {readonly { bytes: Uint8Array }[]} images */
const decodedSize = (images) => images.reduce((sum, { bytes }) => {
  const { width = 0, height = 0 } = imageHeader(bytes) ?? {};
  const size = 4 * width * height;
  return size > mostDecoded ? sum : sum + size;
}, 0);

/** @param {number} size the bytes of all texels @param {number} count @param {string} name */
function requireRoom(size, count, name) {
  if (size <= mostDecoded) return;
  const gigabytes = (/** @type {number} */ bytes) => (bytes / 1e9).toFixed(2);
  throw new RemeshError('OUT_OF_MEMORY',
    `${legible(name)}: Decoded, its ${count} images take ${gigabytes(size)} GB of memory; there `
      + `are ${gigabytes(mostDecoded)} GB, enough for about `
      + `${Math.floor((count * mostDecoded) / size)} of them.`,
    'Give smaller images, or keep the textures.');
}

export class Baker {
  #imageWorkers;
  #onProgress;
  #areWebp = false;
  #areNormalsJpeg = false;
  /** Bytes of the images that are baked from. */
  #given = 0;

  /**
   * @param {import('./image_codecs.js').CodecSource} source
   * @param {OnProgress} [onProgress] returns false to stop the run
   */
  constructor(source, onProgress) {
    this.#imageWorkers = new ImageWorkers(source);
    this.#onProgress = onProgress;
  }

  /** @param {string} phase @param {number} fraction */
  #tell(phase, fraction) {
    if (this.#onProgress?.({ phase, fraction }) !== false) return;
    throw new RemeshError('CANCELLED', 'The run was cancelled.');
  }

  /** Progress of the run in between. @returns {OnProgress | undefined} */
  get onPainting() {
    const { decoding, encoding } = shares;
    return this.#onProgress && (({ phase, fraction }) =>
      this.#onProgress?.({ phase, fraction: decoding + (1 - decoding - encoding) * fraction }));
  }

  /** WebP if all images came as WebP: programs that read them read new ones, too.
   * @returns {'webp' | undefined} */
  get usualFormat() {
    return this.#areWebp ? 'webp' : undefined;
  }

  /** @param {FileRequest} file @returns {Promise<FileRequest>} with its images decoded */
  async opened(file) {
    const images = isGltf(file.bytes) ? imagesOf(file) : imagesBeside(file);
    const size = decodedSize(images);
    requireRoom(size, images.length, file.name);
    this.#given = sizeOf(images);
    this.#areWebp = images.length > 0
      && images.every(({ bytes }) => imageHeader(bytes)?.type === 'image/webp');
    const normals = isGltf(file.bytes) ? normalsOf(file) : [];
    this.#areNormalsJpeg = normals.length > 0
      && normals.every((bytes) => imageHeader(bytes)?.type === 'image/jpeg');
    const decoded = await this.#imageWorkers.run(
      images.map(({ label, bytes }) => ({ work: 'decode', image: { name: label, bytes } })),
      (done) => this.#tell('decode images', shares.decoding * done / (images.length || 1)),
      size > fewDecoded);
    const pictures = images.map(({ name }, i) => ({ name, type: '', ...decoded[i] }));
    return { ...file, pictures };
  }

  /** Normals as JPEG where they came so and no format was asked for, or where that was.
   * @param {Picture} picture @param {unknown} format as it was asked for @returns {Picture} */
  #settled(picture, format) {
    const isJpeg = format === 'jpeg' || (format === undefined && this.#areNormalsJpeg);
    return isJpeg && picture.name === 'normal' ? { ...picture, type: 'image/jpeg' } : picture;
  }

  /** @param {any} outcome as the core gives it
   * @param {unknown} [format] of textures, as it was asked for */
  async closed({ pictures: made = [], ...outcome }, format) {
    const pictures = made.map((/** @type {Picture} */ one) => this.#settled(one, format));
    return { ...outcome, files: withImages(outcome.files, await this.#encoded(pictures)) };
  }

  /** @param {Picture[]} pictures */
  async #encoded(pictures) {
    const encode = (/** @type {Picture[]} */ images, /** @type {(done: number) => number} */ at) =>
      this.#imageWorkers.run(images.map((image) => ({ work: 'encode', image })),
        (done) => this.#tell('encode images', at(done)));
    const bytes = await encode(pictures,
      (done) => 1 - shares.encoding * (1 - done / (pictures.length || 1)));
    const all = pictures.map(({ name, type }, i) => ({ name, type, bytes: bytes[i] }));
    const lossy = [...pictures.keys()].filter((i) => pictures[i].type !== 'image/png');
    for (const lowered of this.#given > 0 && lossy.length > 0 ? lowerings : []) {
      if (sizeOf(all) <= this.#given) break;
      const smaller = await encode(lossy.map((i) => ({ ...pictures[i], lowered })), () => 1);
      lossy.forEach((i, k) => { all[i].bytes = smaller[k]; });
    }
    return all;
  }

  /** Must be called in the end, whatever happened. */
  end() {
    this.#imageWorkers.end();
  }
}
