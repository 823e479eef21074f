// SPDX-License-Identifier: MIT
// Works on many files: several at once, each in a worker of its own; prints a line for each as it
// ends. One bad file does not stop the others.

import { accessSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { basename, dirname } from 'node:path';

import { Api } from '../api/api.js';
import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { makeFolders, removeEmptyFolders } from '../files/folders.js';
import { undoneIfInterrupted } from '../files/interruptions.js';
import { reason } from '../files/reasons.js';
import { clashes, plan } from './plan.js';
import { platform } from './platform.js';
import { runFile } from './run_file.js';
import {
  errorInWords, exitStatusOf, failureFrom, print, progressOfMany, say,
} from './terminal.js';

/** @typedef {import('./cli_arguments.js').CommandLine} CommandLine */
/** @typedef {import('./plan.js').Step} Step */

/** @param {string} path */
function exists(path) {
  try {
    accessSync(path);
    return true;
  } catch {
    return false;
  }
}

/** @param {string} output @param {string} why @param {string} [hint] */
function unwritable(output, why, hint) {
  return new RemeshError('OUTPUT_UNWRITABLE',
    `${legible(output)} cannot be written: ${why}.`, hint);
}

/** @param {any} report */
function reportInBrief({ output, fidelity, warnings, stopped }) {
  const parts = [];
  if (output) {
    parts.push(`${output.vertices} vertices`,
      `mean minimum angle ${output.minAngle.mean.toFixed(1)}°`);
  }
  if (fidelity) parts.push(`distance ${fidelity.hausdorff.toFixed(4)} %`);
  if (stopped && stopped !== 'target') parts.push(`stopped by ${stopped}`);
  if (warnings.length > 0) parts.push(`warnings: ${warnings.length}`);
  return parts.join(', ') || 'done';
}

/** The state of a run over many files: the request, and what is done. */
class Batch {
  /** @type {number[]} */
  #statuses = [0];
  #next = 0;
  /** @type {string[]} made by this run, the innermost first */
  #folders = [];

  /** @param {CommandLine} line */
  constructor(line) {
    this.line = line;
    this.steps = plan(line.inputs, line.output, line.format);
    this.clashing = clashes(this.steps);
    this.progress = progressOfMany(line.quiet, this.steps.length);
  }

  /** Works until nothing is left. Several calls do so at the same time. */
  async work() {
    const api = new Api(platform);
    while (this.#next < this.steps.length) {
      const number = this.#next;
      this.#next += 1;
      await this.#step(this.steps[number], number, api).catch((error) =>
        this.#fail(this.steps[number], error));
      this.progress.done(number);
    }
  }

  /** @returns {number} 2 if a file failed, 1 if we did */
  status() {
    return this.#statuses.includes(1) ? 1 : Math.max(...this.#statuses);
  }

  /** Removes the folders that this run made for nothing. */
  tidy() {
    removeEmptyFolders(this.#folders);
  }

  /**
   * @param {Step} step
   * @param {number} number
   * @param {Api} api
   */
  async #step(step, number, api) {
    const { input, output } = step;
    const { command, root, force, skipExisting, guides, options } = this.line;
    if (step.error) throw step.error;
    if (this.clashing.has(step)) {
      throw unwritable(output, 'another input’s result has this name',
        'Give them to different folders.');
    }
    if (exists(output)) {
      if (skipExisting) return this.#skip(step);
      if (!force) {
        throw unwritable(output, 'it is there already',
          'Give --force to replace it, or --skip-existing to go on.');
      }
    }
    this.#makeFolder(output);
    const result = await runFile({
      command: command === 'convert' || command === 'repair' || command === 'unwrap' ? command
        : 'remesh',
      input, output, outputName: basename(output), root, force, guides, options,
    }, api, { onProgress: this.progress.listener(number) });
    return this.#succeed(step, result.report);
  }

  /** @param {string} output */
  #makeFolder(output) {
    try {
      this.#folders.unshift(...makeFolders(dirname(output)));
    } catch (error) {
      throw unwritable(output, reason(error), 'Choose another output.');
    }
  }

  /** @param {Step} step @param {any} report */
  async #succeed({ input, output }, report) {
    if (this.line.json) await printJson({ file: input, result: output, ...report });
    else if (!this.line.quiet) {
      this.#tell(`${legible(input)} → ${legible(output)}: ${reportInBrief(report)}`);
    }
  }

  /** @param {Step} step */
  async #skip({ input, output }) {
    if (this.line.json) await printJson({ file: input, result: output, skipped: true });
    else if (!this.line.quiet) {
      this.#tell(`${legible(input)}: skipped, ${legible(output)} is there`);
    }
  }

  /** @param {Step} step @param {unknown} error */
  async #fail({ input }, error) {
    this.#statuses.push(exitStatusOf(error));
    if (this.line.json) await printJson({ file: input, error: failureFrom(error) });
    this.#tell(`remesher: ${legible(input)}: ${errorInWords(error)}`);
  }

  /** @param {string} text a line, above the bar */
  #tell(text) {
    this.progress.clear();
    say(`${text}\n`);
  }
}

/** @param {object} value in one line */
function printJson(value) {
  return print(`${JSON.stringify(value)}\n`);
}

/**
 * @param {CommandLine} line
 * @returns {Promise<number>} the exit status
 */
export async function runMany(line) {
  const batch = new Batch(line);
  const jobs = Math.min(line.jobs || availableParallelism(), batch.steps.length);
  const tidy = () => batch.tidy();
  await undoneIfInterrupted(tidy, () =>
    Promise.all(Array.from({ length: jobs }, () => batch.work()))).finally(tidy);
  batch.progress.clear();
  return batch.status();
}
