#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// The command line.

import { readFile } from 'node:fs/promises';
import { basename, extname } from 'node:path';

import { Api } from '../api/api.js';
import { cardText } from '../card.js';
import { helpText, parseCommandLine } from './cli_arguments.js';
import { RemeshError } from '../base/errors.js';
import { withoutGz } from '../base/formats.js';
import { requireOutput, writeOutput } from '../files/output.js';
import { isFolder } from './plan.js';
import { platform } from './platform.js';
import { reportInWords } from './report_in_words.js';
import { runFile } from './run_file.js';
import { runMany } from './run_many.js';
import {
  errorInWords, exitStatusOf, outliveClosedPipes, print, progressBar, say,
} from './terminal.js';

/** @typedef {import('./cli_arguments.js').CommandLine} CommandLine */

/** @param {CommandLine} line @param {{ report: any }} result */
async function report({ command, json, quiet }, result) {
  if (json) await print(`${JSON.stringify(result.report, null, 2)}\n`);
  else if (command === 'inspect') await print(reportInWords(result.report));
  else if (!quiet) say(reportInWords(result.report));
}

/** @param {CommandLine} line */
const placeOfCard = ({ card, inputs, force }) => ({ path: card, inputs, force });

/** @param {CommandLine} line @param {{ report: any }} result */
async function writeCard(line, { report: { card } }) {
  const text = cardText(card, { title: basename(line.inputs[0]) });
  await writeOutput([{ name: basename(line.card), bytes: new TextEncoder().encode(text) }],
    placeOfCard(line));
}

/** @param {CommandLine} line */
async function runOne(line) {
  const { command, inputs: [input, operand], output, format, card, quiet, root, force, guides,
    options } = line;
  if (command === 'help' || command === 'version') return;
  if (card) requireOutput(placeOfCard(line));
  const isPiped = output === '-';
  const plain = withoutGz(basename(input));
  const outputName = isPiped ? `${basename(plain, extname(plain))}.${format}` : basename(output);
  const { onProgress, clear } = progressBar(quiet || ['inspect', 'convert'].includes(command));
  const result = await runFile(
    { command, input, second: line.onto || operand, output: isPiped ? '' : output, outputName,
      root, force, guides, options },
    new Api(platform), { worker: false, onProgress }).finally(clear);
  if (isPiped && result.files.length > 1) {
    throw new RemeshError('INVALID_OPTION',
      `A ${format} of this model is ${result.files.length} files, and standard output takes one.`,
      'Use --format glb, or write to a file.');
  }
  if (isPiped) await print(result.files[0].bytes);
  if (card) await writeCard(line, result);
  await report(line, result);
}

async function showVersion() {
  const manifest = await readFile(new URL('../../package.json', import.meta.url), 'utf8');
  await print(`${JSON.parse(manifest).version}\n`);
}

/** @param {CommandLine} line */
function isMany({ command, output }) {
  return command !== 'inspect' && isFolder(output);
}

/** @param {string[]} words */
async function main(words) {
  const line = parseCommandLine(words);
  if (line.command === 'help') await print(helpText());
  else if (line.command === 'version') await showVersion();
  else if (isMany(line)) process.exitCode = await runMany(line);
  else await runOne(line);
}

outliveClosedPipes();
await main(process.argv.slice(2)).catch((error) => {
  say(`remesher: ${errorInWords(error)}\n`);
  process.exitCode = exitStatusOf(error);
});
