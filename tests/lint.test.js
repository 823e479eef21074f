// SPDX-License-Identifier: MIT
// What machines can say about the sources: layout, names, traps, types.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';

import { ESLint } from 'eslint';

import { clangTidy, complaintsOf, gcc } from './support/cpp_checks.js';
import { filesUnder, root } from './support/tree.js';

test('C++ is laid out as .clang-format says', () => {
  const files = ['src', 'bindings', 'tests/fuzz', 'tests/unit']
    .flatMap((folder) => filesUnder(folder, /\.(h|cpp)$/));
  const { stderr } = spawnSync('clang-format', ['--dry-run', '--Werror', ...files],
    { cwd: root, encoding: 'utf8' });
  const complaints = stderr.matchAll(/^(\S+?):(\d+):\d+: error/gm);
  const wrong = [...complaints].map(([, file, line]) => `${file}:${line}`);
  assert.deepEqual(wrong, []);
});

test('C++ passes clang-tidy', async () => {
  // But for a library's implementation, which is not ours.
  const files = filesUnder('src', /(?<!tinygltf)\.cpp$/);
  assert.equal(await complaintsOf(clangTidy, files), '');
});

test('C++ compiles with g++ without a warning', async () => {
  const files = ['src', 'tests/fuzz', 'tests/unit']
    .flatMap((folder) => filesUnder(folder, /\.cpp$/));
  assert.equal(await complaintsOf(gcc, files), '');
});

test('JavaScript passes eslint', async () => {
  const eslint = new ESLint({
    cwd: root, overrideConfigFile: join(root, 'tests/lint/eslint.config.js'),
  });
  const results = await eslint.lintFiles(['bindings/**/*.js', 'examples/**/*.js', 'web/**/*.js',
    'tests/**/*.js']
    .filter((pattern) => filesUnder(pattern.split('/')[0], /\.js$/).length > 0));
  const complaints = results.flatMap(({ filePath, messages }) => messages.map(
    ({ line, message }) => `${filePath.slice(root.length + 1)}:${line} ${message}`));
  assert.deepEqual(complaints, []);
});

test('JavaScript passes tsc --strict', () => {
  const tsc = join(root, 'node_modules/typescript-7/bin/tsc');
  const { status, stdout } = spawnSync(tsc, ['-p', 'tests/lint/tsconfig.json'],
    { cwd: root, encoding: 'utf8' });
  assert.equal(status, 0, stdout);
});
