// SPDX-License-Identifier: MIT
// Whether the textures of a glTF model lie in so many pieces that their seams would hold most of
// the vertices of a lighter one: then new textures are painted.
import { treeOf } from '../files/glb.js';

/** Stored vertices for each distinct position: a model of few clean charts has hardly more. */
const many = 1.2;

/** @param {Uint8Array} bytes of a glTF file @param {number} vertices its distinct positions */
export function hasManySeams(bytes, vertices) {
  try {
    const { textures = [], meshes = [], accessors = [] } = treeOf(bytes);
    const stored = new Set(meshes.flatMap((/** @type {any} */ { primitives }) =>
      primitives.map((/** @type {any} */ { attributes }) => attributes.POSITION)));
    const count = [...stored].reduce((sum, index) => sum + (accessors[index]?.count ?? 0), 0);
    return textures.length > 0 && count > many * vertices;
  } catch {
    return false;  // the reader reports the error better
  }
}
