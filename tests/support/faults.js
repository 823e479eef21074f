// SPDX-License-Identifier: MIT
// Faults around a run: full or read-only disks, and processes that are killed at any moment.
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

/** Runs the command line. @returns the outcome after its end */
export function run(folder, ...words) {
  return spawnSync(process.execPath, [cli, ...words], { cwd: folder, encoding: 'utf8' });
}

/** Runs the command line with a limit to the length of each file, which acts like a full disk. */
export function runLimited(folder, kibibytes, words) {
  const command = `trap '' XFSZ; ulimit -f ${kibibytes}; exec "$@"`;
  return spawnSync('bash', ['-c', command, 'bash', process.execPath, cli, ...words],
    { cwd: folder, encoding: 'utf8' });
}

/** Runs the command line's work in this process, for tests that need only the outcome. */
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

/** A module that copies the folder WITNESSED into COPIES before each call that opens, links,
 * renames or removes a file. */
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
 * One run, and the states in which a SIGKILL before each change would leave a folder: SIGKILL ends
 * a process between two changes, and the process can do nothing more.
 * @returns {string[]} folders, in the order of the changes; `folder` itself has the last state
 */
export function statesDuring(cwd, words, folder) {
  const copies = mkdtempSync(join(dirname(folder), 'states-'));
  const { status, stderr } = spawnSync(process.execPath, ['--import', witness, cli, ...words],
    { cwd, encoding: 'utf8', timeout: 120_000, stdio: ['ignore', 'ignore', 'pipe'],
      env: { ...process.env, WITNESSED: folder, COPIES: copies } });
  assert.equal(status, 0, stderr);
  return Array.from(readdirSync(copies), (_, i) => join(copies, String(i)));
}

/** A module that sends SIGTERM to its own process just before it removes the lock. */
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

/** Runs, and gets SIGTERM between the last change and the removal of the lock. */
export function endedAtUnlock(cwd, words) {
  return spawnSync(process.execPath, ['--import', endAtUnlock, cli, ...words], { cwd });
}

/**
 * Runs, and sends `signal` `after` milliseconds from the start, or from the first change in the
 * folder `since`.
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

/** The names and contents of all files in a folder. */
export function snapshot(folder) {
  return Object.fromEntries(readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
    .sort()
    .map((path) => [path.slice(folder.length + 1), readFileSync(path, 'latin1')]));
}

/** Mounts a small separate file system; undefined if that is not allowed. `freeze` makes it
 * read-only, `undo` unmounts it. */
export function mountSmall(folder, size) {
  mkdirSync(folder, { recursive: true });
  const { status } = spawnSync('mount', ['-t', 'tmpfs', '-o', `size=${size}`, 'tmpfs', folder]);
  if (status !== 0) return undefined;
  return {
    freeze: () => spawnSync('mount', ['-o', 'remount,ro', folder]),
    undo: () => spawnSync('umount', [folder]),
  };
}

/** A folder in which no user can write, not even root. */
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

/** Marsaglia's xorshift: pseudo-random numbers from 0 to 1, the same every time. */
export function randomFrom(seed) {
  let state = seed;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}
