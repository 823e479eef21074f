// SPDX-License-Identifier: MIT
// Eight times as much of anything takes about eight times the work, not sixty-four times: reading
// and writing are linear in what a file has. Times are compared within this process only.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { convertFile, remeshFile } from 'remesher';

import { many } from '../support/many.js';

const few = 400;
const times = 8;
const mostTimes = 24; // half way between linear and quadratic, on a logarithmic scale

/** The processor's milliseconds. */
async function costOf(work) {
  const before = process.cpuUsage();
  await work();
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
}

async function compare(work, n) {
  await work(n); // compiles
  const small = Math.min(await costOf(() => work(n)), await costOf(() => work(n)));
  const large = await costOf(() => work(times * n));
  assert.ok(large < mostTimes * Math.max(small, 5), `${small} ms, ${large} ms`);
}

for (const [thing, make] of Object.entries(many)) {
  for (const output of ['b.glb', 'b.obj']) {
    test(`many ${thing}: written as ${output}`, () => compare((n) => {
      const { name, bytes, resources } = make(n);
      return convertFile(bytes, { name, resources, output, worker: false });
    }, few));
  }
}

for (const thing of ['meshes', 'animated nodes', 'primitives']) {
  test(`many ${thing}: with levels of detail`, () => compare((n) => {
    const { name, bytes } = many[thing](n);
    return remeshFile(bytes, { name, output: 'b.glb', ratio: 1, lods: [1], quality: 'draft',
      worker: false });
  }, 100));
}
