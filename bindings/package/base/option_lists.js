// SPDX-License-Identifier: MIT
// Names of the options in groups: those that exclude each other, and those of single functions.

/** The names of the options that set the size of the result, of which one is given at most. */
export const targetNames = /** @type {const} */ ([
  'vertices', 'faces', 'ratio', 'edgeLength',
]);

/** The names of the options for repair. */
export const repairNames =
  /** @type {const} */ (['repair', 'holesUpTo', 'gap', 'cavities', 'sheets', 'keepRims',
    'thickness', 'base', 'unite', 'dropBelow', 'dropHidden', 'textures', 'textureSize',
    'textureFormat', 'weld', 'units', 'compress']);

/** @typedef {typeof repairNames[number]} RepairName */

/** The names of the options for converting: how to compress, and the unit that a 3MF states. */
export const convertNames = /** @type {const} */ ([
  'compress', 'units']);

/** The names of the options for baking onto a mesh. */
export const bakeNames = /** @type {const} */ ([
  'textureSize', 'textureFormat', 'cage', 'ao']);

/** @typedef {typeof bakeNames[number]} BakeName */

/** The names of the options for unwrapping. */
export const unwrapNames = /** @type {const} */ ([
  'textureSize']);
