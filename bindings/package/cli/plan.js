// SPDX-License-Identifier: MIT
// Turns the files, folders and patterns that the user names into a list of inputs with their
// outputs. Expands the patterns that no shell has expanded.

import { readdirSync, statSync } from 'node:fs';
import { basename, join, relative, sep } from 'node:path';

import { RemeshError } from '../base/errors.js';
import { formats, withoutGz } from '../base/formats.js';
import { legible } from '../base/legible.js';
import { reason } from '../files/reasons.js';

/** @typedef {{ input: string, output: string }} Step */

// The files that are taken from folders; other files there are no error.
const readable = new RegExp(`\\.(${formats.join('|')})(\\.gz)?$`, 'i');

/** @param {string} path */
function statsOf(path) {
  return statSync(path, { throwIfNoEntry: false });
}

/** @param {string} path @param {string} why */
function unreadable(path, why) {
  return new RemeshError('INPUT_UNREADABLE', `${legible(path)} cannot be read: ${why}.`,
    'Check the name.');
}

/**
 * The files below a folder, in the order of their names: none that is hidden or in a folder behind
 * a link.
 * @param {string} folder
 * @returns {string[]}
 */
function filesBelow(folder) {
  const entries = readdirSync(folder, { withFileTypes: true })
    .filter(({ name }) => !name.startsWith('.'))
    .sort((a, b) => (a.name < b.name ? -1 : 1));
  return entries.flatMap((entry) => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? filesBelow(path) : statsOf(path)?.isFile() ? [path] : [];
  });
}

/** Of one part of a path: * and ? @param {string} pattern */
function expressionFor(pattern) {
  const escaped = pattern.replace(/[.+^${}()|[\]\\]/g, '\\$&');
  return new RegExp(`^${escaped.replaceAll('*', '.*').replaceAll('?', '.')}$`, 's');
}

/**
 * The names in a folder that fit a part of a pattern.
 * @param {string} folder @param {string} part
 */
function fitting(folder, part) {
  const expression = expressionFor(part);
  return readdirSync(folder === '' ? '.' : folder)
    .filter((name) => expression.test(name) && name.startsWith('.') === part.startsWith('.'))
    .sort()
    .map((name) => join(folder, name));
}

/**
 * `scans/*.stl`: the files that fit; ** is any number of folders.
 * @param {string} pattern
 * @returns {string[]}
 */
function expand(pattern) {
  /** @type {string[]} */
  let paths = [pattern.startsWith('/') ? '/' : ''];
  for (const part of pattern.split(/[/\\]/).filter(Boolean)) {
    paths = paths.flatMap((path) => {
      if (part === '**') return [path, ...foldersBelow(path)];
      if (!/[*?]/.test(part)) return statsOf(join(path, part)) ? [join(path, part)] : [];
      return statsOf(path || '.')?.isDirectory() ? fitting(path, part) : [];
    });
  }
  return [...new Set(paths)].filter((path) => statsOf(path)?.isFile());
}

/** @param {string} folder @returns {string[]} */
function foldersBelow(folder) {
  return readdirSync(folder || '.', { withFileTypes: true })
    .filter((entry) => entry.isDirectory() && !entry.name.startsWith('.'))
    .map(({ name }) => join(folder, name)).sort()
    .flatMap((path) => [path, ...foldersBelow(path)]);
}

/**
 * Each file with its path below the output: for files of a folder, their path from that folder.
 * @param {string} name
 * @returns {{ input: string, way: string }[]}
 */
function namedBy(name) {
  const stats = statsOf(name);
  if (stats?.isDirectory()) {
    return filesBelow(name).filter((path) => readable.test(path))
      .map((path) => ({ input: path, way: relative(name, path) }));
  }
  if (!stats && !/[*?]/.test(name)) throw unreadable(name, 'there is no such file or folder');
  const paths = stats ? [name] : expand(name);
  return paths.map((path) => ({ input: path, way: basename(path) }));
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
 * Throws if a name leads to nothing.
 * @param {readonly string[]} names
 * @param {string} folder of the outputs
 * @param {string} format
 * @returns {Step[]} in the order of the names; no input twice
 */
export function plan(names, folder, format) {
  /** @type {Map<string, Step>} */
  const steps = new Map();
  for (const name of names) {
    let found;
    try {
      found = namedBy(name);
    } catch (error) {
      throw error instanceof RemeshError ? error : unreadable(name, reason(error));
    }
    if (found.length === 0) throw unreadable(name, 'there is no model');
    for (const { input, way } of found) {
      if (steps.has(input)) continue;
      steps.set(input, { input, output: join(folder, resultName(way, format)) });
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
  return new Set(steps.filter(({ output }) => {
    const key = output.toLowerCase();
    const isTaken = taken.has(key);
    taken.add(key);
    return isTaken;
  }));
}
