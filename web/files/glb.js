// SPDX-License-Identifier: MIT
// A GLB is a glTF tree and the binary data that the tree refers to.

const [headerBytes, chunkHead] = [12, 8];

/** Throws if the bytes are not a GLB.
 * @param {Uint8Array} glb @returns {{ tree: any, binary: Uint8Array }} */
export function openGlb(glb) {
  const view = new DataView(glb.buffer, glb.byteOffset, glb.byteLength);
  const start = headerBytes + chunkHead;
  const end = start + view.getUint32(headerBytes, true);
  const tree = JSON.parse(new TextDecoder().decode(glb.subarray(start, end)));
  return { tree, binary: glb.subarray(end + chunkHead) };
}

/** The tree of a GLB or of a .gltf. Throws if the bytes are neither. @param {Uint8Array} bytes */
export function treeOf(bytes) {
  const isBinary = bytes[0] === 'g'.charCodeAt(0);
  return isBinary ? openGlb(bytes).tree : JSON.parse(new TextDecoder().decode(bytes));
}

const [magic, jsonChunk, binaryChunk] = [0x46546c67, 0x4e4f534a, 0x004e4942];

/** @param {number} bytes */
const padded = (bytes) => bytes + (-bytes & 3);

/** A GLB of a tree and its binary data, in pieces of whole words.
 * @param {any} tree @param {Uint8Array[]} pieces @returns {Uint8Array<ArrayBuffer>} */
export function glbOf(tree, pieces) {
  const text = new TextEncoder().encode(JSON.stringify(tree));
  const binary = pieces.reduce((sum, { length }) => sum + length, 0);
  const start = headerBytes + chunkHead + padded(text.length);
  const glb = new Uint8Array(start + chunkHead + binary).fill(0x20, 0, start);
  const view = new DataView(glb.buffer);
  [magic, 2, glb.length, padded(text.length), jsonChunk].forEach((word, i) =>
    view.setUint32(4 * i, word, true));
  glb.set(text, headerBytes + chunkHead);
  view.setUint32(start, binary, true);
  view.setUint32(start + 4, binaryChunk, true);
  let at = start + chunkHead;
  for (const piece of pieces) {
    glb.set(piece, at);
    at += piece.length;
  }
  return glb;
}
