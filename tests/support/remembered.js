// SPDX-License-Identifier: MIT
// Which test files have passed before, with the very same files to read and the same programs: they
// are not run again.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { findChromium } from '../../bindings/build/needs.js';
import { thisSystem } from '../../bindings/build/system.js';
import { readings } from './readings.js';
import { filesUnder, readText, root } from './tree.js';

const memory = join(root, 'build/checks');
/** Programs that are made of the checkout. */
const made = ['build/test/unit_tests', 'build/test/fuzz_replay', 'build/test/libremesher.a'];
/** What every test reads without saying so: packages, and what Node starts the files with. */
const everywhere = ['node_modules/.package-lock.json', 'tests/support/late_tiering.js'];

const isThere = (/** @type {string} */ file) => existsSync(join(root, file));

/** Every file of the checkout, by git, which knows what is ignored. */
function checkout() {
  const words = ['ls-files', '-z', '--cached', '--others', '--exclude-standard'];
  const { stdout } = spawnSync('git', words, { cwd: root, encoding: 'utf8' });
  return stdout.split('\0').filter((file) => file && isThere(file));
}

/** The programs that tests start, by what tells one version from another. */
function programs() {
  const chromium = findChromium(thisSystem());
  return [process.version, process.platform, process.arch,
    chromium ? `${chromium} ${statSync(chromium).size} ${statSync(chromium).mtimeMs}` : ''];
}

/**
 * Where it is remembered that a test file has passed.
 * @param {readonly string[]} files
 * @returns {Map<string, string> | undefined} nothing where git is not there to ask
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
 * @returns {{ unknown: string[], remember: (file: string) => void }} those to run, and who is told
 *   which of them passed
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
