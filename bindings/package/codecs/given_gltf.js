// SPDX-License-Identifier: MIT
// Facts about the given glTF file that presets need: how it is compressed, and whether new
// textures serve it better than its own.
import { isBakedInVain, isWorthBaking } from '../base/worth_baking.js';
import { openContainer } from './gltf_container.js';

/** The tree of a glTF file; undefined if it has none: the engine says what is wrong with it.
 * @param {Uint8Array} bytes @returns {any} */
function treeIn(bytes) {
  try {
    return JSON.parse(openContainer(bytes).text);
  } catch {
    return undefined;
  }
}

/**
 * @param {Uint8Array} bytes of a glTF file
 * @param {number} faces the budget; 0: there is none
 * @returns {boolean}
 */
export const isFileWorthBaking = (bytes, faces) => isWorthBaking(treeIn(bytes), faces);

/**
 * @param {Uint8Array} bytes of the given glTF file
 * @param {{ hausdorff: number } | null} [fidelity] of the baked result
 * @returns {boolean}
 */
export const wasFileBakedInVain = (bytes, fidelity) => isBakedInVain(treeIn(bytes), fidelity);

/**
 * How the geometry of a glTF file is compressed; undefined if it is not.
 * @param {Uint8Array} bytes
 * @returns {'meshopt' | 'draco' | undefined}
 */
export function compressionIn(bytes) {
  const { extensionsUsed: used } = Object(treeIn(bytes));
  if (!Array.isArray(used)) return undefined;
  if (used.includes('KHR_draco_mesh_compression')) return 'draco';
  return used.some((name) => /^(EXT|KHR)_meshopt_compression$/.test(name)) ? 'meshopt' : undefined;
}
