// SPDX-License-Identifier: MIT
// The C++ unit tests, built natively with checks that end the program: each of their cases is a
// case here. They run in portions, one at a time per core. The cases of a file that passed are not
// run again before something has changed that their code can reach.
import assert from 'node:assert/strict';
import { execFile, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { versions } from '../support/cpp_checks.js';
import { withCallees } from '../support/cpp_sources.js';
import { readText, root } from '../support/tree.js';

/**
 * @typedef {object} Case
 * @property {string} name
 * @property {boolean} passed
 * @property {string} body what doctest says of it
 */

const program = join(root, 'build/test/unit_tests');
const memory = join(root, 'build/checks');
const portion = 6;
/** Their cases take seconds each: they begin first, each by itself, so that none is left to the end
 * with the other cores idle. */
const slowest = ['tests/unit/textures/charts/unwrap_test.cpp',
  'tests/unit/remesh/schemes/follow_test.cpp'];
/** No case takes a tenth of this, on busy cores. */
const longest = 900_000;
const unescaped = (text) => text.replace(/&(quot|lt|gt|apos|amp);/g,
  (_, name) => ({ quot: '"', lt: '<', gt: '>', apos: "'", amp: '&' })[name]);

/** Name and verdict of every case in doctest's XML. @returns {Case[]} */
function casesIn(xml) {
  return [...xml.matchAll(/<TestCase name="([^"]*)"[^>]*(?<!\/)>(.*?)<\/TestCase>/gs)].map(
    ([, name, body]) => ({
      name: unescaped(name),
      passed: /test_case_success="true"/.test(body),
      body: unescaped(body.replace(/^\s*<(Info|OverallResults).*$/gm, '').trim()),
    }));
}

/** How many cases each file has. @returns {Map<string, number>} */
function countByFile() {
  const { stdout, stderr } = spawnSync(program, ['-ltc', '-r=xml'], { encoding: 'utf8' });
  const counts = new Map();
  for (const [, path] of stdout.matchAll(/<TestCase [^>]*filename="([^"]*)"/g)) {
    const file = path.slice(path.indexOf('tests/unit/'));
    counts.set(file, (counts.get(file) ?? 0) + 1);
  }
  assert.ok(counts.size > 0, `there are cases\n${stdout}${stderr}`);
  return counts;
}

/** What all runs have in common: how they are built, by what, how they are run. */
function surroundings() {
  const hash = createHash('sha256').update(readFileSync(fileURLToPath(import.meta.url)));
  const files = ['CMakeLists.txt', 'src/core.cmake', 'tests/programs.cmake', 'tests/unit/main.cpp',
    'tests/support/cpp_sources.js', 'build/test/configured', ...versions];
  for (const file of files) hash.update(readText(file));
  const libraries = String(spawnSync('ldd', [program]).stdout ?? '').matchAll(/(\/\S+) \(/g);
  for (const [, path] of libraries) hash.update(readFileSync(path));
  const compiler = /CMAKE_CXX_COMPILER:\w+=(.*)/.exec(readText('build/test/CMakeCache.txt'))?.[1];
  return hash.update(spawnSync(compiler ?? '', ['--version']).stdout ?? '').digest();
}

/** Where it is remembered that a file's cases have passed. @returns {string} */
function memoryOf(file, common) {
  // By its name, too: files of tests that share a header reach each other.
  const hash = createHash('sha256').update(common).update(file);
  for (const part of withCallees(file)) hash.update(part).update(readText(part));
  return join(memory, `unit-${hash.digest('hex')}.json`);
}

/** Cases of a file by their numbers, from 1; a crash ends the portion, and is reported. */
function runPortion({ file, first, last }) {
  return new Promise((resolve) => {
    const words = ['-r=xml', `-sf=*${file}`, `--first=${first}`, `--last=${last}`];
    const options = { cwd: root, maxBuffer: 2 ** 28, timeout: longest };
    execFile(program, words, options, (error, stdout, stderr) => {
      const cases = casesIn(stdout);
      const isWhole = cases.length === last - first + 1;
      const isFailed = cases.some(({ passed }) => !passed);
      const crash = { name: `${file}: cases ${first} to ${last} run to their end`, passed: false,
        body: `${error?.message}\n${stderr}\nnpm run sanitize may tell more.` };
      resolve(isWhole && (isFailed || !error) ? cases : [...cases, crash]);
    });
  });
}

/** What is run at a time of a file with so many cases. @param {[string, number]} count */
function portionsOf([file, number]) {
  const size = slowest.includes(file) ? 1 : portion;
  return Array.from({ length: Math.ceil(number / size) }, (_, i) =>
    ({ file, first: i * size + 1, last: Math.min((i + 1) * size, number), cases: [] }));
}

/** The cases of files, in portions. @param {[string, number][]} counts */
async function runAll(counts) {
  const portions = counts.flatMap(portionsOf);
  const isSlow = ({ file }) => slowest.includes(file);
  const waiting = [...portions.filter(isSlow), ...portions.filter((part) => !isSlow(part))]
    .reverse();
  const worker = async () => {
    for (let next = waiting.pop(); next; next = waiting.pop()) {
      next.cases = await runPortion(next);
    }
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  return portions;
}

/** Of each file its cases, and whether they passed before. */
async function verdicts() {
  const common = surroundings();
  const files = [...countByFile()].map(([file, number]) =>
    ({ file, number, memory: memoryOf(file, common) }));
  const unknown = files.filter((file) => !existsSync(file.memory));
  const portions = await runAll(unknown.map(({ file, number }) => [file, number]));
  return files.map((file) => (unknown.includes(file)
    ? { ...file, isKnown: false, cases: portions.filter((part) => part.file === file.file)
      .flatMap(({ cases }) => cases) }
    : { ...file, isKnown: true, cases: JSON.parse(readFileSync(file.memory, 'utf8')) }));
}

test('C++', async (context) => {
  const files = await verdicts();
  mkdirSync(memory, { recursive: true });
  for (const file of files) {
    await context.test(file.file, async (inner) => {
      if (file.isKnown) inner.diagnostic('passed before, and nothing in its reach has changed');
      for (const { name, passed, body } of file.cases) {
        await inner.test(name, () => assert.ok(passed, body));
      }
    });
    const allPassed = file.cases.every(({ passed }) => passed);
    if (!file.isKnown && allPassed) writeFileSync(file.memory, JSON.stringify(file.cases));
  }
});
