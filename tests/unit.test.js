// SPDX-License-Identifier: MIT
// The C++ unit tests, built natively with sanitizers: each of their cases is a case here. They run
// in portions, one at a time per core. Cases depend on the program alone, so what the very same one
// has passed is not run again.
import assert from 'node:assert/strict';
import { execFile, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { root } from './support/tree.js';

const program = join(root, 'build/test/unit_tests');
const portion = 6;

const unescaped = (text) => text.replace(/&(quot|lt|gt|apos|amp);/g,
  (_, name) => ({ quot: '"', lt: '<', gt: '>', apos: "'", amp: '&' })[name]);

/** Name and verdict of every case in doctest's XML. */
function casesIn(xml) {
  return [...xml.matchAll(/<TestCase name="([^"]*)"[^>]*>(.*?)<\/TestCase>/gs)].map(
    ([, name, body]) => ({
      name: unescaped(name),
      passed: /test_case_success="true"/.test(body),
      body: unescaped(body.replace(/^\s*<(Info|OverallResults).*$/gm, '').trim()),
    }));
}

/** A file's name from all that a run depends on: program, libraries, sanitizers' options, this. */
function memoryOf() {
  const libraries = String(spawnSync('ldd', [program]).stdout ?? '').matchAll(/(\/\S+) \(/g);
  const hash = createHash('sha256').update(process.env.ASAN_OPTIONS ?? '')
    .update(process.env.UBSAN_OPTIONS ?? '');
  const self = fileURLToPath(import.meta.url);
  for (const file of [self, program, ...[...libraries].map(([, path]) => path)]) {
    hash.update(readFileSync(file));
  }
  return join(root, 'build/checks', `unit-${hash.digest('hex')}.json`);
}

/** How many cases there are. */
function count() {
  const { stdout, stderr } = spawnSync(program, ['--count'], { encoding: 'utf8' });
  const number = Number(/: (\d+)\s*$/m.exec(stdout)?.[1]);
  assert.ok(number > 0, `there are cases\n${stdout}${stderr}`);
  return number;
}

/** Cases by their numbers, from the first, which is 1; a crash ends the portion, and is told. */
function runPortion(first, last) {
  return new Promise((resolve) => {
    const words = ['-r=xml', `--first=${first}`, `--last=${last}`];
    execFile(program, words, { cwd: root, maxBuffer: 2 ** 28 }, (error, stdout, stderr) => {
      const cases = casesIn(stdout);
      const isWhole = cases.length === last - first + 1;
      const isFailed = cases.some(({ passed }) => !passed);
      const crash = { name: `cases ${first} to ${last} run to their end`, passed: false,
        body: `${error?.message}\n${stderr}` };
      resolve(isWhole && (isFailed || !error) ? cases : [...cases, crash]);
    });
  });
}

async function runAll() {
  const number = count();
  const portions = [];
  for (let first = 1; first <= number; first += portion) {
    portions.push({ first, last: Math.min(first + portion - 1, number), cases: [] });
  }
  const waiting = [...portions].reverse();
  const worker = async () => {
    for (let next = waiting.pop(); next; next = waiting.pop()) {
      next.cases = await runPortion(next.first, next.last);
    }
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  return portions.flatMap(({ cases }) => cases);
}

test('C++', async (context) => {
  const memory = memoryOf();
  const isKnown = existsSync(memory);
  const cases = isKnown ? JSON.parse(readFileSync(memory, 'utf8')) : await runAll();
  if (isKnown) context.diagnostic('passed before by this very program, not run again');
  for (const { name, passed, body } of cases) {
    await context.test(name, () => assert.ok(passed, body));
  }
  if (isKnown || cases.some(({ passed }) => !passed)) return;
  mkdirSync(join(root, 'build/checks'), { recursive: true });
  writeFileSync(memory, JSON.stringify(cases));
});
