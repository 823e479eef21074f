// SPDX-License-Identifier: MIT
// Presets: options for common purposes. Their names are preset.ID in the texts.

/** @typedef {import('./address.js').Values} Values */
/** values: replace all options except the target and the texture options; `share`, if any: replaces
 * the target by a share of the input's vertices; `paints`: textured models get new textures.
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

/** The options after a preset is applied. @param {Preset} preset @param {Values} values
 * @param {boolean} isTextured whether the model has textures @returns {Values} */
export function withPreset({ values: own, share, paints }, values, isTextured) {
  const { vertices, ratio, edgeLength, textureSize, textureFormat } = values;
  const textures = paints && isTextured ? 'bake' : values.textures;
  const target = share ? { ratio: share } : { vertices, ratio, edgeLength };
  const kept = Object.entries({ ...target, textures, textureSize, textureFormat })
    .filter(([, value]) => value !== undefined);
  return { ...Object.fromEntries(kept), ...own };
}
