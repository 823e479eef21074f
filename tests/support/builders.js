// SPDX-License-Identifier: MIT
// Builds the pages of a project with Vite and with webpack, each from `page.js` in a folder, into
// `out`. Neither may complain.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { promisify } from 'node:util';

import { build as viteBuild, createLogger } from 'vite';
import webpack from 'webpack';

/** glTF-Transform names Node's modules, for a class that is not for browsers. */
export const isPeers = (/** @type {string} */ message) => message.includes('@gltf-transform');
export const nodeModules = /^node:/;

export const html = (head = '') => '<!doctype html><link rel="icon" href="data:,">'
  + `${head}<script type="module" src="page.js"></script>`;

/** @typedef {ReturnType<typeof import('./fresh_project.js').freshProject>} Project */

/** @param {Project} project @param {string} place */
export async function buildByVite({ folder, write }, place) {
  write(`${place}/index.html`, html());
  /** @type {string[]} */
  const said = [];
  const say = (/** @type {string} */ message) => isPeers(message) || said.push(message);
  const customLogger = { ...createLogger('silent'), warn: say, warnOnce: say, error: say };
  await viteBuild({ root: join(folder, place), configFile: false, customLogger,
    worker: { format: 'es' },
    build: { target: 'es2022', outDir: 'out', chunkSizeWarningLimit: 2000,
      rolldownOptions: { checks: { bundlerTimings: false } } } });  // a busy core is no fault
  assert.deepEqual(said, []);
}

/** @param {Project} project @param {string} place */
export async function buildByWebpack({ folder, write }, place) {
  const compiler = webpack({ mode: 'production', context: folder, performance: false,
    entry: join(folder, place, 'page.js'),
    plugins: [new webpack.IgnorePlugin({ resourceRegExp: nodeModules })],
    optimization: { minimize: false },
    output: { path: join(folder, place, 'out'), filename: 'page.js',
      assetModuleFilename: '[name]-[hash][ext]' } });
  const stats = await promisify(compiler.run.bind(compiler))();
  await promisify(compiler.close.bind(compiler))();
  assert.deepEqual([...stats.compilation.errors, ...stats.compilation.warnings], []);
  write(`${place}/out/index.html`, html());
}
