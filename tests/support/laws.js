// SPDX-License-Identifier: MIT
// Laws that hold for every run on any input: laws of its error, its report, its mesh and its files.
// Each function returns the broken laws in words.

import { convertFile } from 'remesher';

import { errorCodes } from '../../dist/base/errors.js';
import { issuesOf, openGltf, valuesOf } from './gltf.js';

/** Repairs that may change the numbers of components, holes and handles. */
const repairs = new Set(['BACK_TO_BACK_TRIANGLES_REMOVED', 'DEGENERATE_TRIANGLES_REMOVED',
  'DUPLICATE_TRIANGLES_REMOVED', 'INCONSISTENT_ORIENTATION_FIXED', 'NON_MANIFOLD_EDGES_SPLIT',
  'NON_MANIFOLD_VERTICES_SPLIT', 'NON_ORIENTABLE_CUT', 'VERTICES_COINCIDE']);

/** Whether an input has triangles of no area, or nearly none: angles in degrees. */
const isThin = (/** @type {any} */ { degenerateTriangles, minAngle }) =>
  degenerateTriangles > 0 || minAngle.worst < 0.1;

/** An error must be the caller's fault, said in a sentence. @param {any} error */
export function lawsOfErrors(error) {
  const { code, message } = error;
  if (!errorCodes.includes(code)) return [`not a RemeshError: ${error.stack}`];
  if (code === 'INTERNAL' || code === 'CANCELLED') return [`${code}: ${message}`];
  return /\.$/.test(message) ? [] : [`not a sentence: ${message}`];
}

/** Whether a number is met as the options ask. @param {number} count @param {any} options */
const isMet = (count, { vertices = count, quads, exact, splitObtuse }) => splitObtuse
  || (quads && !exact ? Math.abs(count - vertices) < 0.010001 * vertices : count === vertices);

