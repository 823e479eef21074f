// SPDX-License-Identifier: MIT
// What machines can say about the sources in seconds: layout, names, traps, types; what takes them
// minutes is in lint_cpp. What they found good they look at again only when something that they
// read has changed.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';

import { ESLint } from 'eslint';

import { Stamp } from '../../bindings/build/stamp.js';
import { agreeingVersion } from '../support/llvm.js';
import { filesUnder, root } from '../support/tree.js';

/** What all that is JavaScript is read with: each tool, and every package it may look into. */
const packages = ['package.json', 'node_modules/.package-lock.json'];

/** @param {string} tool @param {readonly string[]} files all that it reads, but for packages */
const passedWith = (tool, files) =>
  new Stamp(`build/checks/${tool}-${process.version}`, [...packages, ...files]);

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
