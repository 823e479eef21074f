// SPDX-License-Identifier: MIT
// Counts how often each fallback, each limit of work and each row of the chooser fires over a
// folder of files: plain, quads, repaired, baked. Names that never fire are listed last, each with
// a unit test that reaches it: the code behind a name without one goes, unless it guards against
// loops without end.
import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { basename, dirname, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { formats } from '../../bindings/package/base/formats.js';
import { filesUnder, readText } from '../support/tree.js';
import { markdownTable } from './table.js';

const tool = join(dirname(fileURLToPath(import.meta.url)), '../../build/native/fires');

/** A file that takes longer is left, with what was counted so far; so are the unit tests. */
const minutes = 5;

/** The unit tests, where they are built: which of them reach what no model does. */
const tests = join(dirname(fileURLToPath(import.meta.url)), '../../build/test/unit_tests');

/** All names that can fire, as the sources have them. */
function knownNames() {
  const sources = filesUnder('src', /\.cpp$/).map(readText).join('\n');
  const rules = readText('src/remesh/schemes/chooser.cpp');
  return [...new Set([...sources.matchAll(/\bfires\("([^"]+)"\)/g),
    ...rules.matchAll(/\bRule\{\s*Decision::\w+,\s*"([\w-]+)"/g)].map(([, name]) => name))].sort();
}

/** Models below the folders, as far as they have a name that is read. @param {string} folder */
const modelsIn = (folder) => readdirSync(folder, { recursive: true })
  .map((name) => join(folder, String(name)))
  .filter((path) => formats.some((format) => format === extname(path).slice(1).toLowerCase()))
  .sort();

/** Lines that a program prints, also if it is stopped or fails.
 * @param {string} program @param {string} argument
 * @returns {{ run: string, fired: Record<string, number> }[]} */
function printedBy(program, argument) {
  const lines = (/** @type {string} */ text) =>
    text.split('\n').filter((line) => /^{.*}$/.test(line)).map((line) => JSON.parse(line));
  try {
    return lines(execFileSync(program, [argument],
      { encoding: 'utf8', timeout: minutes * 60_000, stdio: 'pipe', maxBuffer: 2 ** 26 }));
  } catch (error) {
    const { stdout, signal, status } = /** @type {any} */ (error);
    console.error(`${basename(argument)} ended early (${signal ?? status})`);
    return lines(String(stdout ?? ''));
  }
}

/** By name the first unit test that reaches it, and how many do. */
function reachedByTests() {
  /** @type {Map<string, { test: string, count: number }>} */
  const reached = new Map();
  if (!existsSync(tests)) return reached;
  for (const { run, fired } of printedBy(tests, '-r=fires')) {
    for (const name of Object.keys(fired)) {
      const { test, count } = reached.get(name) ?? { test: run, count: 0 };
      reached.set(name, { test, count: count + 1 });
    }
  }
  return reached;
}

/** @param {string[]} names that never fire on models */
function printNever(names) {
  const reached = names.length > 0 ? reachedByTests() : new Map();
  for (const name of names) {
    const { test, count } = reached.get(name) ?? {};
    const needs = test ? `test "${test}"${count > 1 ? ` and ${count - 1} more` : ''}` : 'no test';
    console.log(`  ${name} (${needs})`);
  }
  if (!existsSync(tests)) console.log('npm test builds the unit tests, which are asked, too.');
}

/** @param {string[]} folders */
export function runFires(folders) {
  const files = folders.flatMap(modelsIn);
  if (files.length === 0) throw new Error('Which folder of models? --models FOLDER');
  /** @type {Map<string, { times: number, runs: number, files: Set<string>, example: string }>} */
  const found = new Map();
  let runs = 0;
  for (const file of files) {
    for (const { run, fired } of printedBy(tool, file)) {
      runs += 1;
      for (const [name, times] of Object.entries(fired)) {
        const sum = found.get(name)
          ?? { times: 0, runs: 0, files: new Set(), example: `${basename(file)}, ${run}` };
        sum.times += Number(times);
        sum.runs += 1;
        sum.files.add(file);
        found.set(name, sum);
      }
    }
  }
  const names = knownNames();
  console.log(`${runs} runs on ${files.length} files\n`);
  console.log(markdownTable(['fires', 'times', 'runs', 'files', 'such as'],
    names.filter((name) => found.has(name)).map((name) => {
      const { times, runs: own, files: on, example } = /** @type {any} */ (found.get(name));
      return [name, String(times), String(own), String(on.size), example];
    })));
  const never = names.filter((name) => !found.has(name));
  console.log(`\n${never.length} of ${names.length} never fire${never.length ? ':' : '.'}`);
  printNever(never);
}
