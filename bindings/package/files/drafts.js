// SPDX-License-Identifier: MIT
// Files that appear together or not at all. Each is written beside its place under a name that no
// other run uses, and flushed to the disk; then all are moved, without a pause, the main one last.
// A main file alone is replaced by one move: its readers see the old one or the new one whole.
// Where a companion is replaced too, the new main file comes twice. The first one refers to the new
// companion by another name, under which the companion is there already. The final one follows once
// the companion is at its place. So a run that is killed in between leaves a whole output.

import { randomBytes } from 'node:crypto';
import {
  closeSync, copyFileSync, existsSync, fsync, fsyncSync, linkSync, openSync, readdirSync,
  renameSync, rmSync, statSync, write,
} from 'node:fs';
import { basename, dirname, extname, join, relative, sep } from 'node:path';
import { promisify } from 'node:util';

import { makeFolders, removeEmptyFolders } from './folders.js';
import { isAlive } from './lock.js';
import { withOtherNames } from './other_names.js';
import { codeOf } from './reasons.js';

// Younger drafts may be those of a run in another container, whose processes cannot be asked for.
const oldest = 600_000; // milliseconds

/** @typedef {{ place: string, bytes: Uint8Array }} PlacedFile */
/** @typedef {PlacedFile & { path: string }} Draft path: where it is until it is at its place */

const ourRun = () => `${process.pid}-${randomBytes(4).toString('hex')}`;

/** @param {string} place @param {'part' | 'old'} ending */
function besides(place, ending) {
  return join(dirname(place), `.${stemOf(place)}.${ourRun()}.${ending}`);
}

/** Not hidden, since a model may not name hidden files. @param {string} place */
function otherPlace(place) {
  const ending = extname(place);
  const stem = basename(place, ending).slice(0, 50);
  return join(dirname(place), `${stem}.${ourRun()}.part${ending}`);
}

/** The names by which a main file may still call a companion. @param {string} place */
export function otherNamePattern(place) {
  const ending = extname(place);
  const stem = basename(place, ending).slice(0, 50);
  const [before, after] = [stem, ending].map((part) => part.replace(/[^\w]/g, '\\$&'));
  return new RegExp(`${before}\\.(\\d+)-[0-9a-f]{8}\\.part${after}`);
}

/** The name, cut so short that endings can be added. @param {string} place */
function stemOf(place) {
  return basename(place).slice(0, 50);
}

/** @param {number} file @param {Uint8Array} bytes */
async function writeAll(file, bytes) {
  for (let at = 0; at < bytes.length;) {
    const { bytesWritten } = await promisify(write)(file, bytes, at, bytes.length - at);
    at += bytesWritten;
  }
  await promisify(fsync)(file);
}

/** Fails if the place is taken. @param {Draft} draft */
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

/** Makes moves outlive a loss of power, where possible. @param {string} folder */
function flushFolder(folder) {
  try {
    const file = openSync(folder, 'r');
    fsyncSync(file);
    closeSync(file);
  } catch {
    return;
  }
}

/** Gives a file a second name; copies it where a file system has no links. */
function linkOrCopy(/** @type {string} */ from, /** @type {string} */ to) {
  try {
    linkSync(from, to);
    return;
  } catch (error) {
    if (codeOf(error) === 'EEXIST') throw error;
  }
  try {
    copyFileSync(from, to);
  } catch (error) {
    rmSync(to, { force: true });
    throw error;
  }
}

export class Drafts {
  /** @type {Draft} */
  #main;
  /** @type {Draft[]} */
  #companions;
  /** @type {{ draft: Draft, other: string }[]} companions that replace others */
  #replacing = [];
  /** @type {Draft | undefined} the main file with the other names */
  #between;
  /** @type {string[]} folders made for them */
  #folders = [];
  /** @type {{ place: string, path: string }[]} second names of the old files, the main one last */
  #kept = [];
  /** @type {string[]} places that were free */
  #taken = [];

  /** @param {PlacedFile[]} files the main one last */
  constructor(files) {
    const drafts = files.map((file) => ({ ...file, path: besides(file.place, 'part') }));
    this.#companions = drafts.slice(0, -1);
    this.#main = drafts[drafts.length - 1];
  }

