// SPDX-License-Identifier: MIT
// The calling thread stays free, and a run can be given up.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { test } from 'node:test';
import { promisify } from 'node:util';

import { init, remesh } from 'remesher';

import { Client } from '../../dist/api/client.js';
import * as platform from '../../dist/platform_node.js';
import { rejectsWith } from '../support/errors.js';
import { root } from '../support/tree.js';
import { torus } from '../support/shapes.js';

// Long enough to be interrupted: some seconds.
const large = torus({ columns: 400, rows: 200 });
const longRun = { vertices: 100_000 };
const aborted = { name: 'AbortError' };

await init();

test('the calling thread runs on while the worker works', async () => {
  let ticks = 0;
  const timer = setInterval(() => (ticks += 1), 5);
  await remesh(torus(), { vertices: 3000 });
  clearInterval(timer);
  assert.ok(ticks >= 5, `${ticks} ticks`);
});

test('an abort rejects within 100 ms, and the next run works', async () => {
  const controller = new AbortController();
  let abortedAt = 0;
  const onProgress = () => {
    if (controller.signal.aborted) return;
    abortedAt = performance.now();
    controller.abort();
  };
  await assert.rejects(
    remesh(large, { ...longRun, onProgress, signal: controller.signal }), aborted);
  const delay = performance.now() - abortedAt;
  assert.ok(delay < 100, `${delay} ms`);
  const { report } = await remesh(torus(), { vertices: 300 });
  assert.equal(report.output.vertices, 300);
});

test('an abort terminates the worker that ran, and with it frees its memory', async () => {
  const workers = [];
  const spawn = () => {
    const port = platform.spawn();
    const watched = { ...port, terminate() { watched.isTerminated = true; port.terminate(); } };
    workers.push(watched);
    return watched;
  };
  const client = new Client({ ...platform, spawn });
  const controller = new AbortController();
  const job = { kind: 'remesh', parts: [{ mesh: large }], options: longRun };
  await assert.rejects(client.run(job, [],
    { signal: controller.signal, onProgress: () => controller.abort() }), aborted);
  assert.equal(workers.length, 1);
  assert.ok(workers[0].isTerminated);
  await client.run({ kind: 'inspect', mesh: torus() }, [], {});
  assert.equal(workers.length, 2);
  assert.ok(!workers[1].isTerminated);
});

test('a signal aborted before the start never starts', async () => {
  const options = { signal: AbortSignal.abort() };
  await assert.rejects(remesh(torus(), options), aborted);
  await assert.rejects(remesh(torus(), { ...options, worker: false }), aborted);
});

test('runs wait for each other, and one that waits can be given up', async () => {
  const controller = new AbortController();
  const finished = [];
  const note = (name) => () => finished.push(name);
  const runs = [
    remesh(torus(), { vertices: 500 }).then(note('first')),
    remesh(torus(), { vertices: 400, signal: controller.signal }).catch(note('given up')),
    remesh(torus(), { vertices: 300 }).then(note('last')),
  ];
  controller.abort();
  await Promise.all(runs);
  assert.deepEqual(finished, ['given up', 'first', 'last']);
});

for (const worker of [true, false]) {
  test(`progress grows from 0 to 1 (worker: ${worker})`, async () => {
    const events = [];
    await remesh(torus(), { vertices: 3000, worker, onProgress: (event) => events.push(event) });
    assert.ok(events.length >= 2);
    for (const [i, { phase, fraction }] of events.entries()) {
      assert.equal(typeof phase, 'string');
      assert.ok(fraction >= (events[i - 1]?.fraction ?? 0) && fraction <= 1, `${fraction}`);
    }
    assert.equal(events.at(-1).fraction, 1);
  });

  test(`a listener that throws ends its run with what it threw (worker: ${worker})`, async () => {
    const thrown = new Error('enough');
    const onProgress = () => {
      throw thrown;
    };
    await assert.rejects(remesh(large, { ...longRun, worker, onProgress }), thrown);
  });
}

test('in the calling thread a listener can abort', async () => {
  const controller = new AbortController();
  const { signal } = controller;
  await assert.rejects(
    remesh(large, { ...longRun, signal, worker: false, onProgress: () => controller.abort() }),
    aborted);
});

test('where there are no workers the calling thread does the work', async () => {
  const client = new Client({ ...platform, spawn: () => undefined });
  const job = { kind: 'remesh', parts: [{ mesh: torus() }], options: { vertices: 300 } };
  const { report } = await client.run(job, [], {});
  assert.equal(report.output.vertices, 300);
});

test('a worker that dies fails its run, and the next has another', async () => {
  const ports = [];
  const spawn = () => {
    const port = platform.spawn();
    if (ports.push(port) > 1) return port;
    return { ...port, listen: (_, onFailure) => setTimeout(() => onFailure('gone'), 50) };
  };
  const client = new Client({ ...platform, spawn });
  const job = { kind: 'inspect', mesh: torus() };
  await rejectsWith(client.run(job, [], {}), 'INTERNAL', /The worker failed: gone/);
  assert.ok((await client.run(job, [], {})).input);
});

test('a program ends by itself, the worker idle', async () => {
  const program = `import { remesh } from 'remesher';
    const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
    const indices = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2]);
    const { report } = await remesh({ positions, indices }, { vertices: 50 });
    console.log(report.output.vertices);`;
  const { stdout } = await promisify(execFile)(process.execPath,
    ['--input-type=module', '-e', program], { cwd: root, timeout: 60_000 });
  assert.equal(stdout.trim(), '50');
});
