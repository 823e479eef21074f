// SPDX-License-Identifier: MIT
// What machines can say about the sources: layout, names, traps, types. What they found good they
// look at again only when something that they read has changed.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';

import { ESLint } from 'eslint';

import { Stamp } from '../bindings/build/stamp.js';
import { clangTidy, complaintsOf, gcc } from './support/cpp_checks.js';
import { filesUnder, root } from './support/tree.js';

/** What all that is JavaScript is read with: each tool, and every package it may look into. */
const packages = ['package.json', 'node_modules/.package-lock.json'];

/** @param {string} tool @param {readonly string[]} files all that it reads, but for packages */
const passedWith = (tool, files) =>
  new Stamp(`build/checks/${tool}-${process.version}`, [...packages, ...files]);

/** The versions of LLVM whose tools agree about these sources: those of Debian 12 and 13. */
const agreeing = ['14', '19'];

/**
 * Other versions have a taste of their own: they are not asked, and that is said.
 * @param {import('node:test').TestContext} t @param {string} tool
 * @returns {string | undefined} which it is, if it is one of them
 */
function agreeingVersion(t, tool) {
  const { stdout } = spawnSync(tool, ['--version'], { encoding: 'utf8' });
  const [, number] = /version (\d+)/.exec(stdout) ?? [];
  if (agreeing.includes(number)) return stdout.trim();
  t.skip(`${tool} is ${number} here; the sources are held to ${agreeing.join(' and ')}`);
  return undefined;
}

test('C++ is laid out as .clang-format says', (t) => {
  const version = agreeingVersion(t, 'clang-format');
  if (!version) return;
  const stamps = new Map(['src', 'bindings', 'tests/fuzz', 'tests/unit']
    .flatMap((folder) => filesUnder(folder, /\.(h|cpp)$/))
    .map((file) => [file, new Stamp(`build/checks/${version}/${file}`,
      ['.clang-format', file])]));
  const files = [...stamps.keys()].filter((file) => !stamps.get(file).isCurrent());
  if (files.length === 0) return;
  const { stderr } = spawnSync('clang-format', ['--dry-run', '--Werror', ...files],
    { cwd: root, encoding: 'utf8' });
  const complaints = stderr.matchAll(/^(\S+?):(\d+):\d+: error/gm);
  const wrong = [...complaints].map(([, file, line]) => `${file}:${line}`);
  assert.deepEqual(wrong, []);
  for (const file of files) stamps.get(file).set();
});

test('C++ passes clang-tidy', async (t) => {
  if (!agreeingVersion(t, 'clang-tidy')) return;
  // But for a library's implementation, which is not ours.
  const files = filesUnder('src', /(?<!tinygltf)\.cpp$/);
  assert.equal(await complaintsOf(clangTidy, files), '');
});

test('C++ compiles with g++ without a warning', async () => {
  // What is built with it: unit tests and fuzzers are clang++'s, which has warned of them by then.
  assert.equal(await complaintsOf(gcc, filesUnder('src', /\.cpp$/)), '');
});

test('JavaScript passes eslint', async () => {
  const stamp = passedWith('eslint', ['bindings', 'examples', 'web', 'tests']
    .flatMap((folder) => filesUnder(folder, /\.js$/)));
  if (stamp.isCurrent()) return;
  const eslint = new ESLint({
    cwd: root, overrideConfigFile: join(root, 'tests/lint/eslint.config.js'),
  });
  const results = await eslint.lintFiles(['bindings/**/*.js', 'examples/**/*.js', 'web/**/*.js',
    'tests/**/*.js']
    .filter((pattern) => filesUnder(pattern.split('/')[0], /\.js$/).length > 0));
  const complaints = results.flatMap(({ filePath, messages }) => messages.map(
    ({ line, message }) => `${filePath.slice(root.length + 1)}:${line} ${message}`));
  assert.deepEqual(complaints, []);
  stamp.set();
});

test('JavaScript passes tsc --strict', () => {
  const stamp = passedWith('tsc', ['tests/lint/tsconfig.json', ...['bindings', 'dist', 'web']
    .flatMap((folder) => filesUnder(folder, /\.(m?[jt]s|json)$/))]);
  if (stamp.isCurrent()) return;
  const tsc = join(root, 'node_modules/typescript-7/bin/tsc');
  const { status, stdout } = spawnSync(tsc, ['-p', 'tests/lint/tsconfig.json'],
    { cwd: root, encoding: 'utf8' });
  assert.equal(status, 0, stdout);
  stamp.set();
});