  /** Each is made at once, so that discard() finds it whenever it is called. */
  async write() {
    for (const draft of [...this.#companions, this.#main]) await this.#writeDraft(draft);
    this.#replacing = this.#companions.filter(({ place }) => existsSync(place))
      .map((draft) => ({ draft, other: otherPlace(draft.place) }));
    const { place } = this.#main;
    const nameOf = (/** @type {string} */ path) =>
      relative(dirname(place), path).replaceAll(sep, '/');
    const names = new Map(this.#replacing.map(({ draft, other }) =>
      [nameOf(draft.place), nameOf(other)]));
    const bytes = withOtherNames(this.#main, names);
    if (!bytes) return;
    this.#between = { place, bytes, path: besides(place, 'part') };
    await this.#writeDraft(this.#between);
  }

  /** @param {Draft} draft */
  async #writeDraft({ place, path, bytes }) {
    this.#folders.unshift(...makeFolders(dirname(place)));
    const mode = existsSync(place) ? statSync(place).mode & 0o777 : 0o666;
    const file = openSync(path, 'wx', mode);
    try {
      await writeAll(file, bytes);
    } finally {
      closeSync(file);
    }
  }

  /** Moves all drafts to their places, without a pause. After a failure all is as it was. */
  move() {
    try {
      this.#keepOld();
      const replacing = new Set(this.#replacing.map(({ draft }) => draft));
      for (const draft of this.#companions.filter((one) => !replacing.has(one))) {
        moveToFree(draft);
        this.#taken.push(draft.place);
      }
      this.#showOther();
      for (const { draft } of this.#replacing) renameSync(draft.path, draft.place);
      renameSync(this.#main.path, this.#main.place);
    } catch (error) {
      this.discard();
      throw error;
    }
    for (const { other } of this.#replacing) rmSync(other, { force: true });
    for (const { path } of this.#kept) rmSync(path, { force: true });
    const folders = [this.#main, ...this.#companions].map(({ place }) => dirname(place));
    new Set(folders).forEach(flushFolder);
    this.#forget();
  }

  /** Keeps the old files where one move is not enough. */
  #keepOld() {
    if (this.#replacing.length === 0) return;
    for (const { place } of [...this.#replacing.map(({ draft }) => draft), this.#main]) {
      if (!existsSync(place)) continue;
      const path = besides(place, 'old');
      linkOrCopy(place, path);
      this.#kept.push({ place, path });
    }
  }

  /** Shows the whole new output by other names: its companions' places are free then. */
  #showOther() {
    if (!this.#between) return;
    for (const { draft, other } of this.#replacing) {
      this.#taken.push(other);
      linkOrCopy(draft.path, other);
    }
    renameSync(this.#between.path, this.#between.place);
  }

  /** Removes all drafts, and puts back the files of before. Safe to repeat. */
  discard() {
    for (const { place, path } of this.#kept) {
      renameSync(path, place);
      rmSync(path, { force: true }); // a move between two names of one file leaves both
    }
    for (const place of this.#taken) rmSync(place, { force: true });
    const drafts = [...this.#companions, this.#main, ...(this.#between ? [this.#between] : [])];
    for (const { path } of drafts) rmSync(path, { force: true });
    removeEmptyFolders(this.#folders);
    this.#forget();
  }

  #forget() {
    [this.#replacing, this.#folders, this.#kept, this.#taken] = [[], [], [], []];
    this.#companions = [];
  }
}

/** @param {string} path */
function isOld(path) {
  const { mtimeMs } = statSync(path, { throwIfNoEntry: false }) ?? { mtimeMs: Date.now() };
  return Date.now() - mtimeMs > oldest;
}

/**
 * Removes the drafts for this place that killed runs have left; those that cannot be removed do no
 * harm.
 * @param {string} place
 */
export function removeLeftovers(place) {
  try {
    for (const name of readdirSync(dirname(place))) {
      const [, stem, hidden] = /^\.(.+)\.(\d+)-[0-9a-f]{8}\.(?:part|old)$/s.exec(name) ?? [];
      const [whole, shown] = otherNamePattern(place).exec(name) ?? [];
      const pid = stem === stemOf(place) ? hidden : whole === name ? shown : undefined;
      if (pid === undefined || isAlive(Number(pid))) continue;
      const path = join(dirname(place), name);
      if (isOld(path)) rmSync(path, { force: true });
    }
  } catch {
    return;
  }
}
