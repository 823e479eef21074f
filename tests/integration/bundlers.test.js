// SPDX-License-Identifier: MIT
// The tarball in projects of every kind: installed once, all its entries used, in Node by import
// and by require(), and in Chromium by way of each bundler and of none. Parcel, which is as large
// as all others together, has `npm run parcel`.
import assert from 'node:assert/strict';
import { copyFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import commonjs from '@rollup/plugin-commonjs';
import { nodeResolve } from '@rollup/plugin-node-resolve';
import * as esbuild from 'esbuild';
import { rollup } from 'rollup';

import { buildByVite, buildByWebpack, html, isPeers, nodeModules } from '../support/builders.js';
import { startChromium } from '../support/chromium.js';
import { nodeProgram, pageProgram } from '../support/bake_program.js';
import { commonProgram, entries, expected, moduleProgram } from '../support/entries.js';
import { call, freshProject, linkPeers } from '../support/fresh_project.js';
import { lineOfPage } from '../support/line_of_page.js';

const project = freshProject();
after(project.remove);
linkPeers(project.folder);
const { folder, write } = project;
const installed = join(folder, 'node_modules/remesher/dist');
const limit = { timeout: 240_000 };

/** @type {import('playwright-core').Browser} */
let browser;
before(async () => {
  browser = await startChromium();
});
after(() => browser.close());

/** Where bundlers put it: remesher.wasm beside the script. */
const beside = "const wasmUrl = new URL('remesher.wasm', import.meta.url);";

/** The program of a page. @param {string} place @param {string} wasm as moduleProgram takes it */
function writePage(place, wasm) {
  write(`${place}/index.html`, html());
  return write(`${place}/page.js`, moduleProgram(wasm, 'tell'));
}

/** What the built page says; and it complains of nothing. @param {string} place */
async function requireLine(place, path = '/', allowed = '') {
  assert.deepEqual(await lineOfPage(browser, join(folder, place), path, allowed),
    { line: expected, complaints: [] });
}

test('the programs reach every entry', () => {
  const reached = [...entries, 'remesher/worker', 'remesher/remesher.wasm',
    'remesher/remesher_arrays.wasm', 'remesher/package.json'];
  assert.deepEqual(reached.sort(),
    Object.keys(project.manifest.exports).map((name) => join('remesher', name)).sort());
});

test('Node, by import', limit, () => {
  write('program.mjs', moduleProgram(
    "const wasmUrl = import.meta.resolve('remesher/remesher.wasm');", 'console.log'));
  assert.equal(call(process.execPath, ['program.mjs'], folder).trim(), expected);
});

test('Node, by require()', { ...limit, skip: !process.features.require_module }, () => {
  write('program.cjs', commonProgram());
  assert.equal(call(process.execPath, ['program.cjs'], folder).trim(), expected);
});

/** What Node says of the textures that it paints. */
let painted = '';
before(() => {
  write('paint.mjs', nodeProgram);
  painted = call(process.execPath, ['paint.mjs'], folder).trim();
  assert.match(painted, /^\d{4,} \d+ \d{4,} \d+$/);
});

/**
 * A page that paints textures in the worker, and then reaches every entry: what one bundler makes
 * of it does what Node does, and the line of each program comes out.
 * @param {string} place @param {string} wasm as moduleProgram takes it
 * @param {typeof buildByVite} build
 */
async function requireBoth(place, wasm, build) {
  write(`${place}/paint.js`, pageProgram);
  write(`${place}/entries.js`, moduleProgram(wasm, 'export default '));
  write(`${place}/page.js`, `const { default: first } = await import('./paint.js');
const { default: second } = await import('./entries.js');\ntell(first + ' ' + second);\n`);
  await build(project, place);
  assert.deepEqual(await lineOfPage(browser, join(folder, place, 'out')),
    { line: `${painted} ${expected}`, complaints: [] });
  // Both engines, and the two halves of each codec; PNG has both in one.
  const built = readdirSync(join(folder, place, 'out'), { recursive: true });
  assert.equal(built.filter((file) => file.endsWith('.wasm')).length, 7);
  return built;
}

test('Vite, with textures painted to the bytes that Node paints', limit, async () => {
  const built = await requireBoth(
    'vite', "import wasmUrl from 'remesher/remesher.wasm?url';", buildByVite);
  assert.ok(built.some((file) => /image_worker/.test(file)), 'the worker of the worker');
});

test('webpack, with textures painted to the bytes that Node paints', limit, () =>
  requireBoth('webpack', "const wasmUrl = new URL('remesher/remesher.wasm', import.meta.url);",
    buildByWebpack));

/** @param {string} place */
function copyEngines(place) {
  for (const name of ['remesher.wasm', 'remesher_arrays.wasm']) {
    copyFileSync(join(installed, name), join(folder, place, name));
  }
}

test('esbuild', limit, async () => {
  const page = writePage('esbuild', beside);
  const { warnings } = await esbuild.build({ bundle: true, format: 'esm', target: 'es2022',
    entryPoints: { page, worker: 'remesher/worker' }, absWorkingDir: folder,
    outdir: 'esbuild/out', external: ['node:*'], logLevel: 'silent' });
  assert.deepEqual(warnings, []);
  copyEngines('esbuild/out');
  write('esbuild/out/index.html', html());
  await requireLine('esbuild/out');
});

test('Rollup', limit, async () => {
  const page = writePage('rollup', beside);
  /** @type {string[]} */
  const said = [];
  const bundle = await rollup({
    input: { page, worker: join(installed, 'worker.js') },
    external: nodeModules,
    plugins: [nodeResolve({ browser: true }), commonjs()],
    onLog: (_, { message, ids = [] }) =>
      [message, ...ids].some(isPeers) || said.push(message),
  });
  await bundle.write({ dir: join(folder, 'rollup/out'), format: 'es',
    entryFileNames: '[name].js', chunkFileNames: '[name]-[hash].js' });
  await bundle.close();
  assert.deepEqual(said, []);
  copyEngines('rollup/out');
  write('rollup/out/index.html', html());
  await requireLine('rollup/out');
});

/**
 * What the adapters are for, a module each; of glTF-Transform's functions the one that is used, for
 * others ask for eval().
 */
async function servePeers() {
  write('plain/functions.js', "export { createTransform } from '@gltf-transform/functions';");
  await esbuild.build({ bundle: true, format: 'esm', splitting: true, absWorkingDir: folder,
    entryPoints: { three: 'three', core: '@gltf-transform/core',
      functions: './plain/functions.js' },
    outdir: 'plain/peers', external: ['node:*'], logLevel: 'silent' });
  return { three: '/plain/peers/three.js', '@gltf-transform/core': '/plain/peers/core.js',
    '@gltf-transform/functions': '/plain/peers/functions.js' };
}

test('no bundler: an import map', limit, async () => {
  const own = Object.entries(project.manifest.exports).map(([name, entry]) =>
    [join('remesher', name), join('/node_modules/remesher', entry.default ?? entry)]);
  const map = { imports: { ...Object.fromEntries(own), ...await servePeers() } };
  writePage('plain', "const wasmUrl = import.meta.resolve('remesher/remesher.wasm');");
  write('plain/index.html', html(`<script type="importmap">${JSON.stringify(map)}</script>`));
  await requireLine('', '/plain/index.html', "'unsafe-inline'"); // the map itself
});
