// SPDX-License-Identifier: MIT
// Finds our C++ files on which another depends: files that it includes, and files that it can call.
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';

import { filesUnder, readText, root } from './tree.js';

/** The build's include folders. */
export const includeFolders = ['src', 'tests/unit'];

const exists = (/** @type {string} */ file) => existsSync(join(root, file));

/** @type {Map<string, string[]>} */
const known = new Map();

/** Our headers that a file includes directly. @param {string} file */
function included(file) {
  const folders = [...new Set([...includeFolders, dirname(file)])];
  const headers = known.get(file) ?? [...readText(file).matchAll(/^#include "(.+)"/gm)]
    .flatMap(([, name]) => folders.map((folder) => `${folder}/${name}`)).filter(exists);
  known.set(file, headers);
  return headers;
}

/**
 * The files that implement a header: the source of its name or, if there is none, the sources in
 * its folder that include it.
 * @param {string} header
 */
function implementing(header) {
  const twin = header.replace(/\.h$/, '.cpp');
  if (exists(twin)) return [twin];
  return filesUnder(dirname(header), /\.cpp$/).filter((file) => included(file).includes(header));
}

/**
 * @param {string} file
 * @param {(file: string) => string[]} next
 * @param {Set<string>} found
 */
function reached(file, next, found = new Set()) {
  if (found.has(file)) return found;
  found.add(file);
  for (const other of next(file)) reached(other, next, found);
  return found;
}

/** The file and all our headers that it includes, directly or not. @param {string} file */
export const withIncludes = (file) => [...reached(file, included)].sort();

/** The file and all our files that its code can reach: its headers, and their implementations. */
export function withCallees(/** @type {string} */ file) {
  const next = (/** @type {string} */ at) =>
    at.endsWith('.h') ? [...included(at), ...implementing(at)] : included(at);
  return [...reached(file, next)].sort();
}
