// SPDX-License-Identifier: MIT
// The checkout's files, by their paths from its root.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

/** All files below a folder whose paths match, sorted; none if there is no such folder. */
export function filesUnder(folder, pattern) {
  if (!existsSync(join(root, folder))) return [];
  return readdirSync(join(root, folder), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name).slice(root.length + 1))
    .filter((path) => pattern.test(path) && !path.includes('node_modules'))
    .sort();
}

export function readText(path) {
  return readFileSync(join(root, path), 'utf8');
}
