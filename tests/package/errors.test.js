// SPDX-License-Identifier: MIT
// Failures: one list of codes, nothing raw, and a fresh start afterwards.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import { RemeshError } from 'remesher';

import { Api } from '../../dist/api/api.js';
import { Engine, instantiate } from '../../dist/worker/engine.js';
import { errorCodes } from '../../dist/base/errors.js';
import * as platform from '../../dist/platform_node.js';
import { compileBinary, compileUrl } from '../../dist/api/wasm_source.js';
import { rejectsWith } from '../support/errors.js';
import { torus } from '../support/shapes.js';

const wasm = await readFile(new URL('../../dist/remesher.wasm', import.meta.url));
const whole =
  { engine: /** @type {const} */ ('whole'), module: await WebAssembly.compile(wasm) };

test('the codes are those of the core, in the same order', async () => {
  const instance = await instantiate(whole);
  assert.deepEqual(instance.errorCodes(), [...errorCodes]);
});

test('an error has a code, a message and a hint', () => {
  const error = new RemeshError('PARSE_ERROR', 'It is broken.', 'Mend it.');
  assert.ok(error instanceof Error);
  assert.deepEqual([error.name, error.code, error.message, error.hint],
    ['RemeshError', 'PARSE_ERROR', 'It is broken.', 'Mend it.']);
});

test('a page sent instead of WebAssembly is named as such', async () => {
  const page = new TextEncoder().encode('<!doctype html>');
  await rejectsWith(compileBinary(page, 'http://x/remesher.wasm'), 'INTERNAL', /HTML page/);
  await rejectsWith(compileBinary(new Uint8Array([1, 2, 3, 4]), 'x.wasm'), 'INTERNAL',
    /x\.wasm is not WebAssembly/);
  await rejectsWith(compileUrl('data:text/html,<html>'), 'INTERNAL', /HTML page/);
});

test('WebAssembly that is broken, not there or not ours is said to be', async () => {
  const broken = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 9, 9, 9]);
  const other = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);
  const api = new Api(platform);
  const initAnew = (options) => api.init(options);
  await rejectsWith(initAnew({ wasmBinary: broken }), 'INTERNAL', /wasmBinary is broken/);
  await rejectsWith(initAnew({ wasmUrl: 'file:///nowhere.wasm' }), 'INTERNAL', /nowhere\.wasm/);
  await rejectsWith(initAnew({ wasmUrl: 'http://[' }), 'INTERNAL', /http:\/\/\[ cannot be read/);
  await rejectsWith(initAnew({ wasmUrl: 5 }), 'INVALID_OPTION', /wasmUrl/);
  await rejectsWith(initAnew({ wasmBinary: 'bytes' }), 'INVALID_OPTION', /wasmBinary/);
  await rejectsWith(initAnew({ codecs: {} }), 'INVALID_OPTION', /remesher\/codecs/);
  await rejectsWith(initAnew({ wasmurl: 'x' }), 'UNKNOWN_OPTION', /wasmurl/);
  const mesh = torus({ columns: 8, rows: 6 });
  assert.equal((await api.inspect(mesh, { worker: false })).input.vertices, 48);
  const engine = new Engine({ ...whole, module: await WebAssembly.compile(other) });
  await rejectsWith(engine.run({ kind: 'inspect', mesh }), 'INTERNAL', /cannot be started/);
});

test('an exception from inside becomes a RemeshError, and the next run works', async () => {
  const engine = new Engine(whole);
  const mesh = torus({ columns: 8, rows: 6 });
  const poisoned = { get length() { throw new Error('no'); } };
  await rejectsWith(engine.run({ kind: 'inspect', mesh: { ...mesh, positions: poisoned } }),
    'INTERNAL', /inside WebAssembly: Error: no\./);
  const report = await engine.run({ kind: 'inspect', mesh });
  assert.equal(report.input.vertices, 48);
});

test('no call leaves an Embind handle behind, whether it succeeds or fails', async () => {
  const instance = await instantiate(whole);
  const mesh = { ...torus({ columns: 8, rows: 6 }), attributes: [] };
  const still = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  const scene = [{ mesh, places: [still] }];
  const bad = [{ mesh: { ...mesh, indices: new Uint32Array([0, 1, 99]) }, places: [] }];
  const calls = () => {
    assert.ok(instance.remesh(scene, { vertices: 60, density: new Float32Array(48).fill(1) },
      () => true).report);
    assert.equal(instance.remesh(bad, {}, undefined).error.code, 'INDEX_OUT_OF_RANGE');
    assert.equal(instance.remesh(scene, {}, () => false).error.code, 'CANCELLED');
    assert.ok(instance.inspect(mesh).input);
    const file = { name: 'x.off', bytes: new Uint8Array([79]), resources: [], output: 'x.off' };
    assert.equal(instance.remeshFile(file, {}, undefined).error.code, 'PARSE_ERROR');
  };
  calls();
  const before = instance.count_emval_handles();
  calls();
  calls();
  assert.equal(instance.count_emval_handles(), before);
});
