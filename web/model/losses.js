// SPDX-License-Identifier: MIT
// The parts of a result that a format cannot hold. The core warns of attributes, images and hidden
// parts; the rest is seen in the glTF tree of the result.

/** `loss.KIND` in the texts; count: of what is lost, where that is a number.
 * @typedef {{ kind: 'quads' | 'parts' | 'scene' | 'looks', count: number }} Loss */

/** The formats that hold no faces of four corners. */
export const trianglesOnly = ['stl', '3mf'];

/** The primitives that the scene shows: one for each part and material. @param {any} tree */
function primitivesOf({ nodes = [], meshes = [] }) {
  return nodes.flatMap((/** @type {any} */ { mesh }) => meshes[mesh]?.primitives ?? []);
}

/** @param {any} tree */
const hasLooks = ({ materials = [] }) => materials.some((/** @type {object} */ material) =>
  Object.keys(material).some((key) => key !== 'name'));

/** @param {any} tree */
const hasScene = ({ animations, skins, cameras, extensionsUsed = [] }) =>
  Boolean(animations ?? skins ?? cameras) || extensionsUsed.includes('KHR_lights_punctual');

/**
 * @param {any} tree of the result as glTF
 * @param {string} format that is written
 * @returns {Loss[]}
 */
export function lossesIn(tree, format) {
  if (format === 'glb' || format === 'gltf') return [];
  const primitives = primitivesOf(tree);
  const isQuads = tree.extensionsUsed?.includes('FB_ngon_encoding');
  /** @type {[Loss['kind'], boolean][]} */
  const kinds = [
    ['quads', trianglesOnly.includes(format) && isQuads],
    ['parts', format !== 'obj' && primitives.length > 1],
    ['looks', hasLooks(tree)],
    ['scene', hasScene(tree)],
  ];
  return kinds.filter(([, isLost]) => isLost)
    .map(([kind]) => ({ kind, count: primitives.length }));
}
