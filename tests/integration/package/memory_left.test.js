// SPDX-License-Identifier: MIT
// Programs that run for months: many runs leave memory as it was. The measure is a program of its
// own, for it needs flags; npm run memory does more runs.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';

import { root } from '../../support/tree.js';

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
