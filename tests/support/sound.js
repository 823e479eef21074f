// SPDX-License-Identifier: MIT
// What must be so of all that is repaired.
import assert from 'node:assert/strict';

import { inspect } from 'remesher';

/** @param {import('remesher').Mesh} mesh @param {string} what it is */
export async function assertSound(mesh, what) {
  const { input, faults } = await inspect(mesh, { faults: true });
  assert.deepEqual([input.boundaryEdges, input.nonManifoldEdges, input.degenerateTriangles,
    faults.selfIntersections, faults.insideOut], [0, 0, 0, 0, 0], what);
}
