// SPDX-License-Identifier: MIT
// Works on one file: reads it with the files it refers to, has it remeshed or otherwise processed,
// and writes the result with its companions. Nothing is written before all has succeeded.

import { basename } from 'node:path';

import { RemeshError } from '../base/errors.js';
import { withPreset } from '../base/presets.js';
import { guidesFrom } from '../codecs/guides_file.js';
import { gunzip } from '../codecs/gunzip.js';
import { referencesOf } from '../codecs/resources.js';
import { Gate } from '../files/gate.js';
import { readInput } from '../files/input.js';
import { requireOutput, writeOutput } from '../files/output.js';

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
 * @param {{ name: string, bytes: Uint8Array, isPainted: boolean }} file
 * @param {Gate} gate
 */
async function readResources({ name, bytes, isPainted }, gate) {
  /** @type {Record<string, Uint8Array>} */
  const resources = Object.create(null);
  const references = new Set(referencesOf(name, bytes));
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

/**
 * A file that was read, with those that it refers to.
 * @typedef {{ name: string, bytes: Uint8Array, resources: Record<string, Uint8Array>, gate: Gate }}
 *   Opened
 */

/** @param {string} input @param {{ name: string, bytes: Uint8Array }} file @param {FileTask} task
 * @returns {Promise<Opened>} */
async function withResources(input, { name, bytes }, { command, root, options }) {
  const gate = await Gate.of(input, root);
  const isPainted = command === 'bake' || withPreset(options).textures === 'bake';
  return { name, bytes, gate, resources: await readResources({ name, bytes, isPainted }, gate) };
}

/**
 * The task with the guides of its file among its options.
 * @param {FileTask} task @returns {Promise<FileTask>}
 */
async function withGuides(task) {
  if (task.guides === undefined) return task;
  const file = await read(task.guides);
  const gate = await Gate.of(task.guides, task.root);
  const resources = await readResources({ ...file, isPainted: false }, gate);
  const named = Object.entries(resources).map(([name, bytes]) => ({ name, bytes }));
  return { ...task, options: { ...task.options, guides: guidesFrom(file, named) } };
}

/** @param {string} input */
const read = async (input) => gunzip({ name: basename(input), bytes: await readInput(input) });

/**
 * @param {FileTask} task
 * @param {Api} api
 * @param {Opened[]} opened
 * @param {RunOptions} run
 * @returns {Promise<FileResult>}
 */
async function work({ command, outputName: output, options }, api, [file, second], run) {
  const { name, bytes, resources } = file;
  const about = { ...run, name, resources };
  switch (command) {
    case 'inspect':
      return { files: [], report: { ...await api.inspect(bytes, { ...about, faults: true }) } };
    case 'convert': {
      const { files, warnings, compression } =
        await api.convertFile(bytes, { ...options, ...about, output });
      return { files, report: { warnings, ...(compression ? { compression } : {}) } };
    }
    case 'repair':
      return api.repairFile(bytes, { ...options, ...about, output });
    case 'remesh':
      return api.remeshFile(bytes, { ...options, ...about, output });
    case 'unwrap':
      return api.unwrapFile(bytes, { ...options, ...about, output });
    case 'bake':
      return api.bakeFile(bytes, second.bytes, { ...options, ...about, output,
        nameLow: second.name, resourcesLow: second.resources });
    default:
      return api.booleanFiles(bytes, second.bytes, command, { ...run, output, nameA: name,
        nameB: second.name, resourcesA: resources, resourcesB: second.resources });
  }
}

/**
 * @param {FileTask} given
 * @param {Api} api
 * @param {RunOptions} run where it runs, who hears of its progress
 * @returns {Promise<FileResult>}
 */
export async function runFile(given, api, run) {
  const task = await withGuides(given);
  const { input, second, output, force } = task;
  const inputs = second === undefined ? [input] : [input, second];
  const files = [];
  for (const path of inputs) files.push(await read(path));
  if (output) requireOutput({ path: output, inputs, force });
  const opened = [];
  for (const [i, path] of inputs.entries()) {
    opened.push(await withResources(path, files[i], task));
  }
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
