// SPDX-License-Identifier: MIT
// Whether new textures serve a glTF file better than its own: only then does a preset bake them.

import { openContainer } from '../codecs/gltf_container.js';

/** How a material is drawn: materials of one kind can share a set of maps.
 * @param {{ alphaMode?: string, doubleSided?: boolean }} material */
const kindOf = ({ alphaMode = 'OPAQUE', doubleSided = false }) => `${alphaMode} ${doubleSided}`;

const triangleList = 4;

/** @param {any} tree of a glTF file */
const trianglesOf = ({ meshes = [], accessors = [] }) => meshes
  .flatMap((/** @type {any} */ { primitives }) => primitives)
  .filter((/** @type {any} */ { mode = triangleList }) => mode === triangleList)
  .reduce((/** @type {number} */ sum, /** @type {any} */ { indices, attributes }) =>
    sum + accessors[indices ?? attributes.POSITION].count / 3, 0);

/**
 * Several materials become one. Triangles that all stay keep their own texture coordinates, and so
 * do cards whose alpha cuts them out: many leaves share the texels of one.
 * @param {Uint8Array} bytes of a GLB or glTF
 * @param {number} faces the budget; 0: there is none
 */
export function isWorthBaking(bytes, faces) {
  try {
    const tree = JSON.parse(openContainer(bytes).text);
    const materials = tree.materials ?? [];
    if (new Set(materials.map(kindOf)).size < materials.length) return true;
    if (materials.some((/** @type {any} */ { alphaMode }) => alphaMode === 'MASK')) return false;
    return faces < trianglesOf(tree);
  } catch {
    return true; // the engine says what is wrong with the file
  }
}
