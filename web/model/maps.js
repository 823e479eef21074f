// SPDX-License-Identifier: MIT
// The images inside a GLB, with the names of their texture maps.
import { openGlb } from '../files/glb.js';

/** name: of the map, or ''. @typedef {{ name: string, type: string, bytes: Uint8Array }} Map */

/** @param {Uint8Array} glb @returns {Map[]} in their order */
export function mapsOf(glb) {
  const { tree, binary } = openGlb(glb);
  return (tree.images ?? []).map((/** @type {any} */ { name = '', mimeType, bufferView }) => {
    const { byteOffset = 0, byteLength } = tree.bufferViews[bufferView];
    return { name, type: mimeType, bytes: binary.subarray(byteOffset, byteOffset + byteLength) };
  });
}
