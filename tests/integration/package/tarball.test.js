// SPDX-License-Identifier: MIT
// The tarball as linters of packages and TypeScript see it.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { call as callIn, freshProject, linkPeers } from '../../support/fresh_project.js';
import { root } from '../../support/tree.js';

const { folder, tarball, write, remove } = freshProject();
after(remove);

const call = (command, words) => callIn(command, words, folder);

test('what lints packages has nothing to say', () => {
  const linted = (name, words) => call(process.execPath,
    [join(root, 'node_modules', name), ...words]);
  const tar = join(folder, tarball.filename);
  assert.match(linted('publint/src/cli.js', ['run', '--strict', tar]), /All good!/);
  // There is no CommonJS: require() works from Node 20.19 on, and is tested with the bundlers.
  linted('@arethetypeswrong/cli/dist/index.js', [tar, '--profile', 'esm-only', '--quiet']);
});

for (const resolution of ['nodenext', 'bundler']) {
  test(`a TypeScript program finds the types (${resolution})`, () => {
    linkPeers(folder);
    write('typed.ts', `
      import { init, remesh, remeshFile, RemeshError } from 'remesher';
      import { cardRows, cardText } from 'remesher/card';
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
      const { report: { card } } = await remeshFile(new Uint8Array(8), { vertices: 10 });
      const page: string = cardText(card, { language: 'de', title: 'a' });
      // @ts-expect-error: there is no card in that language
      cardRows(card, 'xx');
      const geometry: BufferGeometry = (await remeshGeometry(new BufferGeometry())).geometry;
      const whole: RemeshReport = (await remeshObject(new Group(), { ratio: 0.5 })).report;
      const made: Document = await new Document().transform(transform({ vertices: 10 }));
      // @ts-expect-error: there is no such option here either
      transform({ vertexes: 10 });
      const pool = new Pool({ size: 2 });
      const inPool: Promise<RemeshReport> = pool.remesh(mesh, { ratio: 2 }).then((r) => r.report);
      pool.close();
      console.log(page, geometry, whole, made, inPool);
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
