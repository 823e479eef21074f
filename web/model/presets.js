// SPDX-License-Identifier: MIT
// Presets among the options: kinds of triangles. Their names are preset.ID in the texts. Purposes,
// which have a number of their own, are in purposes.js.

import { presets as table, targetNames } from 'remesher/options';

/** @typedef {import('./address.js').Values} Values */

/** values: replace all options except the visitor's own target and texture options.
 * @typedef {{ id: 'even' | 'accurate', values: Values }} Preset */

/** @type {Preset[]} */
export const presets = [
  { id: 'even', values: { adaptivity: 0 } },
  { id: 'accurate', values: { ...table.find(({ name }) => name === 'accurate')?.values } },
];

/** The options of textures. */
export const ofTextures = ['textures', 'textureSize', 'textureFormat'];

/** @param {Values} values @param {string[]} names @returns {Values} */
const only = (values, names) =>
  Object.fromEntries(Object.entries(values).filter(([name]) => names.includes(name)));

/** The target and the texture options that the visitor chose: those of a purpose do not count, so
 * that the next preset does not keep them.
 * @param {Values} values the present options @param {Values} before the choices before
 * @returns {Values} */
export function ownChoices(values, before) {
  return values.purpose ? before : only(values, [...targetNames, ...ofTextures]);
}

/** The options after a preset is applied: all others have their defaults.
 * @param {Preset} preset @param {Values} own the visitor's own target and texture options
 * @returns {Values} */
export const withPreset = ({ values }, own) => ({ ...only(own, [...targetNames, ...ofTextures]),
  ...values });
