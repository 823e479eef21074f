// SPDX-License-Identifier: MIT
// Counts how often each fallback, each limit of work and each row of the chooser fires over a
// folder of files: plain, quads, repaired, baked. Names that never fire are listed last: the code
// behind them goes, unless a test needs it, which is named beside it.
import { execFileSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { basename, dirname, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { formats } from '../../bindings/package/base/formats.js';
import { filesUnder, readText } from '../support/tree.js';
import { markdownTable } from './table.js';

const tool = join(dirname(fileURLToPath(import.meta.url)), '../../build/native/fires');

/** A file that takes longer is left, with what was counted so far. */
const minutes = 5;

/**
 * Tests that need what never fires over models and cases.
 * @type {Readonly<Record<string, string>>}
 */
const neededBy = {
  'accuracy samples: steps made longer':
    'fewest vertices: a bound near nothing is kept along the edges of the input',
  'exact repair: the union intersects itself':
    'body_union: bodies whose union is not sound do not spoil the others',
  'exact repair: united group by group':
    'body_union: bodies whose union is not sound do not spoil the others',
  'joints: sheets that coincide': 'joints: of two layers only the rim is',
  'manifold cut: edge with too many triangles':
    'manifold_cut: an edge of very many triangles is taken apart',
  'only-repaired': 'part repair: what rounding makes meet itself becomes the sound original, and '
    + 'says so',
};

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

/** What a program that was stopped or failed has printed, too. @param {string} file */
function printedFor(file) {
  try {
    return execFileSync(tool, [file],
      { encoding: 'utf8', timeout: minutes * 60_000, stdio: 'pipe' });
  } catch (error) {
    const { stdout, signal, status } = /** @type {any} */ (error);
    console.error(`${basename(file)} ended early (${signal ?? status})`);
    return String(stdout ?? '');
  }
}

/** @param {string[]} folders */
export function runFires(folders) {
  const files = folders.flatMap(modelsIn);
  if (files.length === 0) throw new Error('Which folder of models? --models FOLDER');
  /** @type {Map<string, { times: number, runs: number, files: Set<string>, example: string }>} */
  const found = new Map();
  let runs = 0;
  for (const file of files) {
    for (const line of printedFor(file).split('\n').filter(Boolean)) {
      const { run, fired } = JSON.parse(line);
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
  for (const name of never) console.log(`  ${name} (${neededBy[name] ?? 'no test is known'})`);
}
