// SPDX-License-Identifier: MIT
// More of the random cases of tests/house/laws.test.js, and those of them that take seconds.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { makeCase } from '../fuzz/cases.js';
import { makeQuadsCase } from '../fuzz/quads_case.js';
import { makeRepairCase, runRepairCase } from '../fuzz/repair_case.js';
import { runCase } from '../fuzz/run_case.js';

const [first, last] = [209, 298];

for (let seed = first; seed <= last; seed += 1) {
  const input = makeCase(seed);
  test(`case ${seed}: ${input.description}`, async () => {
    assert.deepEqual((await runCase(input, { repeats: seed % 8 === 0 })).broken, []);
  });
}

for (const seed of [2, 3, 6]) {
  const input = makeQuadsCase(seed);
  test(`quads, case ${seed}: ${input.description}`, async () => {
    assert.deepEqual((await runCase(input, { repeats: false })).broken, []);
  });
}

for (const seed of [1, 3, 4, 5, 7, 8, 9, 10, 12]) {
  const input = makeRepairCase(seed);
  test(`repair, case ${seed}: ${input.description}`, async () => {
    assert.deepEqual((await runRepairCase(input)).broken, []);
  });
}
