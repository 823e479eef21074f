// SPDX-License-Identifier: MIT
// Reads the header of an image, without decoding anything.

/**
 * @typedef {object} ImageHeader
 * @property {string} type A media type.
 * @property {number} [width] Texels; unknown where the header is cut short.
 * @property {number} [height] Texels.
 * @property {number} [fewestBits] That a texel takes before compression, in PNG; in JPEG after it.
 * @property {boolean} [isAnimated] Shows nothing but in its frames.
 * @property {boolean} [isForGpu] In a format of its own, which only some graphics cards read.
 */

/** @param {Uint8Array} bytes @param {number} at @param {string} letters */
const says = (bytes, at, letters) =>
  Array.from(letters).every((letter, i) => bytes[at + i] === letter.charCodeAt(0));

/** @param {DataView} view @returns {Partial<ImageHeader>} */
function pngSize(view) {
  const end = 26;
  if (view.byteLength < end) return {};
  const channels = [1, 1, 3, 1, 2, 1, 4][view.getUint8(25)] ?? 1; // by the kind of colour
  return { width: view.getUint32(16), height: view.getUint32(20),
    fewestBits: channels * view.getUint8(24) };
}

/**
 * From marker to marker until a frame begins.
 * @param {DataView} view
 * @returns {Partial<ImageHeader>}
 */
function jpegSize(view) {
  const standalone = (/** @type {number} */ marker) =>
    marker === 0xff || marker === 0x01 || (marker >= 0xd0 && marker <= 0xd8);
  const isFrame = (/** @type {number} */ marker) =>
    marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker);
  for (let at = 2; at + 9 <= view.byteLength;) {
    if (view.getUint8(at) !== 0xff) return {};
    const marker = view.getUint8(at + 1);
    if (isFrame(marker)) {
      return { width: view.getUint16(at + 7), height: view.getUint16(at + 5), fewestBits: 1 / 64 };
    }
    at += standalone(marker) ? (marker === 0xff ? 1 : 2) : 2 + view.getUint16(at + 2);
  }
  return {};
}

/** @param {DataView} view @param {Uint8Array} bytes @returns {Partial<ImageHeader>} */
function webpSize(view, bytes) {
  if (view.byteLength < 30) return {};
  const low14 = 0x3fff;
  if (says(bytes, 12, 'VP8 ')) {
    return { width: view.getUint16(26, true) & low14, height: view.getUint16(28, true) & low14 };
  }
  if (says(bytes, 12, 'VP8L')) {
    const bits = view.getUint32(21, true);
    return { width: (bits & low14) + 1, height: ((bits >> 14) & low14) + 1 };
  }
  const low24 = 0xffffff;
  const animation = 2;
  return {
    width: (view.getUint32(24, true) & low24) + 1,
    height: (view.getUint32(26, true) >>> 8) + 1,
    isAnimated: (bytes[20] & animation) !== 0,
  };
}

/** @param {DataView} view @returns {Partial<ImageHeader>} */
function ktx2Size(view) {
  if (view.byteLength < 28) return {};
  return { width: view.getUint32(20, true), height: view.getUint32(24, true),
    isForGpu: view.getUint32(12, true) !== 0 };
}

/** @param {Uint8Array} bytes @returns {ImageHeader | undefined} undefined: no image that we know */
export function imageHeader(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes[0] === 0x89 && says(bytes, 1, 'PNG')) return { type: 'image/png', ...pngSize(view) };
  if (bytes[0] === 0xff && bytes[1] === 0xd8) return { type: 'image/jpeg', ...jpegSize(view) };
  if (says(bytes, 0, 'RIFF') && says(bytes, 8, 'WEBP')) {
    return { type: 'image/webp', ...webpSize(view, bytes) };
  }
  if (bytes[0] === 0xab && says(bytes, 1, 'KTX 20')) {
    return { type: 'image/ktx2', ...ktx2Size(view) };
  }
  return undefined;
}
