// SPDX-License-Identifier: MIT
// The build's messages and other programs: one line per step on standard error, and the output of a
// program only if it failed.
import { spawn, spawnSync } from 'node:child_process';
import { constants, getPriority, setPriority } from 'node:os';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

/** An error that the user can mend: the message says how. */
export class BuildError extends Error {}

/** @param {string} text */
export function say(text) {
  process.stderr.write(`${text}\n`);
}

/**
 * @param {string} command
 * @param {readonly string[]} words
 * @param {{ givesWay?: boolean }} [options] givesWay: runs at a lower priority than other programs
 * @returns {Promise<string>} its output
 */
export function run(command, words, { givesWay = false } = {}) {
  return new Promise((resolve, reject) => {
    // On Windows npm and similar programs are scripts, which only a shell can start.
    const child = spawn(command, words, { cwd: root, shell: process.platform === 'win32' });
    if (givesWay && child.pid) {
      const { PRIORITY_LOW, PRIORITY_BELOW_NORMAL } = constants.priority;
      setPriority(child.pid, Math.min(getPriority() + PRIORITY_BELOW_NORMAL, PRIORITY_LOW));
    }
    let printed = '';
    for (const stream of [child.stdout, child.stderr]) {
      stream.setEncoding('utf8').on('data', (text) => { printed += text; });
    }
    child.on('error', ({ message }) =>
      reject(new BuildError(`${command} cannot be started: ${message}`)));
    child.on('close', (status) => {
      if (status === 0) resolve(printed);
      else reject(new BuildError(`${command} ${words.join(' ')}\n${printed}`));
    });
  });
}

/**
 * The trimmed output of a short program; '' if the program is missing or fails.
 * @param {string} command
 * @param {readonly string[]} words
 */
export function ask(command, words) {
  const { status, stdout } = spawnSync(command, words, { cwd: root, encoding: 'utf8' });
  return status === 0 ? stdout.trim() : '';
}
