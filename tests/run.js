// SPDX-License-Identifier: MIT
// Runs test files side by side, as many at a time as there are cores:
//   node tests/run.js               all of them
//   node tests/run.js web gltf      those whose names contain one of the words
// Node's own runner leaves one core idle, which is half of a machine with two. The files that take
// longest begin first.
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { run } from 'node:test';
import { spec } from 'node:test/reporters';

import { filesUnder, root } from './support/tree.js';

const longest = ['unit', 'lint', 'gltf', 'quality', 'package', 'rendering', 'web'];
const rank = (/** @type {string} */ file) => {
  const at = longest.findIndex((name) => file === `tests/${name}.test.js`);
  return at < 0 ? longest.length : at;
};

const words = process.argv.slice(2);
const files = filesUnder('tests', /^tests\/\w+\.test\.js$/)
  .filter((file) => words.length === 0 || words.some((word) => file.includes(word)))
  .sort((a, b) => rank(a) - rank(b));
if (files.length === 0) {
  console.error(`No test file has one of these in its name: ${words.join(' ')}`);
  process.exit(1);
}

run({ files: files.map((file) => join(root, file)), concurrency: availableParallelism() })
  .on('test:fail', () => { process.exitCode = 1; })
  .compose(spec)
  .pipe(process.stdout);
