// SPDX-License-Identifier: MIT
// Turns the files, folders and patterns that the user names into a list of inputs with their
// outputs. Expands the patterns that no shell has expanded.

import { readdirSync, statSync } from 'node:fs';
import { basename, join, relative, sep } from 'node:path';

import { readFormats, withoutGz } from '../base/formats.js';
import { reason, unreadable } from '../files/reasons.js';

/** @typedef {import('../base/errors.js').RemeshError} RemeshError */

/**
 * A path that the user named, and the place of its result. With an error nothing can be read there.
 * @typedef {{ input: string, output: string, error?: RemeshError }} Step
 */

/** @typedef {{ input: string, way: string, error?: RemeshError }} Found way: below the output */

// The files that are taken from folders; other files there are no error.
const readable = new RegExp(`\\.(${readFormats.join('|')})(\\.gz)?$`, 'i');

/** Undefined: it is not there, or may not be looked at. @param {string} path */
function statsOf(path) {
  try {
    return statSync(path, { throwIfNoEntry: false });
  } catch {
    return undefined;
  }
}

/** @param {string} path @param {unknown} error @returns {Found} */
function failed(path, error) {
  return { input: path, way: basename(path), error: unreadable(path, reason(error), '') };
}

/**
 * The names in a folder, sorted; `plain` is false where the name is not UTF-8, and its other bytes
 * are written like \xe9.
 * @param {string} folder
 */
function entriesOf(folder) {
  return readdirSync(folder || '.', { withFileTypes: true, encoding: 'buffer' }).map((entry) => {
    const bytes = /** @type {Buffer} */ (/** @type {unknown} */ (entry.name));
    const name = bytes.toString();
    const plain = Buffer.from(name).equals(bytes);
    return { name: plain ? name : spelled(bytes), plain, isFolder: entry.isDirectory() };
  }).sort((a, b) => (a.name < b.name ? -1 : 1));
}

/** @param {{ name: string }} entry */
const isShown = ({ name }) => !name.startsWith('.');

/** @param {Buffer} bytes */
function spelled(bytes) {
  return bytes.toString('latin1').replace(/[\x80-\xff]/g, (byte) =>
    `\\x${byte.charCodeAt(0).toString(16)}`);
}

/**
 * The models below a folder, in the order of their names: none that is hidden or in a folder behind
 * a link. Whatever has the name of a model is there, a pipe or a link that leads nowhere, too.
 * @param {string} folder
 * @returns {Found[]}
 */
function modelsBelow(folder) {
  try {
    return entriesOf(folder).filter(isShown).flatMap(({ name, plain, isFolder: isInner }) => {
      const path = join(folder, name);
      if (isInner) return plain ? modelsBelow(path) : [unspellable(path)];
      if (!readable.test(name)) return [];
      if (!plain) return [unspellable(path)];
      return statsOf(path)?.isDirectory() ? [] : [{ input: path, way: path }];
    });
  } catch (error) {
    return [failed(folder, error)];
  }
}

/** @param {string} path @returns {Found} */
function unspellable(path) {
  return { input: path, way: basename(path),
    error: unreadable(path, 'its name is not UTF-8', 'Rename it.') };
}

/** Of one part of a path: * and ? @param {string} pattern */
function expressionFor(pattern) {
  const escaped = pattern.replace(/[.+^${}()|[\]\\]/g, '\\$&');
  return new RegExp(`^${escaped.replaceAll('*', '.*').replaceAll('?', '.')}$`, 's');
}

/**
 * What fits a part of a pattern in a folder.
 * @param {string} folder @param {string} part
 * @returns {Found[]}
 */
function fitting(folder, part) {
  const expression = expressionFor(part);
  try {
    return entriesOf(folder).filter(({ name }) =>
      expression.test(name) && name.startsWith('.') === part.startsWith('.'))
      .map(({ name, plain }) => (plain ? named : unspellable)(join(folder, name)));
  } catch (error) {
    return [failed(folder, error)];
  }
}

/** @param {string} path @returns {Found} */
const named = (path) => ({ input: path, way: basename(path) });

/**
 * `scans/*.stl`: the files that fit; ** is any number of folders.
 * @param {string} pattern
 * @returns {Found[]}
 */
function expand(pattern) {
  /** @type {Found[]} */
  let found = [named(pattern.startsWith('/') ? '/' : '')];
  for (const part of pattern.split(/[/\\]/).filter(Boolean)) {
    found = found.flatMap((one) => {
      if (one.error) return [one];
      if (part === '**') return [one, ...foldersBelow(one.input)];
      const path = join(one.input, part);
      if (!/[*?]/.test(part)) return statsOf(path) ? [named(path)] : [];
      return statsOf(one.input || '.')?.isDirectory() ? fitting(one.input, part) : [];
    });
  }
  return found.filter(({ input, error }) => error || !statsOf(input)?.isDirectory());
}

/** @param {string} folder @returns {Found[]} */
function foldersBelow(folder) {
  try {
    return entriesOf(folder).filter((entry) => entry.isFolder && entry.plain && isShown(entry))
      .flatMap(({ name }) => [named(join(folder, name)), ...foldersBelow(join(folder, name))]);
  } catch (error) {
    return [failed(folder, error)];
  }
}

/**
 * Each file with its path below the output: for files of a folder, their path from that folder.
 * What cannot be looked at is a file here: whoever reads it says why it cannot be read.
 * @param {string} name
 * @returns {Found[]}
 */
function namedBy(name) {
  const stats = statsOf(name);
  if (stats?.isDirectory()) {
    return modelsBelow(name).map((found) =>
      (found.error ? found : { ...found, way: relative(name, found.input) }));
  }
  return stats || !/[*?]/.test(name) ? [named(name)] : expand(name);
}

/**
 * @param {string} way
 * @param {string} format empty: the input's
 */
function resultName(way, format) {
  const plain = withoutGz(way);
  const stem = plain.replace(readable, '');
  return format === '' ? plain : `${stem}.${format}`;
}

/**
 * A name that leads to nothing is a step with an error.
 * @param {readonly string[]} names
 * @param {string} folder of the outputs
 * @param {string} format
 * @returns {Step[]} in the order of the names; no input twice
 */
export function plan(names, folder, format) {
  /** @type {Map<string, Step>} */
  const steps = new Map();
  for (const name of names) {
    const found = namedBy(name);
    if (found.length === 0) {
      found.push({ ...named(name), error: unreadable(name, 'there is no model') });
    }
    for (const { input, way, error } of found) {
      const step = { input, output: join(folder, resultName(way, format)) };
      if (!steps.has(input)) steps.set(input, error ? { ...step, error } : step);
    }
  }
  return [...steps.values()];
}

/** Whether an output is a folder, for any number of results. @param {string} output */
export function isFolder(output) {
  return output.endsWith('/') || output.endsWith(sep);
}

/**
 * The steps that would overwrite the result of an earlier step.
 * @param {readonly Step[]} steps
 */
export function clashes(steps) {
  const taken = new Set();
  return new Set(steps.filter(({ output, error }) => {
    if (error) return false;
    const key = output.toLowerCase();
    const isTaken = taken.has(key);
    taken.add(key);
    return isTaken;
  }));
}
