// SPDX-License-Identifier: MIT
// Memory that ends in the middle of a run: it is said, all is free again, the next call works. The
// limit of 4 GB is made smaller, so that every stage of a run meets it in turn.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import { Engine, instantiate } from '../../dist/worker/engine.js';
import { files } from '../fuzz/made_files.js';
import { shapes } from '../fuzz/made_shapes.js';
import { withMemory } from '../support/small_memory.js';

const wasm = await readFile(new URL('../../dist/remesher.wasm', import.meta.url));
const loaded = async (/** @type {Uint8Array<ArrayBuffer>} */ bytes) =>
  ({ engine: /** @type {const} */ ('whole'), module: await WebAssembly.compile(bytes) });
const whole = await loaded(wasm);

const jobOf = (cells, vertices, output = 'made.glb') => {
  const { name, bytes } = files.textured(shapes.ball(cells));
  return { kind: 'remeshFile', file: { name, bytes, resources: [], output },
    options: { vertices } };
};
const bytesIn = ({ files: [{ bytes }] }) => Buffer.from(bytes);

test('a run that needs more memory than there is says so, and the next one works', async () => {
  const [large, small] = [jobOf(70, 1000), jobOf(3, 60)];
  const [wanted, wantedSmall] = await Promise.all([large, small].map(async (job) =>
    bytesIn(await new Engine(whole).run(job))));
  const outcomes = { done: 0, refused: 0 };
  for (let megabytes = 17; outcomes.done === 0; megabytes = Math.ceil(1.15 * megabytes)) {
    const engine = new Engine(await loaded(withMemory(wasm, megabytes)));
    try {
      assert.deepEqual(bytesIn(await engine.run(large)), wanted);
      outcomes.done += 1;
    } catch (error) {
      assert.equal(error.code, 'OUT_OF_MEMORY', `${megabytes} MB: ${error.stack}`);
      assert.match(error.message, /needs more memory than/);
      assert.ok(error.hint);
      outcomes.refused += 1;
    }
    assert.deepEqual(bytesIn(await engine.run(small)), wantedSmall, `after ${megabytes} MB`);
  }
  assert.ok(outcomes.refused > 3, JSON.stringify(outcomes));
});

test('what a run without enough memory held is free for the next, however often', async () => {
  // The instance itself, which the package would not use again.
  const instance = await instantiate(await loaded(withMemory(wasm, 24)));
  const run = (/** @type {any} */ { file, options }) =>
    instance.remeshFile(file, options, undefined);
  const most = jobOf(40, 1000);
  const wanted = bytesIn(run(most));
  for (let times = 0; times < 5; times += 1) {
    assert.equal(run(jobOf(70, 20_000)).error?.code, 'OUT_OF_MEMORY');
  }
  assert.deepEqual(bytesIn(run(most)), wanted);
});
