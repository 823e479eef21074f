// SPDX-License-Identifier: MIT
// Works on one file: reads it with the files it refers to, has it remeshed or otherwise processed,
// and writes the result with its companions. Nothing is written before all has succeeded.

import { basename } from 'node:path';

import { RemeshError } from '../base/errors.js';
import { gunzip } from '../codecs/gunzip.js';
import { referencesOf } from '../codecs/resources.js';
import { Gate } from '../files/gate.js';
import { readInput } from '../files/input.js';
import { requireOutput, writeOutput } from '../files/output.js';

/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */
/** @typedef {import('../base/messages.js').ProgressEvent} ProgressEvent */
/** @typedef {import('../base/messages.js').Warning} Warning */
/**
 * @typedef {Pick<import('../api/api.js').Api, 'inspect' | 'convertFile' | 'repairFile'
 *   | 'remeshFile'>} Api
 */
/** @typedef {import('../api/client.js').RunOptions} RunOptions */

/**
 * @typedef {object} FileTask
 * @property {'remesh' | 'convert' | 'repair' | 'inspect'} command
 * @property {string} input
 * @property {string} output empty: the caller takes the files
 * @property {string} outputName
 * @property {string | undefined} root
 * @property {boolean} force
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

/** The refused files, with what would help. @param {Gate} gate @param {FileTask} task */
function refusals(gate, { root }) {
  const help = root === undefined
    ? 'A model may name files in its own folder; with --root DIR, those below DIR.'
    : 'A model may name files below --root.';
  return gate.refusals().map((sentence) => `${sentence} ${help}`);
}

/** @param {unknown} error @param {string[]} refused */
function withRefusals(error, refused) {
  const isMissing = error instanceof RemeshError && error.code === 'MISSING_RESOURCE';
  return isMissing && refused.length > 0
    ? new RemeshError(error.code, error.message, refused[0], { cause: error }) : error;
}

/**
 * @param {FileTask} task
 * @param {Api} api
 * @param {Uint8Array} bytes
 * @param {RunOptions & { name: string, resources: Record<string, Uint8Array> }} about
 * @returns {Promise<FileResult>}
 */
async function work(task, api, bytes, about) {
  if (task.command === 'inspect') {
    return { files: [], report: { ...await api.inspect(bytes, { ...about, faults: true }) } };
  }
  const output = task.outputName;
  if (task.command === 'convert') {
    const { files, warnings } = await api.convertFile(bytes, { ...about, output });
    return { files, report: { warnings } };
  }
  const options = { ...task.options, ...about, output };
  const { files, report } = task.command === 'repair'
    ? await api.repairFile(bytes, options) : await api.remeshFile(bytes, options);
  return { files, report: { ...report } };
}

/**
 * @param {FileTask} task
 * @param {Api} api
 * @param {RunOptions} run where it runs, who hears of its progress
 * @returns {Promise<FileResult>}
 */
export async function runFile(task, api, run) {
  const { input, output, force } = task;
  const { name, bytes } =
    await gunzip({ name: basename(input), bytes: await readInput(input) });
  if (output) requireOutput({ path: output, inputs: [input], force });
  const gate = await Gate.of(input, task.root);
  const isPainted = task.options.textures === 'bake';
  const resources = await readResources({ name, bytes, isPainted }, gate);
  const refused = refusals(gate, task);
  const result = await work(task, api, bytes, { ...run, name, resources }).catch((error) => {
    throw withRefusals(error, refused);
  });
  result.report.warnings = [...result.report.warnings,
    ...refused.map((message) => ({ code: 'RESOURCE_REFUSED', message, count: 1 }))];
  if (output) {
    await writeOutput(result.files, { path: output, inputs: [input, ...gate.files], force });
  }
  return result;
}
