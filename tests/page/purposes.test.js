// SPDX-License-Identifier: MIT
// What purposes and presets ask for, and the units of their numbers.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { ownChoices, presets, withPreset } from '../../web/model/presets.js';
import { amountOf, firstAmount, purposes, valuesFor } from '../../web/model/purposes.js';
import { lengthIn, roundLength, scaleOf, unitLike } from '../../web/model/units.js';

test('a preset keeps the visitor’s own target, and not that of a purpose', () => {
  const choices = [{ vertices: 500 }, { ratio: 0.5 }, { edgeLength: 2, textures: 'keep' },
    { vertices: 70, textures: 'bake', textureSize: 64 }];
  const subject = { triangles: 996, diagonal: 3, unit: 1, isBaked: true, isPaintable: true };
  for (const preset of presets) {
    for (const own of choices) {
      assert.deepEqual(withPreset(preset, own), { ...own, ...preset.values });
      for (const purpose of purposes) {
        const values = valuesFor(purpose, firstAmount(purpose, subject), subject);
        assert.deepEqual(ownChoices(values, own), own, purpose);
      }
    }
  }
});

test('the number of a purpose is what it was set to, in the visitor’s unit', () => {
  const subject = { triangles: 9996, diagonal: 0.094, unit: 0.001,
    isBaked: false, isPaintable: true };
  for (const purpose of purposes) {
    for (const amount of [firstAmount(purpose, subject), 300]) {
      const values = valuesFor(purpose, amount, subject, { isRepairOnly: false });
      assert.ok(Math.abs(amountOf(values, subject) / amount - 1) < 0.01, `${purpose} ${amount}`);
    }
  }
  assert.equal(firstAmount('print', subject), 0.1);  // millimetres, of 94
  assert.equal(firstAmount('simulation', subject), 1);
  assert.equal(firstAmount('asset', subject), 5000);
  assert.equal(firstAmount('asset', { ...subject, triangles: 50_000 }), 8000);
  assert.equal(firstAmount('asset', { ...subject, triangles: 3e6 }), 20_000);
  assert.equal(firstAmount('asset', { ...subject, triangles: 12 }), 12);
  assert.deepEqual(valuesFor('print', 0.1, subject),
    { purpose: 'print', work: 'repair', repair: 'auto' });
  assert.equal(valuesFor('asset', 100, { ...subject, isBaked: true }).textures, 'bake');
  assert.equal(valuesFor('asset', 100, subject).repair, undefined, 'its openings stay');
  assert.equal(valuesFor('simulation', 1, subject).repair, 'auto');
  assert.deepEqual([0.0013, 0.9, 34, 8].map(roundLength), [0.001, 1, 50, 10]);
  assert.deepEqual(scaleOf(null, 0.1), { name: 'mm', size: 0.001 });
  assert.deepEqual(scaleOf(null, 40), { name: 'm', size: 1 });
  assert.deepEqual(scaleOf('in', 40), { name: 'in', size: 1 });
});

test('a file without a unit is in millimetres where that is plain, and never in metres', () => {
  assert.deepEqual([0.02, 1.8, 9.9, 10, 100, 9000, 20_000].map(unitLike),
    ['none', 'none', 'none', 'mm', 'mm', 'mm', 'none']);
  for (const side of [0.02, 1.8, 100, 20_000]) {
    assert.doesNotMatch(lengthIn(scaleOf(unitLike(side), side), side), / m$/);
  }
  assert.equal(lengthIn(scaleOf('none', 3), 0.25), '0.25 units');
  assert.equal(lengthIn(scaleOf('mm', 100), 0.25), '0.25 mm');
});
