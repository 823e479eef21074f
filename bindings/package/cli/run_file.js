// SPDX-License-Identifier: MIT
// Works on one file: reads it with the files it refers to, has it remeshed or otherwise processed,
// and writes the result with its companions. Nothing is written before all has succeeded.

import { basename } from 'node:path';

import { RemeshError } from '../base/errors.js';
import { OpenFile } from '../base/open_file.js';
import { blocksOfPieces } from '../base/pieces.js';
import { withPreset } from '../base/presets.js';
import { guidesFrom } from '../codecs/guides_file.js';
import { gunzipAll, isGzip } from '../codecs/gunzip.js';
import { referencesOf } from '../codecs/resources.js';
import { Gate } from '../files/gate.js';
import { withInput } from '../files/input.js';
import { requireOutput, writeOutput } from '../files/output.js';
import { blocksOf as openBlocks } from '../platform_node.js';

/** @typedef {import('../base/messages.js').BooleanOperation} BooleanOperation */
/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */
/** @typedef {import('../base/messages.js').ProgressEvent} ProgressEvent */
/** @typedef {import('../base/messages.js').Warning} Warning */
/**
 * @typedef {Pick<import('../api/api.js').Api, 'inspect' | 'convertFile' | 'repairFile'
 *   | 'remeshFile' | 'bakeFile' | 'unwrapFile' | 'booleanFiles'>} Api
 */
/** @typedef {import('../api/client.js').RunOptions} RunOptions */

/**
 * @typedef {object} FileTask
 * @property {'remesh' | 'convert' | 'repair' | 'inspect' | 'bake' | 'unwrap' | BooleanOperation}
 *   command
 * @property {string} input
 * @property {string} [second] the other operand of a Boolean; what is baked onto
 * @property {string} output empty: the caller takes the files
 * @property {string} outputName
 * @property {string | undefined} root
 * @property {boolean} force
 * @property {string} [guides] the file with lines that quads follow
 * @property {Record<string, unknown>} options
 */

/**
 * @typedef {object} FileResult
 * @property {NamedBytes[]} files
 * @property {{ warnings: Warning[] } & Record<string, any>} report
 */

/**
 * The files that the file refers to; for painting, the images of its material libraries, too.
 * @param {{ name: string, content: OpenFile, isPainted: boolean }} file
 * @param {Gate} gate
 */
async function readResources({ name, content: { bytes, handle }, isPainted }, gate) {
  /** @type {Record<string, Uint8Array>} */
  const resources = Object.create(null);
  const references = new Set(referencesOf(name, bytes, handle && blocksOf(handle)));
  for (const reference of references) {
    const content = await gate.read(reference);
    if (!content) continue;
    resources[reference] = content;
    if (!isPainted || !/\.mtl$/i.test(reference)) continue;
    for (const image of referencesOf(reference, content)) references.add(image);
  }
  return resources;
}

/** The refused files, with what would help. @param {Gate[]} gates @param {FileTask} task */
function refusals(gates, { root }) {
  const help = root === undefined
    ? 'A model may name files in its own folder; with --root DIR, those below DIR.'
    : 'A model may name files below --root.';
  return gates.flatMap((gate) => gate.refusals()).map((sentence) => `${sentence} ${help}`);
}

/** @param {unknown} error @param {string[]} refused */
function withRefusals(error, refused) {
  const isMissing = error instanceof RemeshError && error.code === 'MISSING_RESOURCE';
  return isMissing && refused.length > 0
    ? new RemeshError(error.code, error.message, refused[0], { cause: error }) : error;
}

/** @typedef {{ path: string, name: string, content: OpenFile }} Input the name without a .gz */

/**
 * An input with the files that it refers to.
 * @typedef {Input & { resources: Record<string, Uint8Array>, gate: Gate }} Opened
 */

/** @param {Input} input @param {FileTask} task @returns {Promise<Opened>} */
async function withResources(input, { command, root, options }) {
  const { path, name, content } = input;
  const gate = await Gate.of(path, root);
  const isPainted = command === 'bake' || withPreset(options).textures === 'bake';
  return { ...input, gate, resources: await readResources({ name, content, isPainted }, gate) };
}

/** The file, unpacked. @param {string} path @param {OpenFile} content @returns {Promise<Input>} */
async function unpacked(path, content) {
  const given = basename(path);
  if (!isGzip(content.bytes)) return { path, name: given, content };
  const { name, bytes, handle } = await gunzipAll(
    { name: given, bytes: content.bytes, resources: [], output: '' });
  return { path, name,
    content: new OpenFile(/** @type {Uint8Array<ArrayBuffer>} */ (bytes), handle) };
}

