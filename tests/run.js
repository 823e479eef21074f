// SPDX-License-Identifier: MIT
// Runs test files side by side:
//   node tests/run.js               all of them, but those that could only pass again, linters and
//                                   integration
//   node tests/run.js --again       all of them but linters and integration
//   node tests/run.js page gltf     those whose paths contain one of the words
// Node's own runner leaves one core idle, which is half of a machine with two. Two files more than
// there are cores run at a time, for those of the page often wait. The files that take longest
// begin first.
import { availableParallelism } from 'node:os';
import { basename, join } from 'node:path';
import { run } from 'node:test';
import { spec } from 'node:test/reporters';
import { parseArgs } from 'node:util';

import { remembered } from './support/remembered.js';
import { filesUnder, root } from './support/tree.js';

/** No file takes half as long, even beside others: what does hangs. In milliseconds. */
const longestRun = 900_000;

/** Minutes that only who changes the sources (`npm run lint`) or what the page shows, or publishes
 * the package (`npm run integration`), need spend. */
const onlyAsked = /lint(_cpp)?\.test|^tests\/integration\//;

/**
 * Those of eight seconds and more; the last to end is one of the short ones. The first that needs
 * the page builds it, while others run that do not.
 */
const longest = ['lint_cpp', 'unit', 'web_everyone', 'lint', 'web_doors', 'web_guides', 'faults',
  'web_see', 'web_out', 'web_steer', 'rendering', 'web_kept', 'web_large', 'web_same',
  'web_paint', 'web_in', 'web', 'repair', 'quads', 'web_trust', 'laws', 'package', 'site',
  'readme', 'fuzz', 'bake', 'sizes'];
const rank = (/** @type {string} */ file) => {
  const at = longest.indexOf(basename(file, '.test.js'));
  return at < 0 ? longest.length : at;
};

const { values, positionals: words } = parseArgs({
  options: { again: { type: 'boolean' } }, allowPositionals: true,
});
const files = filesUnder('tests', /\.test\.js$/)
  .filter((file) => (words.length === 0 ? !onlyAsked.test(file)
    : words.some((word) => file.includes(word))))
  .sort((a, b) => rank(a) - rank(b));
if (files.length === 0) {
  console.error(`No test file has one of these in its path: ${words.join(' ')}`);
  process.exit(1);
}

const { unknown, remember } = remembered(files);
const chosen = values.again || words.length > 0 ? files : unknown;
if (chosen.length < files.length) {
  console.log(`${files.length - chosen.length} of ${files.length} test files passed before, and `
    + 'nothing that they read has changed (npm test -- --again runs all)');
}
/** Paths; and whatever failed without one, in whose company nothing is remembered. */
const failed = new Set();
const passed = () => {
  const paths = chosen.map((file) => join(root, file));
  if ([...failed].some((path) => !paths.includes(path))) return [];
  return chosen.filter((file) => !failed.has(join(root, file)));
};

if (chosen.length > 0) {
  const { href } = new URL('./support/late_tiering.js', import.meta.url);
  process.env.NODE_OPTIONS = `${process.env.NODE_OPTIONS ?? ''} --import ${href}`.trim();
  run({ files: chosen.map((file) => join(root, file)), concurrency: availableParallelism() + 2,
    timeout: longestRun })
    .on('test:fail', ({ file, name }) => {
      process.exitCode = 1;
      failed.add(file ?? name);
    })
    .on('end', () => passed().forEach(remember))
    .compose(spec)
    .pipe(process.stdout);
}
