// SPDX-License-Identifier: MIT
// What there is to read, and the links in it that lead nowhere.
import { existsSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';

import { filesUnder, root } from './tree.js';

export const papers =
  ['README.md', 'CHANGELOG.md', 'CONTRIBUTING.md', 'SECURITY.md', 'src/README.md',
    ...filesUnder('docs', /\.md$/)];

/**
 * Links of a file that lead to no file, or to no place in it; links to other hosts are not
 * followed.
 */
export function deadLinks(file, links, placesOf) {
  return links.filter((link) => !/^[a-z]+:/.test(link)).filter((link) => {
    const [path, place] = link.split('#').map(decodeURIComponent);
    const target = path === '' ? file : normalize(join(dirname(file), path));
    if (!existsSync(join(root, target))) return true;
    return Boolean(place) && /\.(html|md|svg)$/.test(target) && !placesOf(target).includes(place);
  }).map((link) => `${file}: ${link}`);
}
