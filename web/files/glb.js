// SPDX-License-Identifier: MIT
// Splits a GLB into its glTF tree and the binary data that the tree refers to.

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
