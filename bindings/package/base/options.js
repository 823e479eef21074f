// SPDX-License-Identifier: MIT
// THE table of options. The command line's flags and help, the checks, the page's form, the type
// RemeshOptions and the reference are all made from its rows. Angles in degrees, lengths in model
// units, errors in percent of the bounding-box diagonal. A default that depends on the scheme is
// written { best, rounds }; no default means "not set". Rows without a flag exist in JavaScript
// only.

import { RemeshError } from './errors.js';
import { legible } from './legible.js';
import { repairNames } from './option_lists.js';
import { units } from './lengths.js';
import { nearest } from './nearest.js';
import { OptionRules } from './option_rules.js';
import { canonical, checkValue, inWords, isLength } from './option_values.js';
import { presets, withPreset } from './presets.js';

export { belonging, presets } from './presets.js';
export {
  bakeNames, convertNames, repairNames, targetNames, unwrapNames,
} from './option_lists.js';
export { checkValue, rangeInWords } from './option_values.js';
export { isWorthBaking } from './worth_baking.js';

/** @typedef {import('./presets.js').Preset} Preset */
/** @typedef {import('./remesh_options.js').RemeshOptions} RemeshOptions */

/** @typedef {string | number | boolean} DefaultValue */

/**
 * A row of the table.
 * @typedef {object} Option
 * @property {string} name Its name in JavaScript.
 * @property {string} [flag] Its name on the command line, with a letter for its value.
 * @property {string} [alias] Another name on the command line.
 * @property {'integer' | 'number' | 'choice' | 'boolean' | 'shares' | 'floats' | 'pairs' |
 *   'indices' | 'guides'} type
 *   The type of its value.
 * @property {string} help Its purpose.
 * @property {string} [unit] The unit of its value.
 * @property {number} [min] The smallest value allowed.
 * @property {number} [max] The largest value allowed.
 * @property {number} [above] Allowed values are larger than this.
 * @property {readonly string[]} [choices] The values allowed.
 * @property {'off' | 'auto'} [word] A value too, beside numbers.
 * @property {boolean} [form] false: the page's form has no field for it.
 * @property {readonly import('./option_rules.js').Others[]} [needs] Without any of these it has no
 *   effect.
 * @property {import('./option_rules.js').Excludes} [excludes] It cannot be given together with
 *   these.
 * @property {DefaultValue | { best: DefaultValue, rounds: DefaultValue }} [default] The value that
 *   holds when it is not given.
 */

/** What limits of every edge and triangle exclude. */
const ofIsotropic = { others: { quads: /** @type {const} */ ([true]),
  scheme: /** @type {const} */ (['rounds']), prefer: /** @type {const} */ (['shape']),
  splitObtuse: /** @type {const} */ ([true]), lods: /** @type {const} */ (true) },
why: 'the limits are of isotropic triangles of one level, of the scheme best' };

