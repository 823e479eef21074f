// SPDX-License-Identifier: MIT
// Whether new textures serve a glTF file better than its own: only then does a preset bake them.

/** How a material is drawn: materials of one kind can share a set of maps.
 * @param {{ alphaMode?: string, doubleSided?: boolean, extensions?: any }} material */
const kindOf = ({ alphaMode = 'OPAQUE', doubleSided = false, extensions = {} }) =>
  `${alphaMode} ${doubleSided} ${'KHR_materials_unlit' in extensions}`;

const triangleList = 4;

/** @param {any} tree of a glTF file */
const trianglesOf = ({ meshes = [], accessors = [] }) => meshes
  .flatMap((/** @type {any} */ { primitives }) => primitives)
  .filter((/** @type {any} */ { mode = triangleList }) => mode === triangleList)
  .reduce((/** @type {number} */ sum, /** @type {any} */ { indices, attributes }) =>
    sum + accessors[indices ?? attributes.POSITION].count / 3, 0);

/** Whether a texture is there only as KTX2, which cannot be baked from.
 * @param {{ source?: number, extensions?: any }} texture */
const isKtxOnly = ({ source, extensions = {} }) => source === undefined
  && extensions.KHR_texture_basisu !== undefined && extensions.EXT_texture_webp === undefined;

/**
 * Whether the preset `asset` bakes new textures: several materials become one. Triangles that all
 * stay keep their own texture coordinates, and so do cards whose alpha cuts them out: many leaves
 * share the texels of one. So does what has textures in KTX2 only.
 * @param {any} tree of a glTF file, its JSON
 * @param {number} faces the budget; 0: there is none
 * @returns {boolean}
 */
export function isWorthBaking(tree, faces) {
  try {
    const { materials = [], textures = [] } = tree;
    if (textures.some(isKtxOnly)) return false;
    if (new Set(materials.map(kindOf)).size < materials.length) return true;
    if (materials.some((/** @type {any} */ { alphaMode }) => alphaMode === 'MASK')) return false;
    return faces < trianglesOf(tree);
  } catch {
    return true; // the engine says what is wrong with the file
  }
}
