// SPDX-License-Identifier: MIT
// The codecs of images, where the package looks for them: in one script, for they are much alike.
import * as decodeJpeg from '@jsquash/jpeg/decode.js';
import * as encodeJpeg from '@jsquash/jpeg/encode.js';
import * as decodePng from '@jsquash/png/decode.js';
import * as encodePng from '@jsquash/png/encode.js';
import '@jsquash/webp/codec/enc/webp_enc_simd.js';
import * as decodeWebp from '@jsquash/webp/decode.js';
import * as encodeWebp from '@jsquash/webp/encode.js';

const packages = /** @type {Record<string, object[]>} */ ({
  '@jsquash/jpeg': [decodeJpeg, encodeJpeg],
  '@jsquash/png': [decodePng, encodePng],
  '@jsquash/webp': [decodeWebp, encodeWebp],
});

/** @param {string} name */
export const loadPackage = async (name) => packages[name];
