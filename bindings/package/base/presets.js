// SPDX-License-Identifier: MIT
// The only table of presets: options for a purpose, for the command line, JavaScript and the page.
// No preset sets a number of vertices or faces, or an edge length: that is the caller's.

/** @typedef {'asset' | 'print' | 'simulation' | 'quads' | 'accurate'} PresetName */

/**
 * A row of the table.
 * @typedef {object} Preset
 * @property {PresetName} name What `preset` is set to.
 * @property {string} help Its purpose.
 * @property {Readonly<Record<string, string | number | boolean>>} values The options that it stands
 *   for, by their names.
 */

/** The table of presets. @type {readonly Preset[]} */
export const presets = [
  { name: 'asset', help: 'a generated or scanned model for a scene, a game or AR: without '
    + 'floaters, small holes closed, vertices where shape and looks need them, new '
    + 'textures in one set or its own as WebP, compressed if the input was',
  values: { repair: 'holes', holesUpTo: 3, keepRims: true, dropBelow: 'auto', prefer: 'shape',
    textures: 'bake', textureFormat: 'webp', compress: 'auto' } },
  { name: 'print', help: 'a closed body for printing, within 0.2 % of the diagonal',
    values: { adaptivity: 0.7, maxError: 0.2, repair: 'auto' } },
  { name: 'simulation', help: 'a closed surface of triangles whose sizes change slowly, without '
    + 'angles below 20 degrees',
  values: { adaptivity: 0.3, gradation: 1.3, featureAngle: 30, minAngle: 20, repair: 'auto' } },
  { name: 'quads', help: 'pure quads', values: { quads: true } },
  { name: 'accurate', help: 'isotropic triangles that follow curvature, for the least error',
    values: { adaptivity: 1 } },
];

/**
 * Options that a preset drops together with the one they depend on.
 * @type {Readonly<Record<string, readonly string[]>>}
 */
export const belonging = {
  textures: ['textureSize', 'textureFormat'], repair: ['holesUpTo', 'keepRims'] };

/** @typedef {Record<string, unknown>} Options */

/** @param {() => void} check */
function passes(check) {
  try {
    check();
    return true;
  } catch {
    return false;
  }
}

/**
 * The options with those of their preset added. What is given overrides the preset: the same
 * option, and one that contradicts it.
 * @param {Options} given
 * @param {(options: Options) => void} [check] throws for options that contradict each other
 * @returns {Options} the options; `preset` holds those that the preset stands for here
 */
export function withPreset(given, check = () => {}) {
  const { preset: asked, ...options } = given;
  const preset = presets.find(({ name }) => name === asked);
  if (!preset) return given;
  const isOverridden = (/** @type {string} */ option) => options[option] !== undefined
    && options[option] !== preset.values[option];
  const isFree = (/** @type {string} */ option) => options[option] === undefined
    && !Object.keys(belonging).some((owner) => belonging[owner].includes(option)
      && isOverridden(owner));
  const all = Object.entries(preset.values).filter(([option]) => isFree(option));
  const whole = (/** @type {typeof all} */ values) =>
    ({ ...options, ...Object.fromEntries(values) });
  const without = (/** @type {string} */ name) => all.filter(([option]) => option !== name
    && !belonging[name]?.includes(option));
  const fits = (/** @type {typeof all} */ values) => passes(() => check(whole(values)));
  const contradicting = fits(all) ? undefined : all.find(([option]) => fits(without(option)));
  const added = contradicting ? without(contradicting[0]) : all;
  return { ...whole(added), preset: Object.fromEntries(added) };
}

/**
 * The options without some that their preset stands for.
 * @param {Options} options as withPreset makes them
 * @param {readonly string[]} names
 * @returns {Options}
 */
function withoutOfPreset(options, names) {
  const preset = /** @type {Options} */ (options.preset ?? {});
  const left = (/** @type {Options} */ all) => Object.fromEntries(Object.entries(all)
    .filter(([name]) => !(names.includes(name) && name in preset)));
  return { ...left(options), preset: left(preset) };
}

/**
 * The options without the baking that their preset stands for, where nothing can be baked.
 * @param {Options} options as withPreset makes them
 * @returns {Options}
 */
export function withoutPresetBaking(options) {
  const { preset } = /** @type {{ preset?: Options }} */ (options);
  if (preset?.textures !== 'bake') return options;
  return withoutOfPreset(options, ['textures', ...belonging.textures]);
}

/**
 * The options without the compression that their preset stands for, where no file came compressed
 * or none is written that can be.
 * @param {Options} options as withPreset makes them
 * @returns {Options}
 */
export function withoutPresetCompression(options) {
  return withoutOfPreset(options, ['compress']);
}
