// SPDX-License-Identifier: MIT
// Limits of every edge and triangle: they are kept, or the report says where they are not, and its
// figures are those of the mesh that comes back.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remesh, remeshFile } from 'remesher';
import { optionTable } from 'remesher/options';

import { reportInWords } from '../../dist/cli/report_in_words.js';
import { rejectsWith } from '../support/errors.js';
import { offText, sheetOf, torus } from '../support/shapes.js';

const ring = torus({ columns: 48, rows: 24 });
const run = (mesh, options) => remesh(mesh, { worker: false, ...options });

/** The sides of a box, divided into cells. */
function box([width, depth, height], cells) {
  const size = [width, depth, height];
  const [positions, indices] = [[], []];
  for (let side = 0; side < 6; side += 1) {
    const axis = side % 3;
    const face = sheetOf(cells, (i, k) => {
      const at = [side < 3 ? 0 : 1, ...(side < 3 ? [k, i] : [i, k]).map((x) => x / cells)];
      return [0, 1, 2].map((d) => size[d] * at[(d - axis + 3) % 3]);
    });
    const first = positions.length / 3;
    positions.push(...face.positions);
    indices.push(...face.indices.map((v) => first + v));
  }
  return { positions: new Float64Array(positions), indices: new Uint32Array(indices) };
}

/** What the report must say of a mesh. */
function measured({ positions, indices }) {
  const at = (i) => positions.subarray(3 * indices[i], 3 * indices[i] + 3);
  const length = (i, k) => Math.hypot(...at(i).map((x, d) => x - at(k)[d]));
  let [shortest, longest, angle] = [Infinity, 0, 180];
  for (let i = 0; i < indices.length; i += 3) {
    const sides = [length(i, i + 1), length(i + 1, i + 2), length(i + 2, i)].sort((a, b) => a - b);
    [shortest, longest] = [Math.min(shortest, sides[0]), Math.max(longest, sides[2])];
    const cosine = (sides[1] ** 2 + sides[2] ** 2 - sides[0] ** 2) / (2 * sides[1] * sides[2]);
    angle = Math.min(angle, Math.acos(Math.min(1, cosine)) * 180 / Math.PI);
  }
  return { shortest, longest, angle };
}

const near = (a, b) => assert.ok(Math.abs(a - b) <= 1e-5 * Math.abs(b), `${a}, not ${b}`);

test('a longest edge alone leads the number of vertices, and is kept', async () => {
  const counts = [];
  for (const maxEdge of [0.5, 0.3]) {
    for (const mesh of [ring, box([3, 2, 1], 4)]) {
      const { mesh: made, report } = await run(mesh, { maxEdge });
      const { wanted, vertices } = report.output;
      near(wanted.maxEdge.worst, measured(made).longest);
      assert.ok(wanted.maxEdge.worst <= maxEdge);
      assert.deepEqual([wanted.maxEdge.missed, wanted.maxEdge.kept, wanted.maxEdge.at],
        [0, 100, undefined]);
      assert.ok(!report.warnings.some(({ code }) => code.startsWith('EDGES_')));
      counts.push(vertices);
    }
  }
  const area = 2 * Math.PI * 2 * 2 * Math.PI * 0.8;  // of the ring
  const fewest = 2 * area / (Math.sqrt(3) * 0.3 ** 2);
  assert.ok(counts[2] > 2 * counts[0] && counts[2] < 3 * fewest, `${counts}`);
});

test('shortest and longest edges and angles are kept together', async () => {
  const limits = { minEdge: 0.12, maxEdge: 0.35, minAngle: 25 };
  for (const mesh of [ring, box([3, 2, 1], 4)]) {
    const { mesh: made, report } = await run(mesh, limits);
    const { minEdge, maxEdge, minAngle } = report.output.wanted;
    const { shortest, longest, angle } = measured(made);
    near(minEdge.worst, shortest);
    near(maxEdge.worst, longest);
    near(minAngle.worst, angle);
    for (const { missed } of [minEdge, maxEdge, minAngle]) assert.equal(missed, 0);
  }
});

test('what the input rules out is said, with its place, its number and the reason', async () => {
  const { report } = await run(box([2, 2, 0.1], 2), { minEdge: 0.15, maxEdge: 0.5 });
  const { minEdge, maxEdge } = report.output.wanted;
  assert.equal(maxEdge.missed, 0);
  assert.ok(minEdge.missed >= 4 && minEdge.worst <= 0.1 + 1e-6 && minEdge.kept < 100);
  assert.ok(minEdge.at[2] > 0 && minEdge.at[2] < 0.1, `${minEdge.at}`);
  const { message, count, at } = report.warnings.find(({ code }) => code === 'EDGES_TOO_SHORT');
  assert.match(message, /shorter than 0\.15, the shortest 0\.1, near \(.*\)\. Of these, \d+ lie/);
  assert.deepEqual([count, at], [minEdge.missed, minEdge.at]);
  assert.match(reportInWords({ ...report, unit: 'cm' }), /edges at most 0\.5 cm: all/);
  assert.match(reportInWords({ ...report, unit: undefined }), /edges at most 0\.5: all/);
});

test('a number of vertices is kept, and the report says what it does not allow', async () => {
  const { report } = await run(ring, { vertices: 300, maxEdge: 0.3 });
  assert.equal(report.output.vertices, 300);
  assert.ok(report.output.wanted.maxEdge.missed > 0);
  const { message } = report.warnings.find(({ code }) => code === 'EDGES_TOO_LONG');
  assert.match(message, /does not allow it: about \d+ would/);
  const { report: fit } = await run(ring, { vertices: 900, minAngle: 30 });
  assert.equal(fit.output.vertices, 900);
  assert.equal(fit.output.wanted.minAngle.missed, 0);
});

test('files: lengths have units, and the figures are those of the file', async () => {
  const bytes = new TextEncoder().encode(offText(ring));
  const { bytes: made, report } = await remeshFile(bytes, { name: 'a.off', output: 'stl',
    units: 'cm', maxEdge: '4mm', minAngle: 20, worker: false });
  const { input } = await inspect(made, { name: 'a.stl' });
  assert.equal(report.output.wanted.maxEdge.asked, 0.4);
  assert.equal(report.output.wanted.maxEdge.missed, 0);
  near(input.minAngle.worst, report.output.wanted.minAngle.worst);
});

test('limits that contradict each other, or other options, are refused', async () => {
  await rejectsWith(run(ring, { minEdge: 2, maxEdge: 1 }), 'INVALID_OPTION', /longer than maxEdge/);
  for (const other of [{ quads: true }, { scheme: 'rounds' }, { prefer: 'shape' },
    { splitObtuse: true }, { lods: [0.5] }]) {
    await rejectsWith(run(ring, { maxEdge: 1, ...other }), 'INVALID_OPTION', /exclude/);
  }
  assert.ok(optionTable.some(({ flag }) => flag === '--min-angle D'));
});
