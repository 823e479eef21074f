// SPDX-License-Identifier: MIT
// Lets one run at a time write the several files of one output: a second run waits. The lock is a
// file beside the output that names its owner; a lock whose owner is gone is taken away.

import { randomBytes } from 'node:crypto';
import {
  closeSync, linkSync, openSync, readFileSync, renameSync, rmSync, statSync, writeSync,
} from 'node:fs';
import { hostname } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { codeOf } from './reasons.js';

const patience = 30_000; // milliseconds
const step = 20;
// An owner on another machine cannot be asked whether it lives; no run writes for so long.
const oldest = 600_000;
// Only microseconds pass between making the file and writing the owner into it.
const oldestWithoutOwner = 2_000;

/** @param {number} pid */
export function isAlive(pid) {
  try {
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return codeOf(error) !== 'ESRCH';
  }
}

/** The lock's owner; undefined: the lock was released meanwhile. @param {string} path */
function ownerOf(path) {
  try {
    const stats = statSync(path);
    if (!stats.isFile()) return { text: 'not ours', age: 0 }; // reading a pipe would wait
    return { text: readFileSync(path, 'utf8'), age: Date.now() - stats.mtimeMs };
  } catch {
    return undefined;
  }
}

/** @param {{ text: string, age: number }} owner */
function isGone({ text, age }) {
  if (age > oldest) return true;
  if (text === '') return age > oldestWithoutOwner;
  const [pid, host] = text.split(' ');
  return host === hostname() && !isAlive(Number(pid));
}

/**
 * Moves the lock aside first: another run may have taken it away, and locked anew.
 * @param {string} path
 * @param {string} text of the owner that is gone
 */
function takeAway(path, text) {
  const aside = `${path}.${randomBytes(4).toString('hex')}`;
  try {
    renameSync(path, aside);
    if (readFileSync(aside, 'utf8') !== text) linkSync(aside, path);
  } catch {
    return;
  } finally {
    rmSync(aside, { force: true });
  }
}

/** @param {string} path @returns {boolean} whether it is ours now */
function tryLock(path) {
  try {
    const file = openSync(path, 'wx');
    writeSync(file, `${process.pid} ${hostname()} ${randomBytes(8).toString('hex')}`);
    closeSync(file);
    return true;
  } catch (error) {
    if (codeOf(error) === 'EEXIST') return false;
    throw error;
  }
}

export class Lock {
  #output;
  #path;
  #isOurs = false;

  /** @param {string} output */
  constructor(output) {
    this.#output = output;
    this.#path = join(dirname(output), `.${basename(output).slice(0, 50)}.lock`);
  }

  /** Waits until it is ours. */
  async acquire() {
    for (let waited = 0; !(this.#isOurs = tryLock(this.#path)); waited += step) {
      const owner = ownerOf(this.#path);
      if (owner && isGone(owner)) takeAway(this.#path, owner.text);
      else if (waited < patience) await sleep(step);
      else {
        throw new RemeshError('OUTPUT_UNWRITABLE',
          `${legible(this.#output)} cannot be written: another run is writing it.`,
          `If none is, remove ${legible(this.#path)}.`);
      }
    }
  }

  /** Safe to repeat. */
  release() {
    if (this.#isOurs) rmSync(this.#path, { force: true });
    this.#isOurs = false;
  }
}
