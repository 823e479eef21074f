// SPDX-License-Identifier: MIT
// Asserts how a failure must look to a caller.
import assert from 'node:assert/strict';

import { RemeshError } from 'remesher';

/** Rejects with a RemeshError of this code whose message is a sentence matching the pattern. */
export async function rejectsWith(promise, code, pattern = /./) {
  await assert.rejects(promise, (error) => {
    assert.ok(error instanceof RemeshError, `a RemeshError, not ${error}`);
    assert.equal(error.code, code, error.message);
    assert.match(error.message, pattern);
    assert.match(error.message, /\.$/, 'a sentence ends with a full stop');
    return true;
  });
}
