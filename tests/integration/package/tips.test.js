// SPDX-License-Identifier: MIT
// Quads of a bunny reach the tips of its ears.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import bunny from 'bunny';
import { remesh } from 'remesher';

/** The four corners of each quad. */
const fours = (quads) => Array.from({ length: quads.length / 4 },
  (_, i) => [...quads.subarray(4 * i, 4 * i + 4)]);

/** The mean length of the sides of quads. */
function meanSide({ positions, quads }) {
  const lengths = fours(quads).flatMap((quad) => quad.map((a, i) => {
    const b = quad[(i + 1) % 4];
    return Math.hypot(...[0, 1, 2].map((k) => positions[3 * a + k] - positions[3 * b + k]));
  }));
  return lengths.reduce((sum, length) => sum + length, 0) / lengths.length;
}

test('tips are reached: nothing is farther away than .4 sides at most counts', async () => {
  const rabbit = {
    positions: Float32Array.from(bunny.positions.flat()),
    indices: Uint32Array.from(bunny.cells.flat()),
  };
  const extents = [0, 1, 2].map((k) => {
    const along = bunny.positions.map((place) => place[k]);
    return Math.max(...along) - Math.min(...along);
  });
  const sidesAway = async (vertices) => {
    const { mesh, report } = await remesh(rabbit, { quads: true, vertices });
    return report.fidelity.hausdorff / 100 * Math.hypot(...extents) / meanSide(mesh);
  };
  for (const vertices of [1500, 3000]) {
    // Where lines of quads run beside a tip is chance: the median of three neighbouring counts.
    const away = [];
    for (const count of [vertices - 10, vertices, vertices + 10]) away.push(await sidesAway(count));
    const [, median] = away.sort((a, b) => a - b);
    assert.ok(median <= 0.4, `${vertices}: ${median.toFixed(2)} sides away`);
  }
});
