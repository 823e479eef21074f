// SPDX-License-Identifier: MIT
// Builds the page into build/web, with build/docs beside it if that exists: a folder of static
// files for any host. `npm run site` makes both.
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { documentation } from './documentation.js';

export const configFile = fileURLToPath(new URL('./vite.config.js', import.meta.url));
const docs = fileURLToPath(new URL('../build/docs', import.meta.url));

export async function buildSite() {
  console.log('Building the page');
  const plugins = existsSync(docs) ? [documentation(docs)] : [];
  await build({ configFile, logLevel: 'warn', plugins });
}
