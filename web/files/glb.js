// SPDX-License-Identifier: MIT
// What a GLB is made of: the tree that a glTF has as text, and the bytes that it refers to.

const [headerBytes, chunkHead] = [12, 8];

/** Throws where it is none. @param {Uint8Array} glb @returns {{ tree: any, binary: Uint8Array }} */
export function openGlb(glb) {
  const view = new DataView(glb.buffer, glb.byteOffset, glb.byteLength);
  const start = headerBytes + chunkHead;
  const end = start + view.getUint32(headerBytes, true);
  const tree = JSON.parse(new TextDecoder().decode(glb.subarray(start, end)));
  return { tree, binary: glb.subarray(end + chunkHead) };
}
