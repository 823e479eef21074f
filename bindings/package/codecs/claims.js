// SPDX-License-Identifier: MIT
// Compares what a compressed range claims to hold with its bytes, before room is made for it: a few
// bytes may claim gigabytes. No encoder packs more densely than these limits.

/** @typedef {{ count: number, byteStride: number, mode: string }} Layout */

/**
 * The fewest bytes that meshoptimizer's codecs make of a range. Vertices: a header, and for each
 * block two bits of control for each byte of a vertex. Triangles and indices: a byte each.
 * @param {Layout} layout
 */
function fewestBytes({ count, byteStride, mode }) {
  if (mode === 'TRIANGLES') return 1 + count / 3;
  if (mode === 'INDICES') return 1 + count;
  const mostInBlock = 256;
  const bytesOfBlock = 8192;
  const inBlock = Math.min(mostInBlock, 16 * Math.floor(bytesOfBlock / byteStride / 16));
  return 1 + Math.ceil(count / inBlock) * (byteStride / 4);
}

/** @param {Layout} layout @param {number} length bytes of the compressed range */
export function requireHolds(layout, length) {
  if (length >= fewestBytes(layout)) return;
  throw new Error(`${length} bytes claim to hold ${layout.count} elements`);
}

/**
 * Ranges may overlap, and none of a real file's do so many times.
 * @param {number} used bytes of all compressed ranges together @param {number} given all bytes
 */
export function requireDistinct(used, given) {
  const mostTimes = 8;
  if (used <= mostTimes * given) return;
  throw new Error('its compressed ranges overlap many times');
}

// Bytes that a file may decompress to whatever its size is, and how many times its own size.
const few = 2 ** 24;
const mostTimes = 1100;

/** @param {number} length what all ranges decompress to @param {number} given all bytes */
export function requireLength(length, given) {
  if (length <= few || length <= mostTimes * given) return;
  throw new Error(`${given} bytes claim to hold ${length}`);
}

/** @param {Uint8Array} bytes @param {number} at @returns {[number, number]} value, place behind */
function variableLength(bytes, at) {
  let value = 0;
  for (let shift = 0; shift < 35; shift += 7) {
    const byte = bytes[at] ?? 0;
    at += 1;
    value += (byte & 0x7f) * 2 ** shift;
    if (byte < 0x80) break;
  }
  return [value, at];
}

/**
 * Draco says how many triangles and vertices there are behind its header, in version 2.2; in a
 * file with metadata, behind these, which are not read here.
 * @param {Uint8Array} bytes
 */
export function requireDracoHolds(bytes) {
  const [headerBytes, method, metadata, mostPerByte] = [11, 8, 0x8000, 1024];
  const isKnown = bytes.length > headerBytes && bytes[5] === 2 && bytes[6] >= 2;
  if (!isKnown || ((bytes[9] | (bytes[10] << 8)) & metadata) !== 0) return;
  const begin = headerBytes + (bytes[method] === 1 ? 1 : 0); // the traversal's kind
  const [first, next] = variableLength(bytes, begin);
  const [second] = variableLength(bytes, next);
  const most = Math.max(first, second);
  if (most > mostPerByte * bytes.length) {
    throw new Error(`${bytes.length} bytes claim to hold ${most} triangles or vertices`);
  }
}
