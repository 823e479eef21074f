// SPDX-License-Identifier: MIT
// Build step: lays the documentation beside the page, in docs/, and shows the link to it, which is
// hidden where there is none. It is copied after all else: the service worker does not keep it.
import { cpSync } from 'node:fs';
import { join } from 'node:path';

const hidden = ' id="reading" hidden>';

/** @param {string} html the page */
export function withDocumentation(html) {
  if (!html.includes(hidden)) throw new Error('index.html has no link to the documentation.');
  return html.replace(hidden, ' id="reading">');
}

/** @param {string} folder what `npm run docs` made @returns {import('vite').Plugin} */
export function documentation(folder) {
  let outDir = '';
  return {
    name: 'documentation',
    configResolved: ({ build }) => { outDir = build.outDir; },
    transformIndexHtml: withDocumentation,
    closeBundle: () => cpSync(folder, join(outDir, 'docs'), { recursive: true }),
  };
}
