// SPDX-License-Identifier: MIT
// Makes folders for results, and removes them again if nothing was written.

import { mkdirSync, rmdirSync } from 'node:fs';
import { dirname, resolve } from 'node:path';

/** @param {string} folder @returns {string[]} the folders made, the innermost first */
export function makeFolders(folder) {
  const first = mkdirSync(folder, { recursive: true });
  /** @type {string[]} */
  const made = [];
  if (first === undefined) return made;
  for (let at = resolve(folder); at.length >= resolve(first).length; at = dirname(at)) {
    made.push(at);
  }
  return made;
}

/** Those that are in use stay. @param {string[]} folders the innermost first */
export function removeEmptyFolders(folders) {
  for (const folder of folders) {
    try {
      rmdirSync(folder);
    } catch {
      continue;
    }
  }
}
