// SPDX-License-Identifier: MIT
// Builds the page once for all test files that use the same sources.
import { createHash } from 'node:crypto';
import {
  existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync,
} from 'node:fs';
import { join } from 'node:path';

import { build } from 'vite';

import { filesUnder, root } from './tree.js';

export const configFile = join(root, 'web/vite.config.js');

/** A hash of all files that the page is made from. */
function fingerprint() {
  const hash = createHash('sha256');
  const files = [...filesUnder('web', /./), ...filesUnder('dist', /\.(js|mjs|wasm)$/)].sort();
  for (const file of [...files, 'package-lock.json']) {
    hash.update(`${file}\n`).update(readFileSync(join(root, file)));
  }
  return hash.digest('hex').slice(0, 16);
}

/** @returns {Promise<string>} the folder */
export async function builtPage() {
  const pages = join(root, 'build/pages');
  const print = fingerprint();
  const folder = join(pages, print);
  if (existsSync(folder)) return folder;
  mkdirSync(pages, { recursive: true });
  // Pages of other sources are removed. Another test file may be building the same page as this.
  for (const name of readdirSync(pages).filter((other) => !other.includes(print))) {
    rmSync(join(pages, name), { recursive: true, force: true });
  }
  const outDir = mkdtempSync(join(pages, `new-${print}-`));
  await build({ configFile, logLevel: 'error', build: { outDir, emptyOutDir: true } });
  try {
    renameSync(outDir, folder);
  } catch {
    rmSync(outDir, { recursive: true });  // another test file was faster
  }
  return folder;
}