/** The table of options. @type {readonly Option[]} */
export const optionTable = [
  { name: 'preset', flag: '--preset P', type: 'choice', choices: presets.map(({ name }) => name),
    form: false,
    help: 'options for a purpose; what is given beside it overrides. '
      + presets.map(({ name, help }) => `${name}: ${help}`).join('; ') },
  { name: 'vertices', flag: '--vertices N', type: 'integer', min: 1, max: 2 ** 31,
    excludes: { others: { faces: true, ratio: true, edgeLength: true },
      why: 'each sets the number' },
    help: 'exact number of vertices of the result (distinct positions), of quads within 4 %; if '
      + 'not given the input’s, in the scheme best up to four times as many where isotropic '
      + 'triangles within 0.05 % of the diagonal need them, or as few as keep --max-error' },
  { name: 'faces', flag: '--faces N', alias: '--triangles', type: 'integer', min: 1, max: 2 ** 31,
    excludes: { others: { ratio: true, edgeLength: true }, why: 'each sets the number' },
    help: 'at most so many triangles, or quads with --quads, as near as the surface allows; with '
      + '--prefer shape no more than the input has' },
  { name: 'ratio', flag: '--ratio R', type: 'number', above: 0,
    excludes: { others: { edgeLength: true }, why: 'each sets the number' },
    help: 'the number of vertices as a share of the input’s' },
  { name: 'edgeLength', flag: '--edge-length L', type: 'number', above: 0, unit: 'model units',
    help: 'the number of vertices from a mean edge length; with --min-angle each edge is to have '
      + '0.4 to 2 times that length, unless limits of edges or --max-error are given' },
  { name: 'minEdge', flag: '--min-edge L', type: 'number', above: 0, unit: 'model units',
    excludes: ofIsotropic,
    help: 'no edge is to be shorter; where that cannot be the report says how many are, and where. '
      + 'Without a number of vertices no more are made than it allows' },
  { name: 'maxEdge', flag: '--max-edge L', type: 'number', above: 0, unit: 'model units',
    excludes: ofIsotropic,
    help: 'no edge is to be longer, as above. Without a number of vertices as few as it allows' },
  { name: 'minAngle', flag: '--min-angle D', type: 'number', above: 0, max: 60, unit: 'degrees',
    excludes: ofIsotropic,
    help: 'no angle of a triangle is to be smaller, as above; without a number of vertices or '
      + 'lengths of edges there may be more vertices than the input has' },
  { name: 'units', flag: '--units U', type: 'choice', choices: units, form: false,
    help: 'of the model’s lengths, so that options can be lengths with a unit, like 0.1mm; if not '
      + 'given those of the file: metres of glTF, what a 3MF says, none of others' },
  { name: 'scheme', flag: '--scheme S', type: 'choice', choices: ['best', 'rounds'],
    default: 'best', help: 'rounds: the published method step by step; best: our own' },
  { name: 'quality', flag: '--quality Q', type: 'choice', choices: ['draft', 'best'],
    default: 'best',
    help: 'draft: in a fraction of the time, nearly as good, its distances measured coarsely' },
  { name: 'prefer', flag: '--prefer P', type: 'choice', choices: ['auto', 'even', 'shape'],
    default: 'auto',
    excludes: { value: 'shape',
      others: { scheme: ['rounds'], boundary: ['keep'], quads: [true], splitObtuse: [true],
        density: true, featureEdges: true },
      why: 'both decide where vertices lie' },
    help: 'even: isotropic triangles; shape: simplification, which keeps the vertices that shape '
      + 'and appearance need most; auto: even, unless that would visibly change the model' },
  { name: 'projection', flag: '--projection P', type: 'choice', choices: ['patches', 'current'],
    default: 'patches',
    help: 'patches: onto the original surface, through overlapping disk patches or, with best ' +
      'from 8000 vertices on, by walking to the nearest point; current: on the current mesh' },
  { name: 'fidelity', flag: '--fidelity F', type: 'choice', choices: ['strict', 'loose', 'fold'],
    default: { best: 'fold', rounds: 'loose' },
    help: 'refuse an operation unless every pair of normals is within the angles below (strict), ' +
      'unless at least one is (loose), or only where a triangle would fold over (fold)' },
  { name: 'vertexAngle', flag: '--vertex-angle D', type: 'number', min: 0, max: 180,
    unit: 'degrees', default: 20, help: 'between the normals at a triangle’s vertices' },
  { name: 'triangleAngle', flag: '--triangle-angle D', type: 'number', min: 0, max: 180,
    unit: 'degrees', default: 20,
    help: 'between a triangle’s normal and those at its vertices' },
  { name: 'splitObtuse', flag: '--split-obtuse', type: 'boolean', default: false,
    help: 'after the target is met, split every edge facing an obtuse angle, once' },
  { name: 'adaptivity', flag: '--adaptivity A', type: 'number', min: 0, max: 1,
    default: { best: 0.5, rounds: 0 },
    help: '0: triangles of one size; 1: sizes follow curvature, for the least error; between: a '
      + 'mix' },
  { name: 'gradation', flag: '--gradation G', type: 'number', above: 1, default: 1.5,
    help: 'largest ratio between the sizes at the two ends of an edge' },
  { name: 'featureAngle', flag: '--feature-angle D', type: 'number', min: 0, max: 180,
    unit: 'degrees', word: 'off', default: { best: 40, rounds: 'off' },
    help: 'dihedral angle from which an edge can belong to a feature curve, which survives' },
  { name: 'boundary', flag: '--boundary B', type: 'choice', choices: ['resample', 'keep'],
    default: 'resample', help: 'move vertices along open boundaries, or keep them exactly' },
  { name: 'maxError', flag: '--max-error P', type: 'number', above: 0,
    unit: '% of the diagonal', word: 'off', default: 'off',
    help: 'the largest distance allowed between original and result, both ways' },
  { name: 'weld', flag: '--weld P', type: 'number', above: 0, unit: '% of the diagonal',
    help: 'join vertices of open edges that are nearer to each other; only places that are equal '
      + 'but for rounding if not given' },
  { name: 'quads', flag: '--quads', type: 'boolean', default: false,
    help: 'pure quads instead of triangles, along features and curvature; the number of vertices '
      + 'within 1 %, or within 4 % where a nearer one costs irregular vertices' },
  { name: 'exact', flag: '--exact', type: 'boolean', default: false, needs: [{ quads: [true] }],
    help: 'of quads: exactly the number of vertices' },
  { name: 'symmetry', flag: '--symmetry S', type: 'choice',
    choices: ['auto', 'off', 'x', 'y', 'z', 'xy', 'xz', 'yz', 'xyz'], default: 'auto',
    needs: [{ quads: [true] }],
    help: 'of quads; auto: where planes mirror the model they mirror the quads exactly; x, xy …: '
      + 'planes at right angles to these axes mirror the quads, whatever the model is' },
  { name: 'guides', flag: '--guides FILE', type: 'guides', form: false, needs: [{ quads: [true] }],
    help: 'lines on or near the model, for quads to follow, in an .obj, .gltf or .glb: closed ones '
      + 'become sides of quads, others, and those named direction, lead the quads beside them' },
  { name: 'textures', flag: '--textures T', type: 'choice',
    choices: ['auto', 'keep', 'drop', 'bake'], default: 'auto',
    help: 'keep: texture coordinates, along their seams; drop: leave them out; bake (to glTF): '
      + 'new textures, painted '
      + 'from the old, so that seams hold no vertices; auto: keep, but bake from glTF to glTF '
      + 'where repair makes another surface' },
  { name: 'textureSize', flag: '--texture-size N', type: 'integer', min: 1, max: 8192,
    unit: 'texels',
    needs: [{ textures: ['bake'] }, { textures: ['auto'], repair: ['auto', 'solid', 'wrap'] }],
    help: 'of baked textures, along a side; as fine as the original’s if not given, up to 4096' },
  { name: 'textureFormat', flag: '--texture-format F', type: 'choice',
    choices: ['png', 'jpeg', 'webp'],
    needs: [{ textures: ['bake'] }, { textures: ['auto'], repair: ['auto', 'solid', 'wrap'] }],
    help: 'of baked textures; if not given the one that images came in: webp if all were '
      + 'WebP, else jpeg, but png for alpha, and for normals that were no JPEG; jpeg leaves alpha '
      + 'to png' },
  { name: 'cage', flag: '--cage P', type: 'number', above: 0, max: 50,
    unit: '% of the diagonal', form: false,
    needs: [{ textures: ['bake'] }],
    help: 'how far from the result baking looks for the original; for remesher bake 1.5 times the '
      + 'largest distance found, at most 5, if not given' },
  { name: 'ao', flag: '--ao', type: 'boolean', default: false, form: false,
    needs: [{ textures: ['bake'] }],
    help: 'bake ambient occlusion of the original, too' },
  { name: 'repair', flag: '--repair R', type: 'choice',
    choices: ['off', 'holes', 'solid', 'wrap', 'auto'], default: 'off',
    excludes: { others: { density: true, featureEdges: true },
      why: 'repair makes other vertices than those that are numbered' },
    help: 'repair the surface first. holes: close open loops, turn bodies that are inside out, '
      + 'leave the rest as it is; solid: the outside of what encloses something; wrap: what is '
      + 'reached from outside through openings wider than the gap; auto: the first of these that '
      + 'fits' },
  { name: 'holesUpTo', flag: '--holes-up-to P', type: 'number', above: 0,
    unit: '% of the diagonal',
    needs: [{ repair: ['holes', 'auto'] }],
    help: 'longer loops stay open; all are closed if not given' },
  { name: 'gap', flag: '--gap P', type: 'number', above: 0, max: 20,
    unit: '% of the diagonal',
    needs: [{ repair: ['wrap', 'auto'] }],
    help: 'wrap closes openings up to this wide; 2 if not given' },
  { name: 'cavities', flag: '--cavities', type: 'boolean', default: false,
    needs: [{ repair: ['solid', 'auto'] }],
    help: 'solid keeps inner cavities: closed pieces that face into what they enclose' },
  { name: 'sheets', flag: '--sheets S', type: 'choice', choices: ['thicken', 'drop'],
    default: 'thicken',
    needs: [{ repair: ['wrap', 'solid', 'auto'] }],
    help: 'of sheets, which enclose nothing, wrap makes thin solids behind what is seen of them, '
      + 'or leaves them out' },
  { name: 'keepRims', flag: '--keep-rims', type: 'boolean', default: false,
    needs: [{ repair: ['holes', 'auto'] }],
    help: 'openings that look intended stay open: round ones, and straight ones at which walls '
      + 'end; with holes small open pieces stay, too' },
  { name: 'thickness', flag: '--thickness T', type: 'number', above: 0, unit: 'model units',
    needs: [{ repair: ['auto'] }],
    help: 'sheets become bodies that are so thick, half of it on each side' },
  { name: 'base', flag: '--base', type: 'boolean', default: false,
    needs: [{ repair: ['auto'] }],
    help: 'an open relief, such as a terrain, becomes a body with upright walls and a flat base, '
      + 'which lies --thickness below its lowest point' },
  { name: 'unite', flag: '--unite', type: 'boolean', default: false,
    help: 'the meshes of a file become one surface, with their materials' },
  { name: 'dropBelow', flag: '--drop-below P', type: 'number', above: 0, word: 'auto',
    unit: '% of the diagonal',
    help: 'leave out smaller pieces; auto: floaters, which are small and away from the rest' },
  { name: 'dropHidden', flag: '--drop-hidden', type: 'boolean', default: false,
    help: 'leave out triangles that nobody sees from outside; all others stay as they are' },
  { name: 'conform', flag: '--conform', type: 'boolean', default: false,
    excludes: { others: { repair: ['holes', 'solid', 'wrap', 'auto'], quads: [true],
      prefer: ['shape'], scheme: ['rounds'], splitObtuse: [true], boundary: ['keep'],
      textures: ['keep', 'bake'], unite: [true], lods: true, dropHidden: [true], density: true,
      featureEdges: true, region: true },
    why: 'closed bodies are remeshed together, as isotropic triangles of one level without '
      + 'textures' },
    help: 'closed bodies that touch face to face share the triangles of their common face, so that '
      + 'a solver can join them there; bodies are the connected pieces of all meshes. The number '
      + 'of vertices counts those of a common face once' },
  { name: 'lods', flag: '--lods R,R,…', type: 'shares', form: false,
    help: 'coarser levels of detail beside the result, by their shares of its vertices, or by what '
      + 'is seen of them: 1px,2px,4px are off by no more than so many pixels where the model is '
      + '1080 high; each from the original, or with baked textures from the result, whose maps '
      + 'they share; in a glTF file by MSFT_lod' },
  { name: 'lodFiles', flag: '--lod-files', type: 'boolean', default: false, form: false,
    needs: [{ lods: true }],
    help: 'a file for each level of detail, called after the result, not one for all' },
  { name: 'slabs', flag: '--slabs N', type: 'integer', min: 1, max: 256, form: false,
    help: 'thin out a scan in so many slabs; if not given those above 4 million triangles in one '
      + 'for each 4 million begun' },
  { name: 'slab', flag: '--slab K', type: 'integer', min: 1, max: 256, form: false,
    needs: [{ slabs: true }],
    help: 'only thin out this slab of a file, from 1 on, to PLY: pieces for jobs on several '
      + 'machines, which together become what --slabs alone makes' },
  { name: 'compress', flag: '--compress C', type: 'choice', choices: ['auto', 'meshopt', 'draco'],
    form: false,
    help: 'of glTF that is written: meshopt decodes fast and keeps the order of all triangles; '
      + 'draco is smaller; either moves positions by no more than a thousandth of a percent of '
      + 'the diagonal; auto: as the glTF came' },
  { name: 'density', type: 'floats',
    help: 'relative vertex density, one value per input vertex' },
  { name: 'featureEdges', type: 'pairs',
    help: 'feature edges of the caller’s own, as pairs of input vertices' },
  { name: 'region', type: 'indices',
    excludes: { others: { quads: [true], repair: ['holes', 'solid', 'wrap', 'auto'], weld: true,
      textures: ['bake'], lods: true, dropBelow: true, dropHidden: [true], unite: [true] },
    why: 'outside the region everything stays bit for bit' },
    help: 'numbers of the input’s triangles that are to be remeshed; the others stay bit for bit, '
      + 'and so does the border between. The number of vertices is that of the whole' },
];

