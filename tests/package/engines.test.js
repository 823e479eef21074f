// SPDX-License-Identifier: MIT
// Two engines: arrays take the small one, files the whole one, both give the same bytes, and
// nobody holds what is not needed; tests/integration/loaded_engines.test.js looks at what is
// loaded.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { brotliCompressSync, constants } from 'node:zlib';

import { Api } from '../../dist/api/api.js';
import { Client } from '../../dist/api/client.js';
import { Modules, thinnedAbove } from '../../dist/api/modules.js';
import * as platform from '../../dist/platform_node.js';
import { Engine } from '../../dist/worker/engine.js';
import { rejectsWith } from '../support/errors.js';
import { octahedron, offText, signetRing, torus } from '../support/shapes.js';
import { readText, root } from '../support/tree.js';

const files = { arrays: 'remesher_arrays.wasm', whole: 'remesher.wasm' };
const pathOf = (/** @type {string} */ file) => join(root, 'dist', file);

// In kB, with brotli, as servers send them: what is promised, and no more.
const largest = { arrays: 329, whole: 873 };

for (const [engine, file] of Object.entries(files)) {
  test(`${file} is as small as is promised`, () => {
    const packed = brotliCompressSync(readFileSync(pathOf(file)),
      { params: { [constants.BROTLI_PARAM_QUALITY]: 11 } });
    assert.ok(packed.length <= 1000 * largest[engine], `${packed.length} bytes`);
  });
}

const engineOf = async (/** @type {'arrays' | 'whole'} */ engine) =>
  new Engine({ engine, module: await WebAssembly.compile(readFileSync(pathOf(files[engine]))) });
const engines = { arrays: await engineOf('arrays'), whole: await engineOf('whole') };

/** Without what a clock and the memory say. */
const lasting = ({ report, input, ...others }) => ({ ...others, input,
  report: report && { ...report, timings: 0, phases: 0, memory: 0,
    lods: report.lods?.map((lod) => ({ ...lod, timings: 0, phases: 0, memory: 0 })) } });

const still = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const ring = torus({ columns: 32, rows: 16 });
const count = ring.positions.length / 3;
const dressed = { ...ring,
  attributes: { COLOR_0: { itemSize: 3, array: ring.positions.map((x) => Math.abs(x) % 1) } },
  groups: Uint32Array.from({ length: ring.indices.length / 3 }, (_, i) => (i < 300 ? 0 : 1)) };
const scenes = {
  'by default': [[{ mesh: ring }], { vertices: 400 }],
  'by rounds': [[{ mesh: ring }], { vertices: 300, scheme: 'rounds', splitObtuse: true }],
  'in a draft': [[{ mesh: ring }], { ratio: 2, quality: 'draft' }],
  'within a bound': [[{ mesh: ring }], { vertices: 300, maxError: 1 }],
  'with attributes and groups': [[{ mesh: dressed }], { vertices: 350 }],
  'by a density': [[{ mesh: ring }],
    { vertices: 300, density: new Float32Array(count).map((_, i) => 1 + (i % 7)) }],
  'by levels of detail': [[{ mesh: ring }], { vertices: 400, lods: Float64Array.of(0.5, 0.25) }],
  'with sharp edges, as a scene': [[{ mesh: signetRing(), places: [still, still] },
    { mesh: octahedron(), places: [still] }], { vertices: 500 }],
};

for (const [name, [parts, options]] of Object.entries(scenes)) {
  test(`both engines give the same ${name}`, async () => {
    const job = { kind: 'remesh', parts, options };
    const [small, whole] = [await engines.arrays.run(job), await engines.whole.run(job)];
    assert.ok(small.meshes.every(({ indices }) => indices.length > 0));
    assert.deepEqual(lasting(small), lasting(whole));
  });
}

test('both engines inspect, and refuse, in the same words', async () => {
  const jobs = [{ kind: 'inspect', mesh: { ...ring, indices: Uint32Array.of(0, 1, count) } },
    { kind: 'remesh', parts: [{ mesh: ring }], options: { vertices: 2 } },
    { kind: 'remesh', parts: [{ mesh: ring }], options: { textures: 'bake' } }];
  for (const job of jobs) {
    const [small, whole] = await Promise.all(['arrays', 'whole'].map((engine) =>
      engines[engine].run(job).then(() => assert.fail(), (error) => error)));
    assert.deepEqual([small.code, small.message, small.hint],
      [whole.code, whole.message, whole.hint]);
  }
  const job = { kind: 'inspect', mesh: ring };
  assert.deepEqual((await engines.arrays.run(job)).input, (await engines.whole.run(job)).input);
});

