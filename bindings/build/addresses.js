// SPDX-License-Identifier: MIT
// The README's addresses of the page and its documentation. They are absolute, because npm shows
// the README apart from the repository, and they follow from `homepage` in package.json alone:
//   npm run addresses    writes them anew
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { root } from './say.js';

/** Where the page is, with a slash at the end. @param {{ homepage: string }} manifest */
export const addressOf = ({ homepage }) => homepage.replace(/\/*$/, '/');

/** The README with the manifest's addresses. @param {string} readme @param {string} address */
export function withAddress(readme, address) {
  const [, old] = /^\[demo\]: (\S+)$/m.exec(readme) ?? [];
  if (!old) throw new Error('README.md has no line [demo]: ADDRESS.');
  return readme.replaceAll(old, address);
}

if (import.meta.filename === process.argv[1]) {
  const file = join(root, 'README.md');
  const manifest = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  writeFileSync(file, withAddress(readFileSync(file, 'utf8'), addressOf(manifest)));
}
