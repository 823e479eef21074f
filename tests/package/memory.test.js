// SPDX-License-Identifier: MIT
// Programs that run for months: many runs leave memory as it was, and many at once settle. The
// measure is a program of its own, for it needs flags; npm run memory does more runs.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';

import { inspect, remesh } from 'remesher';

import { octahedron, torus } from '../support/shapes.js';
import { root } from '../support/tree.js';

test('a thousand runs leave memory as it was, in the calling thread and in the worker', () => {
  const printed = execFileSync(process.execPath, ['tests/bench/memory.js', '1000'],
    { cwd: root, encoding: 'utf8', timeout: 240_000, stdio: ['ignore', 'pipe', 'inherit'] });
  const lines = printed.trim().split('\n').map((line) => JSON.parse(line));
  assert.deepEqual(lines.map(({ worker }) => worker), [false, true]);
  for (const { worker, heapPerRun, externalPerRun, instances = 1 } of lines) {
    // The smallest thing to forget, a closure in a list, has 72 bytes.
    assert.ok(heapPerRun < 40, `${heapPerRun} bytes of JavaScript’s heap a run, worker: ${worker}`);
    assert.ok(externalPerRun < 8, `${externalPerRun} bytes beside it a run, worker: ${worker}`);
    // One whose memory grows would be exchanged for another.
    assert.equal(instances, 1);
  }
});

test('what a run held is used again where it is little, given back where it is much', async () => {
  const { instantiate } = WebAssembly;
  let instances = 0;
  WebAssembly.instantiate = (...given) => {
    instances += 1;
    return instantiate.apply(WebAssembly, given);
  };
  const madeBy = async (/** @type {number} */ columns) => {
    const before = instances;
    await inspect(torus({ columns, rows: 100 }), { worker: false });
    return instances - before;
  };
  try {
    await madeBy(10);
    assert.equal(await madeBy(500), 0);
    assert.equal(await madeBy(5000), 0);
    assert.equal(await madeBy(10), 1);
    assert.equal(await madeBy(10), 0);
  } finally {
    WebAssembly.instantiate = instantiate;
  }
});

test('fifty runs at once settle, each with its own result', async () => {
  const targets = Array.from({ length: 50 }, (_, i) => 20 + i);
  const results = await Promise.all(
    targets.map((vertices) => remesh(octahedron(), { vertices, quality: 'draft' })));
  assert.deepEqual(results.map(({ mesh }) => mesh.positions.length / 3), targets);
});

test('of fifty runs at once, those that are given up settle too', async () => {
  const controllers = Array.from({ length: 50 }, () => new AbortController());
  const runs = controllers.map(({ signal }) =>
    remesh(octahedron(), { vertices: 20, quality: 'draft', signal }));
  controllers.forEach((controller, i) => i % 2 === 0 && controller.abort());
  const ends = await Promise.allSettled(runs);
  assert.deepEqual(ends.map(({ status }) => status),
    ends.map((_, i) => (i % 2 === 0 ? 'rejected' : 'fulfilled')));
});
