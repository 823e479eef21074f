// SPDX-License-Identifier: MIT
// Nobody loads an engine that is not needed: each entry is looked at in Node, and in Chromium by
// way of what bundlers make of it.
import assert from 'node:assert/strict';
import { readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { buildByVite, buildByWebpack } from '../support/builders.js';
import { startChromium } from '../support/chromium.js';
import { programs } from '../support/engine_programs.js';
import { call, freshProject, linkPeers } from '../support/fresh_project.js';
import { lineOfPage } from '../support/line_of_page.js';
import { root } from '../support/tree.js';

const files = { arrays: 'remesher_arrays.wasm', whole: 'remesher.wasm' };
const pathOf = (/** @type {string} */ file) => join(root, 'dist', file);

const project = freshProject();
after(project.remove);
linkPeers(project.folder);
const limit = { timeout: 240_000 };

/** The engine that a size, or a name, tells. */
const sizes = new Map(Object.entries(files).map(([engine, file]) =>
  [statSync(pathOf(file)).size, engine]));
const engineIn = (/** @type {string} */ address) =>
  (address.includes('remesher_arrays') ? 'arrays' : 'whole');

project.write('noted.mjs', `const { compile } = WebAssembly;
globalThis.noted = [];
WebAssembly.compile = (bytes) => {
  noted.push(bytes.byteLength);
  return compile(bytes);
};
`);

for (const [place, { uses, program }] of Object.entries(programs)) {
  test(`Node loads what is needed: ${place}`, limit, () => {
    project.write(`${place}.mjs`, `${program}await uses[process.argv[2]]();
console.log(JSON.stringify(noted));\n`);
    for (const [use, wanted] of Object.entries(uses)) {
      const words = ['--import', './noted.mjs', `${place}.mjs`, use];
      const printed = call(process.execPath, words, project.folder);
      assert.deepEqual(JSON.parse(printed).map((size) => sizes.get(size)), wanted, use);
    }
  });
}

/** @type {import('playwright-core').Browser} */
let browser;
before(async () => {
  browser = await startChromium();
});
after(() => browser.close());

/** The first use that loads every engine which is laid: what a use needs does not depend on the
 * bundler. */
const wholeUse = ({ uses, laid }) =>
  Object.entries(uses).filter(([, wanted]) => laid.every((engine) => wanted.includes(engine)))
    .slice(0, 1);

for (const [bundler, build] of [['vite', buildByVite], ['webpack', buildByWebpack]]) {
  for (const [name, { uses, program, laid }] of Object.entries(programs)) {
    const seen = bundler === 'vite' ? Object.entries(uses) : wholeUse({ uses, laid });
    test(`Chromium loads what is needed, built by ${bundler}: ${name}`, limit, async () => {
      const place = `${bundler}/${name}`;
      project.write(`${place}/page.js`, `${program}await uses[location.search.slice(1)]();
tell(performance.getEntriesByType('resource').map((entry) => entry.name)
  .filter((address) => address.endsWith('.wasm')).join(' '));\n`);
      await build(project, place);
      const out = join(project.folder, place, 'out');
      const built = readdirSync(out, { recursive: true }).map(String)
        .filter((file) => file.endsWith('.wasm'));
      assert.deepEqual(built.map(engineIn).sort(), laid);
      for (const [use, wanted] of seen) {
        const { line, complaints } = await lineOfPage(browser, out, `/index.html?${use}`);
        assert.deepEqual([line.split(' ').map(engineIn), complaints], [wanted, []], use);
      }
    });
  }
}
