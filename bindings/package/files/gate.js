// SPDX-License-Identifier: MIT
// The gate to the file system: reads every file that a model, not the user, names. A model may read
// below one folder, its own or the user's --root: by a plain name (plain_names.js), through no link
// that leads out, only plain files, and no more than a limit. Every other file counts as missing,
// and the reason is kept.

import { constants } from 'node:fs';
import { lstat, open, realpath } from 'node:fs/promises';
import { isAbsolute, join, relative, resolve, sep } from 'node:path';

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { plainPaths } from './plain_names.js';
import { codeOf, kindOf, reason } from './reasons.js';

const gibibyte = 2 ** 30;
/** Bytes that one file may have, and all that one model names together. */
export const limits = { file: gibibyte, together: 2 * gibibyte };

// Reasons are kept for so many files; of the others only their number.
const mostReasons = 10;

/** Both without links. @param {string} folder @param {string} path */
function isBelow(folder, path) {
  const way = relative(folder, path);
  return way !== '' && way !== '..' && !way.startsWith(`..${sep}`) && !isAbsolute(way);
}

/**
 * Reads an open file up to the size it had when it was looked at: it may grow for ever.
 * @param {import('node:fs/promises').FileHandle} handle
 * @param {number} size
 */
async function readWhole(handle, size) {
  const bytes = new Uint8Array(size);
  let length = 0;
  while (length < size) {
    const { bytesRead } = await handle.read(bytes, length, size - length, length);
    if (bytesRead === 0) break;
    length += bytesRead;
  }
  return bytes.subarray(0, length);
}

/** Refused for this reason. */
class Refusal extends Error {}

export class Gate {
  #folder;
  #root;
  #left = limits.together;
  /** @type {Map<string, string>} */
  #reasons = new Map();
  #refused = 0;
  /** @type {string[]} paths of all that was read */
  files = [];

  /**
   * @param {string} folder where the model lies, without links
   * @param {string} root what it may read is below this, without links
   */
  constructor(folder, root) {
    this.#folder = folder;
    this.#root = root;
  }

  /**
   * @param {string} model its path
   * @param {string} [root] its own folder, if not given
   * @returns {Promise<Gate>}
   */
  static async of(model, root) {
    const folder = await realpath(resolve(model, '..'));
    if (root === undefined) return new Gate(folder, folder);
    try {
      const realRoot = await realpath(root);
      const isInside = realRoot === folder || isBelow(realRoot, folder);
      if (isInside && (await lstat(realRoot)).isDirectory()) return new Gate(folder, realRoot);
    } catch (error) {
      throw new RemeshError('INVALID_OPTION', `--root ${legible(root)}: ${reason(error)}.`,
        'Give a folder that holds the model.');
    }
    throw new RemeshError('INVALID_OPTION',
      `--root ${legible(root)} is no folder that holds ${legible(model)}.`,
      'Give one above the model, and above what it refers to.');
  }

  /**
   * The file that a reference means; undefined if it is not there or may not be read.
   * @param {string} reference
   * @returns {Promise<Uint8Array | undefined>}
   */
  async read(reference) {
    try {
      for (const path of this.#pathsOf(reference)) {
        const bytes = await this.#readPath(path);
        if (bytes) return bytes;
      }
    } catch (error) {
      this.#refused += 1;
      const why = error instanceof Refusal ? error.message : reason(error);
      if (this.#reasons.size < mostReasons) this.#reasons.set(reference, why);
    }
    return undefined;
  }

  /** Sentences on all that was refused, and why. @returns {string[]} */
  refusals() {
    const sentences = Array.from(this.#reasons, ([reference, why]) =>
      `${legible(reference)} is not read: ${why}.`);
    const others = this.#refused - this.#reasons.size;
    return others > 0 ? [...sentences, `${others} more files are not read.`] : sentences;
  }

  /** @param {string} reference */
  #pathsOf(reference) {
    const range = this.#root === this.#folder ? 'stays' : 'climbs';
    const { paths, why } = plainPaths(reference, range);
    if (!paths) throw new Refusal(why);
    return paths;
  }

  /** @param {string} path from the model's folder @returns {Promise<Uint8Array | undefined>} */
  async #readPath(path) {
    const place = join(this.#folder, path);
    if (!isBelow(this.#root, place)) throw new Refusal('it lies outside of what may be read');
    const real = await realpath(place).catch((error) => {
      if (['ENOENT', 'ENOTDIR', 'ENAMETOOLONG'].includes(codeOf(error))) return undefined;
      throw error;
    });
    if (real === undefined) return undefined;
    if (!isBelow(this.#root, real)) throw new Refusal('a link leads out of what may be read');
    return this.#readReal(real);
  }

  /**
   * Looks at the file before opening it, since opening a pipe or a device may wait or do something;
   * and again afterwards, since the file may have been exchanged.
   * @param {string} real
   */
  async #readReal(real) {
    const before = await lstat(real);
    this.#require(before);
    const { O_RDONLY, O_NOFOLLOW = 0, O_NONBLOCK = 0 } = constants;
    const handle = await open(real, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    try {
      const stats = await handle.stat();
      this.#require(stats);
      const isSame = stats.ino === before.ino && stats.dev === before.dev
        && await realpath(real) === real;
      if (!isSame) throw new Refusal('it changes while it is read');
      this.#left -= stats.size;
      this.files.push(real);
      return await readWhole(handle, stats.size);
    } finally {
      await handle.close();
    }
  }

  /** @param {import('node:fs').Stats} stats */
  #require(stats) {
    if (!stats.isFile()) throw new Refusal(`it is ${kindOf(stats)}`);
    if (stats.size > limits.file) {
      throw new Refusal(`it has ${stats.size} bytes, and ${limits.file} (1 GiB) is the limit`);
    }
    if (stats.size > this.#left) {
      throw new Refusal(`with it, what the model names has over ${limits.together} bytes (2 GiB)`);
    }
  }
}
