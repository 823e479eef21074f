// SPDX-License-Identifier: MIT
// Which test files have passed before, on the very same checkout, packages and programs: nothing
// that they read has changed, so they are not run again.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { findChromium } from '../../bindings/build/needs.js';
import { thisSystem } from '../../bindings/build/system.js';
import { filesUnder, root } from './tree.js';

const memory = join(root, 'build/checks');
/** What is not the checkout, but is made of it or is found on the machine. */
const made = ['dist', 'build/test/unit_tests', 'build/test/fuzz_replay',
  'node_modules/.package-lock.json'];

/** Every file of the checkout, by git, which knows what is ignored. */
function checkout() {
  const words = ['ls-files', '-z', '--cached', '--others', '--exclude-standard'];
  const { stdout } = spawnSync('git', words, { cwd: root, encoding: 'utf8' });
  return stdout.split('\0').filter((file) => file && existsSync(join(root, file)));
}

/** The programs that tests start, by what tells one version from another. */
function programs() {
  const chromium = findChromium(thisSystem());
  return [process.version, process.platform, process.arch,
    chromium ? `${chromium} ${statSync(chromium).size} ${statSync(chromium).mtimeMs}` : ''];
}

/**
 * Where it is remembered that a test file has passed. Other test files have no part in it.
 * @param {readonly string[]} files
 * @returns {Map<string, string> | undefined} nothing where git is not there to ask
 */
function memories(files) {
  const common = createHash('sha256').update(programs().join('\n'));
  const parts = checkout();
  if (parts.length === 0) return undefined;
  const isTest = (/** @type {string} */ file) => /^tests\/\w+\.test\.js$/.test(file);
  const found = made.flatMap((path) => (existsSync(join(root, path)) ? [path] : []))
    .flatMap((path) => (statSync(join(root, path)).isDirectory() ? filesUnder(path, /./) : [path]));
  for (const file of [...parts.filter((part) => !isTest(part)), ...found]) {
    common.update(`\n${file}\n`).update(readFileSync(join(root, file)));
  }
  return new Map(files.map((file) => [file, join(memory, `passed-${
    common.copy().update(`\n${file}\n`).update(readFileSync(join(root, file))).digest('hex')}`)]));
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
