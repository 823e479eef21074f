// SPDX-License-Identifier: MIT
// Images to texels and back, by Squoosh's codecs in WebAssembly: the same bytes in Node and every
// browser. They are packages of their own, loaded when they are needed. KTX2 textures are decoded
// only, by a module of this package.

import { loadPackage } from './codec_packages.js';
import { imageHeader } from './image_header.js';
import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';

/** @typedef {import('../base/messages.js').Picture} Picture */

/**
 * Where the packages come from.
 * @typedef {object} CodecSource
 * @property {(name: string) => Promise<any[]>} [load] A package's two halves: to decode, to encode.
 * @property {(path: string) => Promise<WebAssembly.Module>} [compile] A file of a package; without
 *   it, the codec finds its own.
 * @property {() => import('../base/messages.js').ImagePort | undefined} [spawn] Starts a worker for
 *   images, where there can be any.
 * @property {number} [helpers] How many of them at most; none, if not said.
 */

// A larger image has more texels than are worth holding.
const largestImage = 2 ** 26;

/**
 * For each type: its package, the WebAssembly of its two halves, and how it encodes.
 * @type {Record<string, { name: string, decoder: string, encoder: string, options?: object }>}
 */
const codecs = {
  'image/png': {
    name: '@jsquash/png',
    decoder: '@jsquash/png/codec/pkg/squoosh_png_bg.wasm',
    encoder: '@jsquash/png/codec/pkg/squoosh_png_bg.wasm',
  },
  'image/jpeg': {
    name: '@jsquash/jpeg',
    decoder: '@jsquash/jpeg/codec/dec/mozjpeg_dec.wasm',
    encoder: '@jsquash/jpeg/codec/enc/mozjpeg_enc.wasm',
    options: { progressive: false }, // that takes twice as long for a fiftieth less
  },
  'image/webp': {
    name: '@jsquash/webp',
    decoder: '@jsquash/webp/codec/dec/webp_dec.wasm',
    encoder: '@jsquash/webp/codec/enc/webp_enc_simd.wasm',
  },
};

/** The quality of lossy images, up to 100. Small images are looked at from so near that their noise
 * would show, and weigh little. @param {number} count of texels */
const qualityFor = (count) => (count <= 512 ** 2 ? 97 : 90);

/** What suits a picture. In maps of normals and of surfaces hues are numbers of their own, which
 * JPEG must not blur: a lower quality keeps them better than a higher one with blurred hues, in
 * fewer bytes. @param {Omit<Picture, 'texels'>} picture */
function qualityOf({ name, type, width, height, lowered = 0 }) {
  const quality = qualityFor(width * height) - lowered;
  if (type !== 'image/jpeg') return { quality };
  return { quality: name === 'normal' ? Math.max(quality - 5, 78) : quality,
    auto_subsample: false, chroma_subsample: 1 };
}

/**
 * Runs with a class ImageData, which the decoders need and Node lacks.
 * @template T
 * @param {() => Promise<T>} body
 */
async function withImageData(body) {
  const scope = /** @type {any} */ (globalThis);
  if (scope.ImageData) return body();
  scope.ImageData = class {
    /** @param {Uint8ClampedArray} data @param {number} width @param {number} height */
    constructor(data, width, height) {
      Object.assign(this, { data, width, height });
    }
  };
  try {
    return await body();
  } finally {
    delete scope.ImageData;
  }
}

/** @param {{ name: string, bytes: Uint8Array }} image @returns {string} its type */
function typeOf({ name, bytes }) {
  const header = imageHeader(bytes);
  if (!header) {
    throw new RemeshError('UNSUPPORTED', `${name} is neither PNG nor JPEG nor WebP nor KTX2.`,
      'Convert it first, or keep the textures.');
  }
  if (header.isForGpu) {
    throw new RemeshError('UNSUPPORTED',
      `${name} is a KTX2 texture of neither ETC1S nor UASTC, which cannot be painted from.`,
      'Convert it to one of these, PNG, JPEG or WebP first, or keep the textures.');
  }
  if (header.isAnimated) {
    throw new RemeshError('UNSUPPORTED', `${name} is animated, which cannot be painted from.`,
      'Give one of its frames, or keep the textures.');
  }
  if ((header.width ?? 0) * (header.height ?? 0) > largestImage) {
    throw new RemeshError('UNSUPPORTED',
      `${name} has ${header.width} × ${header.height} texels; ${largestImage} are the most.`,
      'Scale it down first.');
  }
  requireHolds(header, bytes.length, name);
  return header.type;
}

// Deflate makes at most so many bytes of one.
const mostInflated = 1032;

/**
 * A few bytes may claim gigabytes of texels; room for these is made before they are read. In WebP
 * a few bytes may truly say that all texels are alike.
 * @param {import('./image_header.js').ImageHeader} header
 * @param {number} length bytes @param {string} name
 */
function requireHolds({ type, width = 0, height = 0, fewestBits = 0 }, length, name) {
  const bytes = width * height * fewestBits / 8;
  if (bytes <= length * (type === 'image/png' ? mostInflated : 1)) return;
  throw new RemeshError('PARSE_ERROR',
    `${name} claims ${width} × ${height} texels, more than its ${length} bytes can hold.`,
    'Was it copied completely?');
}

export class ImageCodecs {
  #source;
  /** @type {Map<string, Promise<any[]>>} */
  #loaded = new Map();

  /** @param {CodecSource} source */
  constructor({ load = loadPackage, compile }) {
    this.#source = { load, compile };
  }

  /** @param {string} type */
  #load(type) {
    const known = this.#loaded.get(type);
    if (known) return known;
    const loading = type === 'image/ktx2'
      ? import('../codecs/ktx_textures.js').then(({ decodeKtx2 }) => [decodeKtx2])
      : this.#loadPackage(codecs[type]);
    this.#loaded.set(type, loading);
    return loading;
  }

  /** @param {typeof codecs[string]} codec */
  async #loadPackage({ name, decoder, encoder }) {
    const { load, compile } = this.#source;
    const [decode, encode] = await load(name);
    if (compile) {
      const modules = await Promise.all([compile(decoder), compile(encoder)]);
      await decode.init(modules[0]);
      await encode.init(modules[1]);
    }
    return [decode.default, encode.default];
  }

  /**
   * @param {{ name: string, bytes: Uint8Array }} image called so where it cannot be decoded
   * @returns {Promise<Omit<Picture, 'name' | 'type'>>}
   */
  async decode(image) {
    const type = typeOf(image);
    return withImageData(async () => {
      const [decode] = await this.#load(type);
      try {
        const { data, width, height } = await decode(image.bytes.slice().buffer);
        return { width, height, texels: new Uint8Array(data.buffer) };
      } catch (cause) {
        this.#loaded.delete(type);
        throw new RemeshError('PARSE_ERROR', `${legible(image.name)} cannot be decoded.`,
          'Was it copied completely?', { cause });
      }
    });
  }

  /** @param {Picture} picture @returns {Promise<Uint8Array>} */
  async encode({ texels, ...picture }) {
    const { type, width, height } = picture;
    return withImageData(async () => {
      const [, encode] = await this.#load(type);
      const data = new Uint8ClampedArray(texels.buffer, texels.byteOffset, texels.byteLength);
      return new Uint8Array(await encode({ data, width, height },
        { ...codecs[type].options, ...qualityOf(picture) }));
    });
  }
}