/** The way to the bytes of an open file.
 * @param {import('../base/open_file.js').FileHandle} handle */
function blocksOf({ fd, pieces, size }) {
  const read = pieces ? blocksOfPieces({ pieces, size }) : openBlocks({ fd, size });
  return { size, read: read ?? (() => false) };
}

/** All bytes of an open file. @param {OpenFile} content */
function wholeOf({ bytes, handle }) {
  if (!handle) return new OpenFile(bytes);
  const all = new Uint8Array(handle.size);
  return new OpenFile(blocksOf(handle).read(0, all) ? all : bytes);
}

/**
 * The task with the guides of its file among its options.
 * @param {FileTask} task @returns {Promise<FileTask>}
 */
async function withGuides(task) {
  if (task.guides === undefined) return task;
  const { guides, root } = task;
  const { name, content } = await withInput(guides, async (file) => {
    const input = await unpacked(guides, file);
    return { name: input.name, content: wholeOf(input.content) };
  });
  const gate = await Gate.of(guides, root);
  const resources = await readResources({ name, content, isPainted: false }, gate);
  const named = Object.entries(resources).map(([resource, bytes]) => ({ name: resource, bytes }));
  const lines = guidesFrom({ name, bytes: content.bytes }, named);
  return { ...task, options: { ...task.options, guides: lines } };
}

/** What the functions of files take without copying it, which only the package itself may give.
 * @param {Input | undefined} input @returns {import('../api/inputs.js').Bytes} */
const taken = (input) => /** @type {any} */ (input?.content);

/**
 * @param {FileTask} task
 * @param {Api} api
 * @param {Opened[]} opened
 * @param {RunOptions} run
 * @returns {Promise<FileResult>}
 */
async function work({ command, outputName: output, options }, api, [file, second], run) {
  const { name, resources } = file;
  const [content, other] = [file, second].map(taken);
  const about = { ...run, name, resources };
  switch (command) {
    case 'inspect':
      return { files: [], report: { ...await api.inspect(content, { ...about, faults: true }) } };
    case 'convert': {
      const { files, warnings, compression } =
        await api.convertFile(content, { ...options, ...about, output });
      return { files, report: { warnings, ...(compression ? { compression } : {}) } };
    }
    case 'repair':
      return api.repairFile(content, { ...options, ...about, output });
    case 'remesh':
      return api.remeshFile(content, { ...options, ...about, output });
    case 'unwrap':
      return api.unwrapFile(content, { ...options, ...about, output });
    case 'bake':
      return api.bakeFile(content, other, { ...options, ...about, output,
        nameLow: second.name, resourcesLow: second.resources });
    default:
      return api.booleanFiles(content, other, command, { ...run, output, nameA: name,
        nameB: second.name, resourcesA: resources, resourcesB: second.resources });
  }
}

/**
 * @param {FileTask} task
 * @param {Input[]} given the files, open
 * @param {{ api: Api, run: RunOptions }} how where it runs, who hears of its progress
 * @returns {Promise<FileResult>}
 */
async function runOpened(task, given, { api, run }) {
  const { output, force } = task;
  const inputs = given.map(({ path }) => path);
  if (output) requireOutput({ path: output, inputs, force });
  const opened = [];
  for (const input of given) opened.push(await withResources(input, task));
  const gates = opened.map(({ gate }) => gate);
  const refused = refusals(gates, task);
  const { files: made, report } = await work(task, api, opened, run).catch((error) => {
    throw withRefusals(error, refused);
  });
  const result = { files: made, report: { ...report, warnings: [...report.warnings,
    ...refused.map((message) => ({ code: 'RESOURCE_REFUSED', message, count: 1 }))] } };
  if (output) {
    await writeOutput(made,
      { path: output, inputs: [...inputs, ...gates.flatMap((gate) => gate.files)], force });
  }
  return result;
}

/**
 * @param {FileTask} given
 * @param {Api} api
 * @param {RunOptions} run where it runs, who hears of its progress
 * @returns {Promise<FileResult>}
 */
export async function runFile(given, api, run) {
  const task = await withGuides(given);
  const { input, second } = task;
  return withInput(input, async (content) => {
    const file = await unpacked(input, content);
    if (second === undefined) return runOpened(task, [file], { api, run });
    return withInput(second, async (other) =>
      runOpened(task, [file, await unpacked(second, other)], { api, run }));
  });
}
