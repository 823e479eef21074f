// SPDX-License-Identifier: MIT
// Build step: copies the documentation to docs/ beside the page, and shows the link to it, which is
// otherwise hidden. The documentation is copied last, so that the service worker does not keep it.
import { cpSync } from 'node:fs';
import { join } from 'node:path';

const hidden = ' id="reading" hidden>';

/** @param {string} html the page */
export function withDocumentation(html) {
  if (!html.includes(hidden)) throw new Error('index.html has no link to the documentation.');
  return html.replace(hidden, ' id="reading">');
}

/** @param {string} folder made by `npm run docs` @returns {import('vite').Plugin} */
export function documentation(folder) {
  let outDir = '';
  return {
    name: 'documentation',
    configResolved: ({ build }) => { outDir = build.outDir; },
    transformIndexHtml: withDocumentation,
    closeBundle: () => cpSync(folder, join(outDir, 'docs'), { recursive: true }),
  };
}