/** An Api in the calling thread that notes what it compiles. @param {object} [others] */
function notingApi(others = {}) {
  /** @type {string[]} */
  const compiled = [];
  const noting = (name, compile) => () => {
    compiled.push(name);
    return compile();
  };
  const own = { ...platform, spawn: () => undefined,
    compileArrays: noting('arrays', platform.compileArrays),
    compileWhole: noting('whole', platform.compileWhole), ...others };
  return { api: new Api(own, new Client(own)), compiled };
}

const bytes = new TextEncoder().encode(offText(octahedron()));
const named = { name: 'octahedron.off', output: 'octahedron.obj', vertices: 30 };

test('init loads the whole engine, or with `arrays` the small one', async () => {
  const plain = notingApi();
  await plain.api.init();
  await plain.api.remesh(octahedron(), { vertices: 30 });
  assert.deepEqual(plain.compiled, ['whole']);
  const small = notingApi();
  await small.api.init({ arrays: {} });
  await small.api.remesh(octahedron(), { vertices: 30 });
  assert.deepEqual(small.compiled, ['arrays']);
});

test('init names where both engines are', async () => {
  const wasmBinary = readFileSync(pathOf(files.arrays));
  const { api, compiled } = notingApi({ compileUrl: (url) => {
    compiled.push(url);
    return platform.compileWhole();
  } });
  await api.init({ wasmUrl: 'the whole', arrays: { wasmBinary } });
  await api.remesh(octahedron(), { vertices: 30 });
  assert.deepEqual(compiled, []);
  await api.remeshFile(bytes, named);
  await api.remesh(octahedron(), { vertices: 30 });
  assert.deepEqual(compiled, ['the whole']);
});

test('huge meshes take the engine that thins them out, where it is to be had', () => {
  const jobOf = (/** @type {number} */ triangles) => ({ kind: /** @type {const} */ ('remesh'),
    options: { vertices: 30 },
    parts: [{ mesh: { ...octahedron(), indices: new Uint32Array(3 * triangles) } }] });
  const modules = new Modules(platform.compileArrays);
  assert.equal(modules.engineFor(jobOf(thinnedAbove + 1)), 'arrays');
  modules.offer('whole', platform.compileWhole);
  assert.equal(modules.engineFor(jobOf(thinnedAbove)), 'arrays');
  assert.equal(modules.engineFor(jobOf(thinnedAbove + 1)), 'whole');
  const [, digits] = /triangles = ([\d']+)/.exec(readText('src/jobs/thinned_parts.h')) ?? [];
  assert.equal(Number(digits.replaceAll("'", '')), thinnedAbove);
});

test('what names no engine is refused', async () => {
  const { api } = notingApi();
  await rejectsWith(api.init({ arrays: { url: 'x' } }), 'UNKNOWN_OPTION', /url/);
  await rejectsWith(api.init({ arrays: { wasmUrl: 5 } }), 'INVALID_OPTION', /wasmUrl/);
  await rejectsWith(api.init({ arrays: true }), 'INVALID_OPTION', /object/);
  await rejectsWith(api.init({ arrays: { wasmUrl: 'file:///nowhere.wasm' } }), 'INTERNAL',
    /nowhere\.wasm/);
});

test('beside scripts without the small engine the whole one does its work', async () => {
  const { api, compiled } = notingApi({ compileArrays: () => Promise.reject(new Error('404')) });
  assert.equal((await api.remesh(octahedron(), { vertices: 30 })).report.output.vertices, 30);
  assert.deepEqual(compiled, ['whole']);
});

test('whoever has both holds one, in the calling thread and in a worker', () => {
  const printed = execFileSync(process.execPath, ['--expose-gc', 'tests/support/held_engines.js'],
    { cwd: root, encoding: 'utf8', timeout: 120_000 });
  const one = { made: 2, held: 1 };
  assert.deepEqual(JSON.parse(printed), { here: one, worker: one });
});
