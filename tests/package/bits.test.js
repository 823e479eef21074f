// SPDX-License-Identifier: MIT
// Chromium gives the bytes that Node gives, for every model and every set of options, each with
// some of the others; npm run bits has them all, and Firefox.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inChromium, inNode } from '../bits/engines.js';
import { jobs, models, optionSets } from '../bits/models.js';

const some = jobs.filter((_, i) => i % (optionSets.length + 1) === 0);

test('twenty models, five sets of options: the same bytes in Chromium', async () => {
  assert.equal(Object.keys(models).length, 20);
  assert.equal(optionSets.length, 5);
  const wanted = await inNode(some);
  assert.equal(new Set(wanted).size, some.length, 'every job has a result of its own');
  assert.deepEqual(await inChromium(some), wanted);
});
