// SPDX-License-Identifier: MIT
// A folder in which this package seems installed, to run the commands printed in the papers.
import { chmodSync, mkdirSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { root } from './tree.js';

/**
 * Links all that `npm install` would bring; npx runs it without asking a registry.
 * @param {string} folder
 * @returns {string} its node_modules, with npx in `.bin`
 */
export function linkInstalled(folder) {
  const packages = join(folder, 'node_modules');
  mkdirSync(join(packages, '.bin'), { recursive: true });
  symlinkSync(root, join(packages, 'remesher'));
  for (const name of ['three', '@gltf-transform', '@modelcontextprotocol', 'vite', 'zod']) {
    symlinkSync(join(root, 'node_modules', name), join(packages, name));
  }
  symlinkSync(join(root, 'dist/cli/cli.js'), join(packages, '.bin/remesher'));
  symlinkSync(join(root, 'node_modules/.bin/vite'), join(packages, '.bin/vite'));
  const npx = join(packages, '.bin/npx');
  writeFileSync(npx, '#!/bin/sh\nname=$1\nshift\nexec "$(dirname "$0")/$name" "$@"\n');
  chmodSync(npx, 0o755);
  return packages;
}
