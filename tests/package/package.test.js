// SPDX-License-Identifier: MIT
// The tarball: small, whole, without install scripts, and working where nothing else is.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { call as callIn, freshProject, linkPeers } from '../support/fresh_project.js';
import { offText, torus } from '../support/shapes.js';
import { readText, root } from '../support/tree.js';

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
  assert.ok(tarball.size < 2_000_000, `${tarball.size} bytes`);
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
    'api/arrays_api', 'api/client', 'api/crew', 'api/modules', 'api/pool_of', 'api/wasm_source',
    'base/errors', 'base/options', 'worker/engine', 'worker/arrays_script', 'worker/whole_script',
    'worker/serve'];
  for (const file of [...files.map((name) => `dist/${name}.js`), 'dist/remesher.mjs',
    'dist/remesher_arrays.mjs']) {
    const text = readFileSync(join(installed, file), 'utf8');
    assert.doesNotMatch(text, /['"]node:|require\(|new Function\b|\beval\(/, file);
  }
});

test('what lints packages has nothing to say', () => {
  const linted = (name, words) => call(process.execPath,
    [join(root, 'node_modules', name), ...words]);
  const tar = join(folder, tarball.filename);
  assert.match(linted('publint/src/cli.js', ['run', '--strict', tar]), /All good!/);
  // There is no CommonJS: require() works from Node 20.19 on, and is tested with the bundlers.
  linted('@arethetypeswrong/cli/dist/index.js', [tar, '--profile', 'esm-only', '--quiet']);
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

for (const resolution of ['nodenext', 'bundler']) {
  test(`a TypeScript program finds the types (${resolution})`, () => {
    linkPeers(folder);
    write('typed.ts', `
      import { init, remesh, RemeshError } from 'remesher';
      import type { RemeshReport } from 'remesher';
      import wasmUrl from 'remesher/remesher.wasm';
      import arraysUrl from 'remesher/remesher_arrays.wasm';
      import { init as initArrays, inspect } from 'remesher/arrays';
      import type { Inspection } from 'remesher/arrays';
      import type { RemeshOptions } from 'remesher/options';
      import { Document } from '@gltf-transform/core';
      import { BufferGeometry, Group } from 'three';
      import { remesh as transform } from 'remesher/gltf-transform';
      import { Pool } from 'remesher/pool';
      import { remeshGeometry, remeshObject } from 'remesher/three';
      const options: RemeshOptions = { vertices: 10, scheme: 'rounds', featureAngle: 'off' };
      // @ts-expect-error: there is no such scheme
      const wrong: RemeshOptions = { scheme: 'fast' };
      // @ts-expect-error: there is no such option
      const unknown: RemeshOptions = { vertexes: 10 };
      const mesh = { positions: new Float32Array(9), indices: new Uint32Array(3) };
      const { mesh: { positions }, report } = await remesh(mesh, { ...options,
        onProgress: ({ phase, fraction }) => console.log(phase.length, fraction.toFixed(2)) });
      const count: number = positions.length + report.output.vertices;
      const geometry: BufferGeometry = (await remeshGeometry(new BufferGeometry())).geometry;
      const whole: RemeshReport = (await remeshObject(new Group(), { ratio: 0.5 })).report;
      const made: Document = await new Document().transform(transform({ vertices: 10 }));
      // @ts-expect-error: there is no such option here either
      transform({ vertexes: 10 });
      const pool = new Pool({ size: 2 });
      const inPool: Promise<RemeshReport> = pool.remesh(mesh, { ratio: 2 }).then((r) => r.report);
      pool.close();
      console.log(geometry, whole, made, inPool);
      const address: string = wasmUrl;
      await initArrays({ wasmUrl: arraysUrl });
      await init({ wasmUrl, arrays: { wasmUrl: arraysUrl } });
      const inspection: Inspection = await inspect(mesh);
      // @ts-expect-error: files are not for the small engine
      await inspect(new Uint8Array(8));
      console.log(inspection.input.vertices);
      const code: 'INTERNAL' | string = new RemeshError('INTERNAL', '').code;
      console.log(address, count, code, wrong, unknown);`);
    const module = resolution === 'nodenext' ? 'nodenext' : 'esnext';
    write('tsconfig.json', JSON.stringify({
      compilerOptions: {
        strict: true, noEmit: true, target: 'es2022', module, moduleResolution: resolution,
        lib: ['es2022', 'dom', 'esnext.float16'], types: [],
      },
      files: ['typed.ts'],
    }));
    call(join(root, 'node_modules/typescript-7/bin/tsc'), ['-p', 'tsconfig.json']);
  });
}
