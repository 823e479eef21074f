// SPDX-License-Identifier: MIT
// Flat sides of machine parts stay flat, to the last digit, whatever number of vertices is asked
// for; hard edges that only normals tell of stay edges.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remesh } from 'remesher';

const run = (mesh, options) => remesh(mesh, { ...options, worker: false });

/** A convex outline drawn out along x. @param {number[][]} outline @param {number} length */
function extruded(outline, length) {
  const n = outline.length;
  const positions = [0, length].flatMap((x) => outline.flatMap(([y, z]) => [x, y, z]));
  const sides = outline.flatMap((_, i) => {
    const next = (i + 1) % n;
    return [i, n + next, next, i, n + i, n + next];
  });
  const ends = outline.slice(2).flatMap((_, i) =>
    [0, i + 2, i + 1, n, n + i + 1, n + i + 2]);
  return { positions: new Float32Array(positions), indices: new Uint32Array([...sides, ...ends]) };
}

/** A bar whose flat bottom, 60 by 28, runs into fillets of radius 6. */
function filletedBar(facets = 6) {
  const arc = (y, from) => Array.from({ length: facets + 1 }, (_, i) => {
    const turn = from + Math.PI / 2 * i / facets;
    return [y + 6 * Math.cos(turn), 6 + 6 * Math.sin(turn)];
  });
  return extruded([...arc(34, -Math.PI / 2), [40, 16], [0, 16], ...arc(6, -Math.PI)], 60);
}

/** The area of the triangles whose corners all satisfy a condition. */
function areaWhere({ positions, indices }, holds) {
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) =>
      Array.from(positions.subarray(3 * indices[i + k], 3 * indices[i + k] + 3)));
    if (![a, b, c].every(holds)) continue;
    const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
    sum += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return sum;
}

for (const quality of ['best', 'draft'])
  test(`a flat bottom that runs into fillets stays flat, ${quality}`, async () => {
    const mesh = filletedBar();
    for (const vertices of [200, 600, 2000]) {
      const result = await run(mesh, { vertices, quality });
      assert.equal(result.report.output.vertices, vertices);
      const area = areaWhere(result.mesh, ([, , z]) => z === 0);
      assert.ok(Math.abs(area - 60 * 28) < 1e-3, `${area} of ${60 * 28} at ${vertices}`);
      assert.ok(result.mesh.positions.every((x, i) => i % 3 < 2 || x >= 0), 'nothing below it');
    }
  });

test('normals that part at a blunt ridge make it an edge', async () => {
  // Two flat sides, 25° between them, of a roof of 8 × 8 cells, each side with its own normals.
  const slope = Math.tan(12.5 * Math.PI / 180);
  const [positions, normals, indices] = [[], [], []];
  for (const side of [-1, 1]) {
    const first = positions.length / 3;
    for (let x = 0; x <= 4; ++x)
      for (let y = 0; y <= 8; ++y) {
        positions.push(side * x, y, -slope * x);
        normals.push(side * Math.sin(12.5 * Math.PI / 180), 0, Math.cos(12.5 * Math.PI / 180));
      }
    for (let x = 0; x < 4; ++x)
      for (let y = 0; y < 8; ++y) {
        const a = first + 9 * x + y;
        const cells = [a, a + 9, a + 10, a, a + 10, a + 1];
        indices.push(...(side > 0 ? cells : cells.toReversed()));
      }
  }
  const mesh = { positions: new Float32Array(positions), indices: new Uint32Array(indices),
    attributes: { NORMAL: { array: new Float32Array(normals), itemSize: 3 } } };
  const { mesh: result } = await run(mesh, { vertices: 300 });
  const normal = result.attributes.NORMAL.array;
  const upright = Math.cos(12.5 * Math.PI / 180);
  for (let i = 2; i < normal.length; i += 3)
    assert.ok(Math.abs(normal[i] - upright) < 1e-5, 'each side is shaded flat');
  assert.ok(areaWhere(result, ([x]) => x >= 0) > 0);
  for (let i = 0; i < result.indices.length; i += 3) {
    const xs = [0, 1, 2].map((k) => result.positions[3 * result.indices[i + k]]);
    assert.ok(Math.min(...xs) >= 0 || Math.max(...xs) <= 0, 'no triangle lies across the ridge');
  }
});