/** @param {any} report @param {Record<string, any>} options of the run */
export function lawsOfReports(report, options) {
  const { input, output, fidelity, stopped, warnings } = report;
  const broken = [];
  const require = (/** @type {boolean} */ holds, /** @type {string} */ law) => {
    if (!holds) broken.push(law);
  };
  require(stopped !== 'target' || isMet(output.vertices, options) || warnings.length > 0,
  `${output.vertices} vertices instead of ${options.vertices}, and no reason`);
  const says = (/** @type {string} */ code) => warnings.some((/** @type {any} */ warning) =>
    warning.code === code && /near \(/.test(warning.message));
  const isRepaired = warnings.some((/** @type {any} */ { code }) => repairs.has(code));
  // The written numbers can be less exact than those read: single precision far from the origin.
  const isRounded = warnings.some((/** @type {any} */ { code }) => code === 'VERTICES_COINCIDE')
    || says('SHAPE_LOST_TO_ROUNDING');
  // A sound surface stays sound. An unsound surface may become worse if a warning names the place.
  require(output.degenerateTriangles <= input.degenerateTriangles
    || ((isThin(input) || isRounded || (options.quads && isRepaired))
      && says('DEGENERATE_TRIANGLES_MADE')),
  `${output.degenerateTriangles} degenerate triangles, of ${input.degenerateTriangles}`);
  // Only vertices of triangles are moved apart where a surface is too thin for its numbers.
  const mayMeet = isRepaired || (options.quads && isThin(input));
  require(output.nonManifoldEdges <= input.nonManifoldEdges
    || (mayMeet && says('NON_MANIFOLD_EDGES_MADE')),
  `${output.nonManifoldEdges} non-manifold edges, of ${input.nonManifoldEdges}`);
  if (input.nonManifoldEdges === 0 && input.boundaryEdges === 0) {
    require(output.boundaryEdges === 0 || (isRepaired && says('SURFACE_OPENED')),
      `closed before, ${output.boundaryEdges} edges open now`);
  }
  if (!isRepaired) {
    for (const name of ['components', 'eulerCharacteristic']) {
      require(output[name] === input[name], `${name} ${output[name]}, was ${input[name]}`);
    }
  }
  // The result consists of points on the surface, or close to it.
  require(fidelity === undefined || fidelity.hausdorff <= 100 || says('SHAPE_LOST_TO_ROUNDING'),
    `${fidelity?.hausdorff} % of the diagonal away`);
  if (options.maxError !== undefined && fidelity !== undefined) {
    const isSaid = warnings.some((/** @type {any} */ { code }) => code === 'MAX_ERROR_EXCEEDED');
    require(fidelity.hausdorff <= options.maxError * (1 + 1e-6) || isSaid,
      `${fidelity.hausdorff} % away, not ${options.maxError} % at most`);
  }
  return broken;
}

const areFinite = (/** @type {any} */ values) => values.every(Number.isFinite);

/** Largest deviation from unit length: a step of the smallest integers. */
const unitTolerance = 0.02;

/** The laws of one attribute; `rows` has an array of values per vertex. */
function lawsOfAttribute(semantic, rows) {
  if (!rows.every(areFinite)) return [`${semantic} is not finite`];
  const isUnit = (/** @type {number[]} */ row) =>
    Math.abs(Math.hypot(...row.slice(0, 3)) - 1) < unitTolerance;
  if (/^(NORMAL|TANGENT)$/.test(semantic) && !rows.every(isUnit)) {
    return [`${semantic} is not of unit length`];
  }
  return [];
}

/** The values as rows of `width`. */
function rowsOf(values, width) {
  return Array.from({ length: values.length / width },
    (_, i) => Array.from(values.subarray(width * i, width * (i + 1))));
}

/** The laws of a mesh as arrays. */
export function lawsOfMeshes({ positions, indices, attributes = {} }) {
  const broken = [];
  const count = positions.length / 3;
  if (!areFinite(positions)) broken.push('a coordinate is not finite');
  if (!indices.every((/** @type {number} */ v) => v < count)) broken.push('an index is too large');
  for (const [semantic, { array, itemSize }] of Object.entries(attributes)) {
    broken.push(...lawsOfAttribute(semantic, rowsOf(array, itemSize)));
  }
  return broken;
}

/**
 * The laws of quads, if the mesh has them: four places each, three or more at each inner vertex,
 * and two triangles for each.
 */
export function lawsOfQuads({ positions, indices, quads }) {
  if (!quads) return [];
  const broken = [];
  if (3 * quads.length !== 2 * indices.length) broken.push('triangles that are of no quad');
  const places = new Map();
  const placeOf = (/** @type {number} */ v) => {
    const key = positions.subarray(3 * v, 3 * v + 3).join();
    if (!places.has(key)) places.set(key, places.size);
    return places.get(key);
  };
  const sides = new Map(), around = new Map();
  for (let i = 0; i < quads.length; i += 4) {
    const corners = [...quads.subarray(i, i + 4)].map(placeOf);
    if (new Set(corners).size < 4) broken.push(`quad ${i / 4} has equal corners`);
    corners.forEach((a, k) => {
      const b = corners[(k + 1) % 4];
      const side = `${Math.min(a, b)}-${Math.max(a, b)}`;
      sides.set(side, (sides.get(side) ?? 0) + 1);
      around.set(a, (around.get(a) ?? 0) + 1);
    });
  }
  const open = new Set([...sides].filter(([, count]) => count !== 2)
    .flatMap(([side]) => side.split('-').map(Number)));
  const doublets = [...around].filter(([v, count]) => count < 3 && !open.has(v));
  if (doublets.length > 0) broken.push(`${doublets.length} inner vertices of two quads`);
  return broken;
}

const isGltf = ({ name }) => /\.gl(b|tf)$/.test(name);

/**
 * The validator's errors and warnings, by code. The validator itself fails on some files.
 */
export async function complaints(file) {
  try {
    return new Map((await issuesOf(file)).filter(({ severity }) => severity < 2)
      .map(({ code, message, pointer }) => [code, `${code} at ${pointer}: ${message}`]));
  } catch (error) {
    return new Map([['VALIDATOR_FAILED', `the validator fails: ${error}`]]);
  }
}

/** Colours of a glTF file must be within 0 to 1; the validator checks the rest. */
function lawsOfColors({ bytes, files = [] }) {
  const opened = openGltf({ bytes, files: [null, ...files] });
  const broken = [];
  if (!opened.data) return broken;
  for (const { primitives = [] } of opened.tree.meshes ?? []) {
    for (const { attributes } of primitives) {
      const accessor = opened.tree.accessors[attributes.COLOR_0];
      if (accessor?.bufferView === undefined || accessor.sparse) continue;
      const colors = valuesOf(opened, attributes.COLOR_0).flat();
      if (!colors.every((x) => x >= 0 && x <= 1)) broken.push('COLOR_0 is not within 0 to 1');
    }
  }
  return broken;
}

/** The names of all extensions that something in the tree has. @param {any} tree */
function extensionsIn(tree) {
  const names = new Set();
  const visit = (/** @type {any} */ value) => {
    if (typeof value !== 'object' || value === null) return;
    for (const name of Object.keys(Object(value.extensions))) names.add(name);
    Object.values(value).forEach(visit);
  };
  visit(tree);
  return names;
}

/**
 * The targets of references by number that the validator does not check must exist. What is not of
 * triangles and was declared in vain before may be so still.
 * @param {any} tree
 * @param {any} [before] the tree that it was made from
 */
export function lawsOfReferences(tree, before) {
  const broken = [];
  const names = extensionsIn(tree), namesBefore = extensionsIn(before);
  const isKnown = (/** @type {string} */ name) =>
    /^(CESIUM|EXT_mesh_(feat|mani|poly)|FB)/.test(name);
  const gone = (tree.extensionsUsed ?? []).filter((/** @type {string} */ name) => !names.has(name)
    && (isKnown(name) || (/^(ACME|KHR_anim|MSFT_lod)/.test(name)
      && (!before || namesBefore.has(name)))));
  if (gone.length > 0) broken.push(`${gone} are declared, and nowhere`);
  const materials = tree.materials?.length ?? 0;
  for (const { channels } of tree.animations ?? []) {
    for (const { target } of channels) {
      const { pointer } = target.extensions?.KHR_animation_pointer ?? {};
      const number = /^\/materials\/(\d+)/.exec(pointer ?? '')?.[1];
      if (Number(number) >= materials) broken.push(`${pointer} points to nothing`);
    }
  }
  const meshes = /** @type {any[]} */ (tree.meshes ?? []);
  const primitives = meshes.flatMap((mesh) => mesh.primitives ?? []);
  for (const { attributes, extensions } of primitives) {
    for (const { attribute } of extensions?.EXT_mesh_features?.featureIds ?? []) {
      const name = `_FEATURE_ID_${attribute}`;
      if (attribute !== undefined && !(name in attributes)) broken.push(`${name} is not there`);
    }
  }
  return broken;
}

/** The text of a file other than glTF. Binary files become OBJ first, because their bytes could
 * look like words. */
async function wordsOf({ name, bytes }) {
  const isBinary = bytes.includes(0);
  const words = isBinary ? (await convertFile(bytes, { name, output: 'words.obj' })).bytes : bytes;
  return new TextDecoder().decode(words);
}

/**
 * @param {any} before the file that went in: { name, bytes, files }
 * @param {any} after the file that came out
 */
export async function lawsOfFiles(before, after) {
  if (!isGltf(after)) {
    const text = await wordsOf(after);
    return /\b(nan|inf)/i.test(text.replace(/^\S*[a-z].*$/gm, (line) =>
      (/^(v|vt|vn) /.test(line) ? line : ''))) ? ['a number is not finite'] : [];
  }
  const known = isGltf(before) ? await complaints(before) : new Map();
  // The input's faults are unknown then, and the result may still have them.
  if (known.has('VALIDATOR_FAILED')) return [];
  // The validator asks for no skin if a mesh's joints and weights do not match.
  if (known.has('MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH')) {
    known.set('NODE_SKINNED_MESH_WITHOUT_SKIN', 'perhaps');
  }
  // The first set of texture coordinates is dropped if its type is invalid; the second set stays,
  // because materials may refer to it.
  if (known.has('MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT')) {
    known.set('MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY', 'perhaps');
  }
  // What is required is also used afterwards, and its name is looked at.
  if (known.has('UNUSED_EXTENSION_REQUIRED')) known.set('INVALID_EXTENSION_NAME_FORMAT', 'perhaps');
  const now = await complaints(after);
  const worse = [...now].filter(([code]) => !known.has(code)).map(([, words]) => words);
  if (known.size > 0) return worse;
  const references = lawsOfReferences(openGltf(after).tree,
    isGltf(before) ? openGltf(before).tree : undefined);
  return [...worse, ...lawsOfColors(after), ...references];
}

/** @param {any} found @param {any} said */
function lawsOfAngles(found, said) {
  return Math.abs(found.mean - said.mean) < 0.01 ? []
    : [`the file's mean angle is ${found.mean}°, not ${said.mean}°`];
}

/** The file must agree with the report. @param {any} found its inspection @param {any} report */
export function lawsOfReading(found, report) {
  return ['vertices', 'triangles', 'components', 'boundaryEdges', 'nonManifoldEdges',
    'eulerCharacteristic']
    .filter((name) => found.input[name] !== report.output[name])
    .map((name) => `the file has ${found.input[name]} ${name}, the report ${report.output[name]}`)
    .concat(lawsOfAngles(found.input.minAngle, report.output.minAngle));
}
