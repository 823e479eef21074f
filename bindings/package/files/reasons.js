// SPDX-License-Identifier: MIT
// Why the system refused, in words, for errors that name the file themselves.

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';

const known = new Map([
  ['ENOENT', 'there is no such file or folder'],
  ['EACCES', 'permission is denied'],
  ['EPERM', 'permission is denied'],
  ['EISDIR', 'it is a folder'],
  ['EEXIST', 'something is there already'],
  ['ENOTDIR', 'a part of its path is not a folder'],
  ['EROFS', 'the file system is read-only'],
  ['ENOSPC', 'the disk is full'],
  ['EDQUOT', 'the disk quota is used up'],
  ['EFBIG', 'it is larger than files may be'],
  ['ELOOP', 'its links lead nowhere'],
  ['ENAMETOOLONG', 'its name is too long'],
  ['EMFILE', 'too many files are open'],
  ['EIO', 'the disk fails'],
]);

/** @param {unknown} error */
export function codeOf(error) {
  return /** @type {NodeJS.ErrnoException} */ (error)?.code ?? '';
}

/** @param {unknown} error */
export function reason(error) {
  return known.get(codeOf(error)) ?? legible(error);
}

/** @param {string} path @param {string} why @param {string} [hint] */
export function unreadable(path, why, hint) {
  return new RemeshError('INPUT_UNREADABLE', `${legible(path)} cannot be read: ${why}.`,
    hint ?? 'Check the name.');
}

/** The kind of a path that is no plain file. @param {import('node:fs').Stats} stats */
export function kindOf(stats) {
  if (stats.isDirectory()) return 'a folder';
  if (stats.isFIFO()) return 'a pipe';
  if (stats.isSocket()) return 'a socket';
  return stats.isSymbolicLink() ? 'a link' : 'a device';
}