/** @type {Map<string, Option>} */
const byName = new Map(optionTable.map((option) => [option.name, option]));

/**
 * The value that holds when the option is not given; undefined: none does.
 * @param {Option} option
 * @param {'best' | 'rounds'} scheme
 * @returns {DefaultValue | undefined}
 */
export function defaultOf(option, scheme) {
  return typeof option.default === 'object' ? option.default[scheme] : option.default;
}

/**
 * The value that holds when the option is not given, in words; empty: none does.
 * @param {Option} option
 * @param {(value: DefaultValue | undefined) => string} spell
 */
export function defaultInWords(option, spell = String) {
  const [best, rounds] = [defaultOf(option, 'best'), defaultOf(option, 'rounds')];
  if (best === undefined) return '';
  return best === rounds ? spell(best) : `${spell(best)}; ${spell(rounds)} with rounds`;
}

/** The word after a flag in our sentences: a value of the option, or other words.
 * @param {Option} option @param {string} word */
function isValueOf(option, word) {
  if (option.choices) return option.choices.includes(word);
  const isNumber = option.type === 'integer' || option.type === 'number';
  return isNumber && word !== '' && (Number.isFinite(Number(word)) || isLength(option, word));
}

/**
 * A sentence for programs: our sentences name options as the command line does, `--sheets drop`;
 * this makes it `sheets: 'drop'`.
 * @param {string} text
 */
