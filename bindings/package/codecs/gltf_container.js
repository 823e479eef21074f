// SPDX-License-Identifier: MIT
// glTF files in their two containers, a JSON text or a GLB, taken apart and put together. Nothing
// here judges what is inside: the core does.

const glbMagic = 0x46546c67;
const jsonChunk = 0x4e4f534a;
const binaryChunk = 0x004e4942;
const headerBytes = 12;
const chunkHeaderBytes = 8;

/**
 * @typedef {object} GltfContainer
 * @property {string} text the JSON
 * @property {Uint8Array} [chunk] the binary chunk of a GLB
 */

/** @param {Uint8Array} bytes */
function viewOf(bytes) {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

/**
 * A chunk that reaches beyond the end is cut there.
 * @param {Uint8Array} bytes
 * @returns {GltfContainer}
 */
export function openContainer(bytes) {
  const view = viewOf(bytes);
  const isGlb = bytes.length >= headerBytes + chunkHeaderBytes
    && view.getUint32(0, true) === glbMagic;
  if (!isGlb) return { text: new TextDecoder().decode(bytes) };
  const jsonBegin = headerBytes + chunkHeaderBytes;
  const jsonEnd = jsonBegin + view.getUint32(headerBytes, true);
  const text = new TextDecoder().decode(bytes.subarray(jsonBegin, jsonEnd));
  const chunkBegin = jsonEnd + chunkHeaderBytes;
  if (chunkBegin > bytes.length || view.getUint32(jsonEnd + 4, true) !== binaryChunk) {
    return { text };
  }
  return { text, chunk: bytes.subarray(chunkBegin, chunkBegin + view.getUint32(jsonEnd, true)) };
}

/** @param {number} length */
function padded(length) {
  return Math.ceil(length / 4) * 4;
}

/**
 * @param {object} tree
 * @param {Uint8Array} chunk
 * @returns {Uint8Array<ArrayBuffer>} a GLB
 */
export function packGlb(tree, chunk) {
  const json = new TextEncoder().encode(JSON.stringify(tree));
  const jsonBytes = padded(json.length);
  const chunkBytes = padded(chunk.length);
  const total = headerBytes + 2 * chunkHeaderBytes + jsonBytes + chunkBytes;
  const bytes = new Uint8Array(total);
  const view = viewOf(bytes);
  const chunkAt = headerBytes + chunkHeaderBytes + jsonBytes;
  [glbMagic, 2, total, jsonBytes, jsonChunk]
    .forEach((word, i) => view.setUint32(4 * i, word, true));
  bytes.fill(0x20, headerBytes + chunkHeaderBytes, chunkAt);
  bytes.set(json, headerBytes + chunkHeaderBytes);
  view.setUint32(chunkAt, chunkBytes, true);
  view.setUint32(chunkAt + 4, binaryChunk, true);
  bytes.set(chunk, chunkAt + chunkHeaderBytes);
  return bytes;
}
