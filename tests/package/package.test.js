// SPDX-License-Identifier: MIT
// The tarball: small, whole, without install scripts, and working where nothing else is;
// tests/integration/package/tarball.test.js asks linters of packages and TypeScript.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { call as callIn, freshProject, linkPeers } from '../support/fresh_project.js';
import { offText, torus } from '../support/shapes.js';
import { readText } from '../support/tree.js';

const { folder, tarball, manifest, write, remove } = freshProject();
after(remove);

const installed = join(folder, 'node_modules/remesher');
const call = (command, words) => callIn(command, words, folder);

/** Every file an exports map can lead to. */
function targets(entry) {
  return typeof entry === 'string' ? [entry] : Object.values(entry).flatMap(targets);
}

test('it holds the built package and the papers, nothing else', () => {
  const belongs =
    /^(dist\/([a-z]+\/)?[a-z_]+(\.wasm)?(\.d)?\.(m?[jt]s|wasm)|package\.json|[A-Z]+(\.md)?)$/;
  const wrong = tarball.files.map(({ path }) => path)
    .filter((path) => !belongs.test(path) && path !== 'docs/pictures/remesher.webp');
  assert.deepEqual(wrong, []);
  // Two thirds are WebAssembly, of which there are two; the README's picture is an eighth.
  assert.ok(tarball.size < 2_510_000, `${tarball.size} bytes`);
});

test('installing runs nothing and brings nothing', () => {
  const scripts = Object.keys(manifest.scripts ?? {});
  assert.deepEqual(scripts.filter((name) => /install|^prepare$/.test(name)), []);
  assert.deepEqual(manifest.dependencies ?? {}, {});
});

test('everything the manifest names is there', () => {
  const named = [...targets(manifest.exports), ...Object.values(manifest.bin)];
  assert.deepEqual(named.filter((file) => !existsSync(join(installed, file))), []);
  assert.equal(manifest.type, 'module');
  assert.equal(manifest.sideEffects, false);
});

test('types come first among the conditions, and the default last', () => {
  for (const entry of Object.values(manifest.exports).filter((e) => typeof e === 'object')) {
    assert.equal(Object.keys(entry)[0], 'types');
    assert.equal(Object.keys(entry).at(-1), 'default');
  }
});

test('what browsers load does not speak of Node', () => {
  const files = ['index', 'arrays', 'pool', 'platform_browser', 'worker', 'api/api',
    'api/arrays_api', 'api/client', 'api/client_pool', 'api/modules', 'api/pool_of',
    'api/wasm_source', 'base/errors', 'base/options', 'worker/engine', 'worker/arrays_script',
    'worker/whole_script', 'worker/serve'];
  for (const file of [...files.map((name) => `dist/${name}.js`), 'dist/remesher.mjs',
    'dist/remesher_arrays.mjs']) {
    const text = readFileSync(join(installed, file), 'utf8');
    assert.doesNotMatch(text, /['"]node:|require\(|new Function\b|\beval\(/, file);
  }
});

test('a program imports it and remeshes', () => {
  write('program.js', `
    import { remeshFile, RemeshError } from 'remesher';
    import { optionTable } from 'remesher/options';
    const bytes = new TextEncoder().encode(${JSON.stringify(offText(torus()))});
    const { report } = await remeshFile(bytes, { name: 'torus.off', vertices: 400 });
    console.log(report.output.vertices, typeof RemeshError, optionTable.length > 10);`);
  assert.equal(call(process.execPath, ['program.js']).trim(), '400 function true');
});

test('the command is installed and works', () => {
  write('torus.off', offText(torus()));
  const command = join(folder, 'node_modules/.bin/remesher');
  call(command, ['torus.off', '-o', 'out.obj', '--vertices', '300', '--quiet']);
  assert.equal(readFileSync(join(folder, 'out.obj'), 'utf8').match(/^v /gm).length, 300);
  assert.equal(call(command, ['--version']).trim(), JSON.parse(readText('package.json')).version);
});

test('nothing but the adapters and the textures ask for what they are for', () => {
  const peers = Object.keys(manifest.peerDependencies);
  for (const name of peers) assert.ok(manifest.peerDependenciesMeta[name].optional, name);
  for (const { path } of tarball.files.filter(({ path: file }) => /\.m?js$/.test(file))) {
    if (/^dist\/(adapters|textures)\//.test(path)) continue;
    const text = readFileSync(join(installed, path), 'utf8');
    for (const name of peers) assert.ok(!text.includes(`'${name}'`), `${path}: ${name}`);
  }
});

test('a program imports the adapters and the pool', () => {
  linkPeers(folder);
  write('adapters.js', `
    import { Document } from '@gltf-transform/core';
    import { TorusGeometry } from 'three';
    import { RemeshError } from 'remesher';
    import { remesh } from 'remesher/gltf-transform';
    import { Pool } from 'remesher/pool';
    import { remeshGeometry } from 'remesher/three';
    const torus = new TorusGeometry(1, 0.4, 24, 48);
    const { geometry, report } = await remeshGeometry(torus, { vertices: 400 });
    await new Document().transform(remesh());
    const pool = new Pool({ size: 1 });
    const failed = await pool.inspect({}).catch((error) => error instanceof RemeshError);
    console.log(report.output.vertices, geometry.attributes.uv.itemSize, failed);`);
  assert.equal(call(process.execPath, ['adapters.js']).trim(), '400 2 true');
});
