// SPDX-License-Identifier: MIT
// A region: only its triangles are remeshed, and all others stay bit for bit.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remesh, remeshFile } from 'remesher';

import { rejectsWith } from '../support/errors.js';
import { offText, torus } from '../support/shapes.js';

const ring = torus({ columns: 48, rows: 24 });
const run = (mesh, options) => remesh(mesh, { worker: false, ...options });

/** The triangles whose middle lies right of x. */
function rightOf({ positions, indices }, x) {
  const sum = (t) => [0, 1, 2].reduce((all, k) => all + positions[3 * indices[3 * t + k]], 0);
  return Array.from({ length: indices.length / 3 }, (_, t) => t).filter((t) => sum(t) / 3 > x);
}

/** Each triangle as the digits of its corners. */
const triangles = ({ positions, indices }) => Array.from({ length: indices.length / 3 }, (_, t) =>
  [0, 1, 2].map((k) => positions.slice(3 * indices[3 * t + k], 3 * indices[3 * t + k] + 3)
    .join()).join(' '));

test('the others stay bit for bit, and numbers are those of the whole', async () => {
  const region = rightOf(ring, 0.5);
  const outside = triangles(ring).filter((_, t) => !region.includes(t));
  for (const options of [{ vertices: 800 }, { ratio: 1.5 }, { maxEdge: 0.2 }, {}]) {
    const { mesh, report } = await run(ring, { region, ...options });
    const made = new Set(triangles(mesh));
    assert.ok(outside.every((triangle) => made.has(triangle)));
    assert.equal(report.output.boundaryEdges, 0);
    assert.equal(report.output.eulerCharacteristic, 0);
    assert.equal(report.output.vertices, mesh.positions.length / 3);
    const { vertices: before } = report.input;
    if (options.vertices) assert.equal(report.output.vertices, 800);
    if (options.ratio) assert.equal(report.output.vertices, Math.round(1.5 * before));
    if (options.maxEdge) {
      const { message } = report.warnings.find(({ code }) => code === 'EDGES_TOO_LONG');
      // Edges of the border, and some between its vertices.
      assert.match(message, /Of these, \d+ lie on borders/);
      assert.ok(report.output.wanted.maxEdge.kept > 90);
    }
  }
});

test('numbers and attributes of the others stay, if the region gets no smaller', async () => {
  const region = Uint32Array.from(rightOf(ring, 0));
  const colors = { itemSize: 3, array: Float32Array.from(ring.positions, Math.abs) };
  const { mesh } = await run({ ...ring, attributes: { COLOR_0: colors } }, { region, ratio: 2 });
  const inside = new Set(region);
  for (let t = 0; t < ring.indices.length / 3; t += 1) {
    if (inside.has(t)) continue;
    for (const v of ring.indices.subarray(3 * t, 3 * t + 3)) {
      const at = (array) => array.slice(3 * v, 3 * v + 3);
      assert.deepEqual(at(mesh.positions), at(ring.positions));
      assert.deepEqual(at(mesh.attributes.COLOR_0.array), at(colors.array));
    }
    assert.deepEqual(mesh.indices.slice(3 * t, 3 * t + 3), ring.indices.slice(3 * t, 3 * t + 3));
  }
});

test('a file has a region, too', async () => {
  const region = rightOf(ring, 1);
  const { bytes, report } = await remeshFile(new TextEncoder().encode(offText(ring)),
    { name: 'a.off', region, vertices: 1000, worker: false });
  assert.equal(report.output.vertices, 1000);
  assert.equal(report.output.boundaryEdges, 0);
  assert.ok(bytes.length > 0);
});

test('what cannot be is refused', async () => {
  const region = rightOf(ring, 0.5);
  await rejectsWith(run(ring, { region: [99999] }), 'INVALID_OPTION', /triangle 99999/);
  await rejectsWith(run(ring, { region: [] }), 'INVALID_OPTION', /triangle numbers/);
  await rejectsWith(run(ring, { region: [-1] }), 'INVALID_OPTION', /triangle numbers/);
  await rejectsWith(run(ring, { region, vertices: 100 }), 'TARGET_TOO_SMALL', /outside the region/);
  for (const other of [{ quads: true }, { repair: 'auto' }, { weld: 1 }, { lods: [0.5] }]) {
    await rejectsWith(run(ring, { region, ...other }), 'INVALID_OPTION', /exclude/);
  }
});
