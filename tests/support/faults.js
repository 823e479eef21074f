// SPDX-License-Identifier: MIT
// What can go wrong around a run: disks that are full or may not be written, processes that are
// killed at any moment.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { chmodSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, watch } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';

import * as api from 'remesher';

import { parseCommandLine } from '../../dist/cli/cli_arguments.js';
import { runFile } from '../../dist/cli/run_file.js';
import { root } from './tree.js';

const cli = join(root, 'dist/cli/cli.js');

/** @returns the outcome, all at once */
export function run(folder, ...words) {
  return spawnSync(process.execPath, [cli, ...words], { cwd: folder, encoding: 'utf8' });
}

/** The same with a limit to the length of each file, which works as a full disk does. */
export function runLimited(folder, kibibytes, words) {
  const command = `trap '' XFSZ; ulimit -f ${kibibytes}; exec "$@"`;
  return spawnSync('bash', ['-c', command, 'bash', process.execPath, cli, ...words],
    { cwd: folder, encoding: 'utf8' });
}

/** The same in this process, where the outcome alone matters. */
export function runHere(folder, ...words) {
  const { inputs: [input], output, ...line } = parseCommandLine(words);
  return runFile({ ...line, input: join(folder, input), output: join(folder, output),
    outputName: basename(output) }, api, { worker: false });
}

export function start(folder, ...words) {
  const child = spawn(process.execPath, [cli, ...words], { cwd: folder, stdio: 'ignore' });
  const ended = new Promise((resolve) =>
    child.on('exit', (status, signal) => resolve({ status, signal })));
  return { child, ended };
}

/** What copies a folder before each change to the names in one; both are told by variables. */
const witness = `data:text/javascript,${encodeURIComponent(`
  import { execFileSync } from 'node:child_process';
  import fs from 'node:fs';
  import { syncBuiltinESMExports } from 'node:module';
  let count = 0;
  for (const name of ['linkSync', 'renameSync', 'rmSync', 'openSync']) {
    const whole = fs[name];
    fs[name] = (...words) => {
      execFileSync('cp', ['-a', process.env.WITNESSED, process.env.COPIES + '/' + count]);
      count += 1;
      return whole(...words);
    };
  }
  syncBuiltinESMExports();
`)}`;

/**
 * One run, and what a SIGKILL would leave of a folder before each of the changes to it: that kills
 * between two of them and lets the process do nothing more.
 * @returns {string[]} folders, in the order of the changes; that folder itself is as at the end
 */
export function statesDuring(cwd, words, folder) {
  const copies = mkdtempSync(join(dirname(folder), 'states-'));
  const { status, stderr } = spawnSync(process.execPath, ['--import', witness, cli, ...words],
    { cwd, encoding: 'utf8', timeout: 120_000, stdio: ['ignore', 'ignore', 'pipe'],
      env: { ...process.env, WITNESSED: folder, COPIES: copies } });
  assert.equal(status, 0, stderr);
  return Array.from(readdirSync(copies), (_, i) => join(copies, String(i)));
}

/** What asks the process to end at the moment when it is about to unlock. */
const endAtUnlock = `data:text/javascript,${encodeURIComponent(`
  import fs from 'node:fs';
  import { syncBuiltinESMExports } from 'node:module';
  const remove = fs.rmSync;
  fs.rmSync = (path, ...words) => {
    if (String(path).endsWith('.lock')) process.kill(process.pid, 'SIGTERM');
    return remove(path, ...words);
  };
  syncBuiltinESMExports();
`)}`;

/** Runs, and gets a signal between the last change and the end of the lock. */
export function endedAtUnlock(cwd, words) {
  return spawnSync(process.execPath, ['--import', endAtUnlock, cli, ...words], { cwd });
}

/**
 * Runs, and sends a signal at a moment: after so many milliseconds, or so many after the first
 * change in a folder.
 */
export async function interrupted(folder, words, { signal, after, since }) {
  const { child, ended } = start(folder, ...words);
  const watcher = since && watch(since);
  if (watcher) {
    await Promise.race([new Promise((resolve) => watcher.once('change', resolve)), ended]);
  }
  await Promise.race([sleep(after), ended]);
  child.kill(signal);
  watcher?.close();
  return ended;
}

/** Names and contents. */
export function snapshot(folder) {
  return Object.fromEntries(readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
    .sort()
    .map((path) => [path.slice(folder.length + 1), readFileSync(path, 'latin1')]));
}

/** A file system of its own, where that may be made; tells how to make it read-only and undo it. */
export function mountSmall(folder, size) {
  mkdirSync(folder, { recursive: true });
  const { status } = spawnSync('mount', ['-t', 'tmpfs', '-o', `size=${size}`, 'tmpfs', folder]);
  if (status !== 0) return undefined;
  return {
    freeze: () => spawnSync('mount', ['-o', 'remount,ro', folder]),
    undo: () => spawnSync('umount', [folder]),
  };
}

/** A folder in which nothing can be written, whoever asks. */
export function makeReadOnly(folder) {
  const mounted = mountSmall(folder, '64k');
  if (mounted) {
    mounted.freeze();
    return { folder, undo: mounted.undo };
  }
  if (process.getuid?.() === 0) return { folder: '/proc', undo() {} };
  chmodSync(folder, 0o555);
  return { folder, undo: () => chmodSync(folder, 0o755) };
}

/** Marsaglia's xorshift: numbers from 0 to 1, the same every time. */
export function randomFrom(seed) {
  let state = seed;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}
