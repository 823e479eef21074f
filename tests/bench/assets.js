// SPDX-License-Identifier: MIT
// What the preset `asset` makes of textured models: one run each, to a number of triangles, with
// two levels of detail; its look beside meshoptimizer's simplification to as many triangles.
import { readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import { inspect, remeshFile } from 'remesher';

import { assetModels } from './asset_models.js';
import { markdownTable } from './table.js';
import { openGltf, validate } from '../support/gltf.js';
import { openGallery } from '../support/pictures.js';
import { simplified } from '../support/simplified.js';

const faces = 5000;
const lods = [0.5, 0.25];

const columns = ['model', 'triangles', 'result', 'levels', 'draws', 'images', 'bytes', 'result',
  'pieces', 'result', 'SSIM', 'meshoptimizer', 'triangles', 's'];

/** meshoptimizer may stop above the number; then its result is no measure. */
const mostMore = 1.02;

const mean = (views) => views.reduce((sum, { ssim }) => sum + ssim, 0) / views.length;

/** @param {any} tree of a glTF file */
const trianglesOf = ({ meshes, accessors }) => meshes.flatMap(({ primitives }) => primitives)
  .reduce((sum, { indices }) => sum + accessors[indices].count / 3, 0);

/** The files of a folder that hold everything themselves. @param {string} folder */
const filesOf = (folder) => readdirSync(folder, { recursive: true })
  .filter((name) => /\.glb$/i.test(String(name))).map((name) => join(folder, String(name))).sort();

/** @param {string[]} folders @returns {[string, () => Uint8Array][]} */
const modelsOf = (folders) => [...Object.entries(assetModels),
  ...folders.flatMap(filesOf).map((path) => [basename(path), () => readFileSync(path)])];

/** Per material how it is drawn: materials of one kind can share a set of maps.
 * @param {any} tree of a glTF file */
const kindsOf = ({ materials = [] }) =>
  materials.map(({ alphaMode, doubleSided, extensions = {} }) =>
    `${alphaMode} ${doubleSided} ${'KHR_materials_unlit' in extensions}`);

/** What is wrong with a result. @param {any} row */
function faultsOf({ name, errors, report, tree, kinds, given, bytes, ssim, peer }) {
  const wrong = errors.map((error) => `not valid: ${error}`);
  if (report.output.triangles > faces) wrong.push(`${report.output.triangles} triangles`);
  if (bytes > given) wrong.push(`${bytes} bytes of ${given}`);
  const isPeer = peer.triangles <= mostMore * report.output.triangles;
  if (isPeer && ssim < peer.ssim) {
    wrong.push(`SSIM ${ssim.toFixed(3)}, meshoptimizer's ${peer.ssim.toFixed(3)}`);
  }
  const sets = kindsOf(tree).length;
  if (sets > new Set(kinds).size) wrong.push(`${sets} materials`);
  return wrong.map((text) => `${name}: ${text}`);
}

/** @param {[string, () => Uint8Array]} model @param {any} gallery */
async function rowOf([name, make], gallery) {
  const given = make();
  const before = await inspect(given, { name: 'model.glb' });
  const begin = performance.now();
  const result = await remeshFile(given, { name: 'model.glb', preset: 'asset', faces, lods });
  const seconds = (performance.now() - begin) / 1000;
  const { report } = result;
  const { tree } = openGltf(result);
  const beside = await simplified(given, report.output.triangles);
  const peer = { ssim: mean(await gallery.compare(given, beside)),
    triangles: trianglesOf(openGltf({ bytes: beside }).tree) };
  const ssim = mean(await gallery.compare(given, result.bytes));
  const errors = await validate(result);
  const draws = tree.meshes[0].primitives.length;
  const cells = [name, before.input.triangles, report.output.triangles,
    report.lods.map(({ output }) => output.triangles).join(' '), draws, tree.images?.length ?? 0,
    given.length, result.bytes.length, before.input.components, report.output.components,
    ssim.toFixed(3), peer.ssim.toFixed(3), peer.triangles, seconds.toFixed(1)];
  console.error(cells.join(' | '));
  return { cells, wrong: faultsOf({ name, errors, report, tree,
    kinds: kindsOf(openGltf({ bytes: given }).tree), given: given.length,
    bytes: result.bytes.length, ssim, peer }) };
}

/** @param {string[]} folders of GLB files beside the made models */
export async function runAssets(folders) {
  const gallery = await openGallery();
  const rows = [];
  try {
    for (const model of modelsOf(folders)) rows.push(await rowOf(model, gallery));
  } finally {
    await gallery.close();
  }
  return { table: markdownTable(columns, rows.map(({ cells }) => cells)),
    broken: rows.flatMap(({ wrong }) => wrong) };
}
