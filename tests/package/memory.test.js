// SPDX-License-Identifier: MIT
// Programs that run for months: what a run held is used again or given back, and many at once
// settle. tests/integration/package/memory_left.test.js measures what a thousand runs leave.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remesh } from 'remesher';

import { octahedron, torus } from '../support/shapes.js';

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
