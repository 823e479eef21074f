// SPDX-License-Identifier: MIT
// Whether the package works under every version of Node, with the same bytes: npm run nodes, or
// npm run nodes -- 22 26.0.0. It is packed as for npm and installed into an empty project. Ends
// with status 1 if something failed, or came out differently.
import { spawnSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { delimiter, dirname, join } from 'node:path';

import { freshProject, linkPeers } from '../support/fresh_project.js';
import { installNode } from './binaries.js';
import { uses } from './uses.js';

/** The oldest that package.json allows, and each release line since that is kept. */
const lines = ['20', '22', '24', '26'];
const longest = 300_000; // milliseconds: what takes longer hangs

/**
 * Runs programs under one Node to their end, which is a success without a word on standard error.
 * @param {string} node @param {string} folder
 * @returns {import('./uses.js').Project}
 */
function projectUnder(node, folder) {
  // That three.js will have no CommonJS some day, it says itself.
  const env = { ...process.env, NODE_OPTIONS: '--disable-warning=THREE_CJS_DEPRECATED',
    PATH: `${dirname(node)}${delimiter}${process.env.PATH}` };
  return {
    folder,
    node(words, cwd = folder) {
      const { status, signal, stdout, stderr } = spawnSync(node, words,
        { cwd, env, timeout: longest, maxBuffer: 2 ** 28 });
      if (status === 0 && stderr.length === 0) return stdout;
      throw new Error(`${words.join(' ')} ended with ${signal ?? status}: ${stderr}`);
    },
  };
}

/** @param {import('./uses.js').Project} project @returns {string[]} a line per use */
function linesOf(project) {
  return uses.map(({ line }) => {
    try {
      return line(project);
    } catch (error) {
      return `failed: ${error.message}`;
    }
  });
}

const versions = process.argv.length > 2 ? process.argv.slice(2) : lines;
const { folder, remove } = freshProject();
try {
  linkPeers(folder);
  /** @type {string[] | undefined} what the first version gave */
  let wanted;
  for (const version of versions) {
    const place = join(folder, 'nodes', version);
    mkdirSync(place, { recursive: true });
    const project = projectUnder(installNode(version, place), folder);
    const found = linesOf(project);
    wanted ??= found.map((line, i) => uses[i].expected ?? line);
    const wrong = found.flatMap((line, i) => (line !== wanted[i] || line.startsWith('failed')
      ? [`${uses[i].name}: ${line}, wanted: ${wanted[i]}`] : []));
    const name = project.node(['--version']).toString().trim();
    console.log(`${name}: ${uses.length - wrong.length} of ${uses.length} uses as they should be`);
    for (const text of wrong) console.log(`  ${text}`);
    if (wrong.length > 0) process.exitCode = 1;
  }
} finally {
  remove();
}
