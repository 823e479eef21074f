// SPDX-License-Identifier: MIT
// Whether Parcel's projects can use every entry of the package, as tests/bundlers.test.js asks of
// the other bundlers: npm run parcel. It installs Parcel, 111 MB, into a folder that goes away.

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
    // Entries of packages are off unless they are asked for.
    '@parcel/resolver-default': { packageExports: true },
    // Node's modules, of which glTF-Transform speaks for a class that is not for browsers.
    alias: { buffer: false, process: false, 'node:fs': false, 'node:path': false } }));
  write('page.js', moduleProgram(
    "const wasmUrl = new URL('npm:remesher/remesher.wasm', import.meta.url);", 'tell'));
  write('page.html', '<!doctype html><link rel="icon" href="data:,">'
    + '<script type="module" src="page.js"></script>');
  call(join(folder, 'node_modules/.bin/parcel'), ['build', 'page.html', '--dist-dir', 'out',
    '--no-source-maps', '--no-cache', '--no-autoinstall'],
  folder, 600_000);
  // Parcel writes an import map, and keeps more of glTF-Transform's functions than are used: some
  // ask for eval().
  const { line, complaints } =
    await lineOfPage(browser, join(folder, 'out'), '/page.html', "'unsafe-inline' 'unsafe-eval'");
  assert.deepEqual({ line, complaints }, { line: expected, complaints: [] });
  console.log(`Parcel: ${line}`);
} finally {
  await browser.close();
  remove();
}