export function inJavaScript(text) {
  const named = /(?<=^|[\s(])(--[a-z][a-z-]*)(?: ([\w.+-]*\w))?/g;
  return text.replace(named, (whole, flag, word = '') => {
    const option = optionTable.find((one) => one.flag?.split(' ')[0] === flag);
    if (!option) return whole;
    const rest = word === '' ? '' : ` ${word}`;
    if (!isValueOf(option, word)) return option.name + rest;
    return `${option.name}: ${option.choices || isLength(option, word) ? `'${word}'` : word}`;
  });
}

/** How programs know an option. @param {Option} option @returns {string} */
const nameOf = ({ name }) => name;

/** Which options go together. */
export const optionRules = new OptionRules(optionTable);

/**
 * The options of a repair, checked as checkOptions does; no others belong there.
 * @param {object} given
 * @param {readonly string[]} others names that belong to the call, not to the table
 * @returns {Record<string, unknown>}
 */
export function checkRepair(given, others) {
  requireObject(given);
  const checked = checkOptions({ repair: 'auto', ...given }, { others });
  const foreign = Object.keys(checked).find((name) =>
    !repairNames.some((own) => own === name));
  if (foreign) {
    throw new RemeshError('INVALID_OPTION', `Repair alone does not remesh: ${foreign} does not `
      + 'belong there.', `There are ${repairNames.join(', ')}.`);
  }
  return checked;
}

/**
 * The options of a function that takes a few of the table, checked one by one.
 * @param {object} given
 * @param {object} context
 * @param {readonly string[]} context.names those that it takes
 * @param {readonly string[]} context.others names that belong to the call, not to the table
 * @param {string} context.what the function, in a word
 * @param {(option: Option) => string} [context.label] how the caller knows an option
 * @returns {Record<string, unknown>}
 */
export function checkOwn(given, { names, others, what, label = nameOf }) {
  requireObject(given);
  /** @type {Record<string, unknown>} */
  const result = {};
  for (const [name, value] of Object.entries(given)) {
    if (value === undefined || others.includes(name)) continue;
    const option = byName.get(name);
    if (!option) throw unknownOption(name, [...names, ...others]);
    if (!names.includes(name)) {
      const all = names.flatMap((one) => byName.get(one) ?? []).map(label);
      throw new RemeshError('INVALID_OPTION',
        `${what} does not remesh: ${label(option)} does not belong there.`,
        `There ${all.length > 1 ? 'are' : 'is'} ${all.join(', ')}.`);
    }
    checkValue(option, value, label(option));
    result[name] = value;
  }
  return result;
}

/** @param {string} name @param {readonly string[]} known */
function unknownOption(name, known) {
  const meant = nearest(name, known);
  return new RemeshError('UNKNOWN_OPTION', `There is no option ${legible(name)}.`,
    meant ? `Did you mean ${meant}?` : '');
}

/** @param {unknown} given what a function was given as its options */
export function requireObject(given) {
  if (typeof given === 'object' && given !== null && !Array.isArray(given)) return;
  throw new RemeshError('INVALID_OPTION', `The options must be an object, not ${inWords(given)}.`,
    'Write them like { vertices: 10000 }.');
}

/**
 * Refuses levels of detail where a single result is made in place. @param {object} [options]
 */
export function refuseLods(options = {}) {
  const name = ['lods', 'lodFiles'].find((option) => Object.hasOwn(options, option));
  if (name === undefined) return;
  throw new RemeshError('INVALID_OPTION', `${name} does not belong here: there is one result.`,
    'Ask for each level on its own, or give the file to remeshFile.');
}

/**
 * The options given, checked and ready to travel; unset ones are left out. Of a preset they have
 * all options that it stands for here, and these once more as `preset`.
 * @param {object} given
 * @param {object} [context]
 * @param {readonly string[]} [context.others] names that belong to the call, not to the table
 * @param {(option: Option) => string} [context.label] how the caller knows an option
 * @returns {Record<string, unknown>}
 */
export function checkOptions(given, { others = [], label = nameOf } = {}) {
  requireObject(given);
  /** @type {Record<string, unknown>} */
  const result = {};
  for (const [name, value] of Object.entries(given)) {
    if (value === undefined || others.includes(name)) continue;
    const option = byName.get(name);
    if (!option) throw unknownOption(name, [...byName.keys(), ...others]);
    checkValue(option, value, label(option));
    result[name] = canonical(option, value);
  }
  const check = (/** @type {Record<string, unknown>} */ options) =>
    optionRules.check(options, label);
  const whole = withPreset(result, check);
  check(whole);
  if (whole.maxError === 'off') delete whole.maxError;
  return whole;
}
