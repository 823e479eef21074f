// SPDX-License-Identifier: MIT
// Presets: options for common purposes. Their names are preset.ID in the texts.

/** @typedef {import('./address.js').Values} Values */
/** values: replace all options except the visitor's own target and texture options. share, if any:
 * replaces the target by a share of the input's vertices. paints: textured models get new textures.
 * @typedef {{ id: 'even' | 'accurate' | 'lowPoly' | 'quads' | 'print' | 'simulation',
 *   values: Values, share?: number, paints?: boolean }} Preset */

/** @type {Preset[]} */
export const presets = [
  { id: 'even', values: { adaptivity: 0 } },
  { id: 'accurate', values: { adaptivity: 1 } },
  { id: 'lowPoly', values: { prefer: 'shape' }, share: 0.1, paints: true },
  { id: 'quads', values: { quads: true } },
  { id: 'print', values: { adaptivity: 0.7, maxError: 0.2, repair: 'auto' } },
  { id: 'simulation',
    values: { adaptivity: 0.3, gradation: 1.3, featureAngle: 30, repair: 'auto' } },
];

const targets = ['vertices', 'ratio', 'edgeLength'];
const ofTextures = ['textures', 'textureSize', 'textureFormat'];

/** @param {Values} values @param {string[]} names @returns {Values} */
const only = (values, names) =>
  Object.fromEntries(Object.entries(values).filter(([name]) => names.includes(name)));

/** Whether the options are those of a preset that replaces the target. @param {Values} values
 * @returns {(preset: Preset) => boolean} */
const isSetIn = (values) => ({ values: own, share }) => share !== undefined
  && share === values.ratio && Object.entries(own).every(([name, value]) => values[name] === value);

/** The target and the texture options that the visitor chose: those of a preset do not count, so
 * that the next preset does not keep them.
 * @param {Values} values the present options @param {Values} before the choices before
 * @returns {Values} */
export function ownChoices(values, before) {
  const preset = presets.find(isSetIn(values));
  const isPainted = preset?.paints && values.textures === 'bake';
  return { ...only(preset ? before : values, targets),
    ...only(isPainted ? before : values, ofTextures) };
}

/** The options after a preset is applied: all others have their defaults.
 * @param {Preset} preset @param {Values} own the visitor's own target and texture options
 * @param {boolean} isTextured whether the model has textures @returns {Values} */
export function withPreset({ values, share, paints }, own, isTextured) {
  return { ...(share ? { ratio: share } : only(own, targets)), ...only(own, ofTextures),
    ...(paints && isTextured ? { textures: 'bake' } : {}), ...values };
}
