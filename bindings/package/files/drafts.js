// SPDX-License-Identifier: MIT
// Files that appear together or not at all. Each is written beside its place under a name that no
// other run uses, and flushed to the disk; then all are moved, without a pause, the main one last.
// A main file alone is replaced by one move: its readers see the old one or the new one whole.
// Where a companion is replaced with it, the old ones go out of the way first, so that whoever is
// killed in between leaves no mixture of old and new.

import { randomBytes } from 'node:crypto';
import {
  closeSync, existsSync, fsync, fsyncSync, linkSync, mkdirSync, openSync, readdirSync, renameSync,
  rmdirSync, rmSync, statSync, write,
} from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { promisify } from 'node:util';

import { isAlive } from './lock.js';
import { codeOf } from './reasons.js';

// Younger ones may be those of a run in another container, whose processes cannot be asked for.
const oldest = 600_000; // milliseconds

/** @typedef {{ place: string, bytes: Uint8Array }} PlacedFile */
/** @typedef {PlacedFile & { path: string }} Draft path: where it is until it is at its place */

/** @param {string} place @param {'part' | 'old'} ending */
function besides(place, ending) {
  const run = `${process.pid}-${randomBytes(4).toString('hex')}`;
  return join(dirname(place), `.${stemOf(place)}.${run}.${ending}`);
}

/** Short enough for what is added to it. @param {string} place */
function stemOf(place) {
  return basename(place).slice(0, 50);
}

/** @param {string} folder @returns {string[]} the folders made, the innermost first */
function makeFolders(folder) {
  const first = mkdirSync(folder, { recursive: true });
  /** @type {string[]} */
  const made = [];
  if (first === undefined) return made;
  for (let at = resolve(folder); at.length >= resolve(first).length; at = dirname(at)) {
    made.push(at);
  }
  return made;
}

/** @param {number} file @param {Uint8Array} bytes */
async function writeAll(file, bytes) {
  for (let at = 0; at < bytes.length;) {
    const { bytesWritten } = await promisify(write)(file, bytes, at, bytes.length - at);
    at += bytesWritten;
  }
  await promisify(fsync)(file);
}

/** Fails if something is there. @param {Draft} draft */
function moveToFree({ path, place }) {
  try {
    linkSync(path, place);
  } catch (error) {
    if (codeOf(error) === 'EEXIST') throw error;
    renameSync(path, place); // a file system without links
    return;
  }
  rmSync(path);
}

/** So that the moves outlive a loss of power, where that can be had. @param {string} folder */
function flushFolder(folder) {
  try {
    const file = openSync(folder, 'r');
    fsyncSync(file);
    closeSync(file);
  } catch {
    return;
  }
}

export class Drafts {
  /** @type {Draft[]} the companions', then the main file's */
  #drafts;
  /** @type {string[]} folders made for them */
  #folders = [];
  /** @type {{ place: string, path: string }[]} what was moved out of the way */
  #aside = [];
  /** @type {string[]} places of companions that were moved there */
  #moved = [];

  /** @param {PlacedFile[]} files the main one last */
  constructor(files) {
    this.#drafts = files.map((file) => ({ ...file, path: besides(file.place, 'part') }));
  }

  /** Each is made at once, so that discard() finds it whenever it is called. */
  async write() {
    for (const { place, path, bytes } of this.#drafts) {
      this.#folders.unshift(...makeFolders(dirname(place)));
      const mode = existsSync(place) ? statSync(place).mode & 0o777 : 0o666;
      const file = openSync(path, 'wx', mode);
      try {
        await writeAll(file, bytes);
      } finally {
        closeSync(file);
      }
    }
  }

  /** To their places, at once. After a failure all is as it was. */
  move() {
    const companions = this.#drafts.slice(0, -1);
    const main = this.#drafts[this.#drafts.length - 1];
    try {
      if (companions.some(({ place }) => existsSync(place))) {
        [main, ...companions].forEach(({ place }) => this.#putAside(place));
      }
      for (const draft of companions) {
        moveToFree(draft);
        this.#moved.push(draft.place);
      }
      renameSync(main.path, main.place);
    } catch (error) {
      this.discard();
      throw error;
    }
    for (const { path } of this.#aside) rmSync(path, { force: true });
    new Set(this.#drafts.map(({ place }) => dirname(place))).forEach(flushFolder);
    [this.#drafts, this.#folders, this.#aside, this.#moved] = [[], [], [], []];
  }

  /** @param {string} place */
  #putAside(place) {
    if (!existsSync(place)) return;
    const path = besides(place, 'old');
    renameSync(place, path);
    this.#aside.push({ place, path });
  }

  /** Nothing is left of them, and what was out of the way is back. Safe to repeat. */
  discard() {
    for (const place of this.#moved) rmSync(place, { force: true });
    for (const { place, path } of this.#aside) renameSync(path, place);
    for (const { path } of this.#drafts) rmSync(path, { force: true });
    for (const folder of this.#folders) {
      try {
        rmdirSync(folder);
      } catch {
        break; // somebody else uses it
      }
    }
    [this.#folders, this.#aside, this.#moved] = [[], [], []];
  }
}

/** @param {string} path */
function isOld(path) {
  const { mtimeMs } = statSync(path, { throwIfNoEntry: false }) ?? { mtimeMs: Date.now() };
  return Date.now() - mtimeMs > oldest;
}

/**
 * Removes what runs that were killed have left of drafts for this place; what cannot be removed
 * does no harm.
 * @param {string} place
 */
export function removeLeftovers(place) {
  try {
    for (const name of readdirSync(dirname(place))) {
      const [, stem, pid] = /^\.(.+)\.(\d+)-[0-9a-f]{8}\.(?:part|old)$/s.exec(name) ?? [];
      if (stem !== stemOf(place) || isAlive(Number(pid))) continue;
      const path = join(dirname(place), name);
      if (isOld(path)) rmSync(path, { force: true });
    }
  } catch {
    return;
  }
}
