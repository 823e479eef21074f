// SPDX-License-Identifier: MIT
// Tests that projects of Parcel can use every entry of the package, as
// tests/integration/bundlers.test.js does for the other bundlers: npm run parcel.
// Parcel, 111 MB, is installed into a temporary folder.

import { strict as assert } from 'node:assert';
import { join } from 'node:path';

import { startChromium } from '../support/chromium.js';
import { expected, moduleProgram } from '../support/entries.js';
import { call, freshProject, linkPeers } from '../support/fresh_project.js';
import { lineOfPage } from '../support/line_of_page.js';

const { folder, write, remove } = freshProject();
const browser = await startChromium();
try {
  call('npm', ['install', '--no-audit', '--no-fund', '--silent', 'parcel@2.16.4'], folder,
    600_000);
  linkPeers(folder);
  write('package.json', JSON.stringify({ type: 'module', private: true,
    // Parcel ignores the entries of packages unless this option is on.
    '@parcel/resolver-default': { packageExports: true },
    // Modules of Node that glTF-Transform names for a class that is not for browsers.
    alias: { buffer: false, process: false, 'node:fs': false, 'node:path': false } }));
  write('page.js', moduleProgram(
    "const wasmUrl = new URL('npm:remesher/remesher.wasm', import.meta.url);", 'tell'));
  write('page.html', '<!doctype html><link rel="icon" href="data:,">'
    + '<script type="module" src="page.js"></script>');
  call(join(folder, 'node_modules/.bin/parcel'), ['build', 'page.html', '--dist-dir', 'out',
    '--no-source-maps', '--no-cache', '--no-autoinstall'],
  folder, 600_000);
  // Parcel writes an import map, and keeps unused functions of glTF-Transform: some need eval().
  const { line, complaints } =
    await lineOfPage(browser, join(folder, 'out'), '/page.html', "'unsafe-inline' 'unsafe-eval'");
  assert.deepEqual({ line, complaints }, { line: expected, complaints: [] });
  console.log(`Parcel: ${line}`);
} finally {
  await browser.close();
  remove();
}
