// SPDX-License-Identifier: MIT
// Remembers the test files that have passed. A test file is not run again while the files that it
// can read and the programs are the same.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { findChromium } from '../../bindings/build/needs.js';
import { thisSystem } from '../../bindings/build/system.js';
import { readings } from './readings.js';
import { filesUnder, readText, root } from './tree.js';

const memory = join(root, 'build/checks');
/** Programs and a library built from the checkout. */
const made = ['build/test/unit_tests', 'build/test/fuzz_replay', 'build/test/libremesher.a'];
/** Files that every test reads without naming them: npm packages, and Node's first import. */
const everywhere = ['node_modules/.package-lock.json', 'tests/support/late_tiering.js'];

const isThere = (/** @type {string} */ file) => existsSync(join(root, file));

/** Every file of the checkout, by git, which knows the ignored files. */
function checkout() {
  const words = ['ls-files', '-z', '--cached', '--others', '--exclude-standard'];
  const { stdout } = spawnSync('git', words, { cwd: root, encoding: 'utf8' });
  return stdout.split('\0').filter((file) => file && isThere(file));
}

/** The versions of the programs that tests start. */
function programs() {
  const chromium = findChromium(thisSystem());
  return [process.version, process.platform, process.arch,
    chromium ? `${chromium} ${statSync(chromium).size} ${statSync(chromium).mtimeMs}` : ''];
}

/**
 * The file that records the pass of each test file.
 * @param {readonly string[]} files
 * @returns {Map<string, string> | undefined} undefined without git
 */
function memories(files) {
  const parts = checkout();
  if (parts.length === 0) return undefined;
  const common = everywhere.filter(isThere);
  const readingsOf =
    readings([...parts, ...filesUnder('dist', /./), ...made.filter(isThere)], readText);
  /** @type {Map<string, string>} */
  const prints = new Map();
  const printOf = (/** @type {string} */ file) => {
    if (!prints.has(file)) {
      const bytes = readFileSync(join(root, file));
      prints.set(file, createHash('sha256').update(bytes).digest('hex'));
    }
    return `${file} ${prints.get(file)}`;
  };
  const place = (/** @type {string} */ file) => {
    const read = [...common, ...readingsOf(file)].map(printOf);
    const whole = [...programs(), file, ...read].join('\n');
    return join(memory, `passed-${createHash('sha256').update(whole).digest('hex')}`);
  };
  return new Map(files.map((file) => [file, place(file)]));
}

/**
 * @param {readonly string[]} files of tests
 * @returns {{ unknown: string[], remember: (file: string) => void }} unknown: the files to run;
 *   remember: to be called for each file that passed
 */
export function remembered(files) {
  const places = memories(files);
  if (!places) return { unknown: [...files], remember: () => {} };
  return {
    unknown: files.filter((file) => !existsSync(/** @type {string} */ (places.get(file)))),
    remember: (file) => {
      mkdirSync(memory, { recursive: true });
      const place = places.get(file);
      if (place) writeFileSync(place, '');
    },
  };
}
