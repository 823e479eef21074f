// SPDX-License-Identifier: MIT
// Repair of what takes longer: far from the origin, thin walls, cases that broke a law once.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remesh, repair } from 'remesher';

import { makeRepairCase, runRepairCase } from '../../fuzz/repair_case.js';
import { thinHouse } from '../../support/broken_shapes.js';
import { rejectsWith } from '../../support/errors.js';
import { torus } from '../../support/shapes.js';
import { assertSound } from '../../support/sound.js';

test('far from the origin, where single precision has few digits, all of it is sound', async () => {
  const torusAt = (/** @type {number} */ offset) => {
    const { positions, indices } = torus({ columns: 12, rows: 8 });
    return { positions: positions.map((x, i) => (i % 3 === 0 ? x + offset : x)), indices };
  };
  await rejectsWith(repair(torusAt(1e8), { repair: 'wrap' }), 'NO_TRIANGLES', /too small/);
  for (const offset of [8e4, 1e6]) {
    const shape = torusAt(offset);
    await assertSound((await repair(shape, { repair: 'wrap' })).mesh, `repaired, ${offset}`);
    const { mesh } = await remesh(shape, { repair: 'wrap', vertices: 900 });
    await assertSound(mesh, `remeshed, ${offset}`);
  }
});

// Sheets back to back of which scraps remain, and three that lie far away.
for (const seed of [14, 40, 44, 50]) {
  test(`case ${seed} of the laws, which broke one`, async () => {
    assert.deepEqual((await runRepairCase(makeRepairCase(seed))).broken, []);
  });
}

test('rooms with walls thinner than the lattice are filled as others are', async () => {
  for (const vertices of [2000, 8000]) {
    const { report } = await remesh(thinHouse(), { repair: 'auto', vertices, quality: 'draft' });
    assert.equal(report.output.components, 1, `${vertices}`);
  }
});
