// SPDX-License-Identifier: MIT
// A short gate on what the remesher is for: the shape of the triangles, the nearness to the
// original, the exact count, on shapes made by rule and on models from npm packages.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { test } from 'node:test';

import { inspect, remesh } from 'remesher';

import { drilledTorus, sheet, torus } from '../support/shapes.js';

const require = createRequire(import.meta.url);

/** The least that is good on any of these, as the best of other remeshers reach on easier ones. */
const good = { meanAngle: 54, above50: 85, valence6: 82 };

/** A model of an npm package as a mesh. */
function packaged(name) {
  const { positions, cells } = require(name);
  return { positions: new Float32Array(positions.flat()), indices: new Uint32Array(cells.flat()) };
}

/** A bar of L-shaped section, of 20 triangles, and how far a point is from the nearest side. */
function bracket({ thickness = 0.3, height = 0.5 } = {}) {
  const section = [[0, 0], [3, 0], [3, thickness], [thickness, thickness], [thickness, 2], [0, 2]];
  const positions = [0, height].flatMap((z) => section.flatMap(([x, y]) => [x, y, z]));
  const n = section.length;
  const next = (i) => (i + 1) % n;
  const caps = section.slice(2).flatMap((_, i) => [0, i + 2, i + 1, n, n + i + 1, n + i + 2]);
  const walls = section.flatMap((_, i) => [i, next(i), n + next(i), i, n + next(i), n + i]);
  const fromSides = ([x, y, z]) => Math.min(...[x, x - thickness, x - 3, y, y - thickness, y - 2,
    z, z - height].map(Math.abs));
  const indices = new Uint32Array([...caps, ...walls]);
  return { mesh: { positions: new Float64Array(positions), indices }, fromSides };
}

const run = (mesh, options) => remesh(mesh, { ...options, worker: false });

function assertGood({ report }, vertices, limits) {
  const { minAngle, valence6 } = report.output;
  assert.equal(report.output.vertices, vertices);
  assert.equal(report.output.eulerCharacteristic, report.input.eulerCharacteristic);
  assert.equal(report.output.components, report.input.components);
  assert.equal(report.output.nonManifoldEdges, 0);
  assert.ok(minAngle.mean >= limits.meanAngle, `mean minimum angle ${minAngle.mean}`);
  assert.ok(minAngle.histogram[5] >= limits.above50, `${minAngle.histogram[5]} % in 50–60°`);
  assert.ok(valence6 >= limits.valence6, `${valence6} % of valence 6`);
  assert.ok(minAngle.worst >= limits.worstAngle, `worst angle ${minAngle.worst}`);
  assert.ok(report.fidelity.hausdorff <= limits.hausdorff,
    `Hausdorff ${report.fidelity.hausdorff} %`);
}

test('a torus gets triangles as good as a sphere’s', async () => {
  // A chord of length e over a circle of radius r is e²/8r away from it: the tube's 24 edges lie
  // 0.7 % of its radius inside the torus they stand for, less than 0.1 % of the diagonal.
  const result = await run(torus(), { vertices: 4000 });
  assertGood(result, 4000,
    { ...good, meanAngle: 55, above50: 91.5, worstAngle: 30, hausdorff: 0.3 });
});

test('shafts narrower than a triangle cost few vertices, and the rest is good', async () => {
  // Each of 72 needs six vertices or more, whatever the size of triangles: what remains of 1500
  // would be as good as of any torus, at 55°, and what leads into the shafts at 15° or so.
  const { report } = await run(drilledTorus(), { vertices: 1500 });
  assert.equal(report.output.vertices, 1500);
  assert.equal(report.output.eulerCharacteristic, report.input.eulerCharacteristic);
  assert.ok(report.output.minAngle.mean >= 38, `mean minimum angle ${report.output.minAngle.mean}`);
  assert.ok(report.fidelity.rms <= 0.2, `rms ${report.fidelity.rms} %`);
});

test('an open sheet is as good along its boundary, and keeps it on request', async () => {
  const mesh = sheet();
  assertGood(await run(mesh, { vertices: 2000 }), 2000,
    { ...good, worstAngle: 20, hausdorff: 0.3 });

  const kept = await run(mesh, { vertices: 900, boundary: 'keep' });
  const places = ({ positions }) => {
    const all = [];
    for (let i = 0; i < positions.length; i += 3) all.push(positions.slice(i, i + 3).join(' '));
    return all;
  };
  const after = new Set(places(kept.mesh));
  const isOnRim = (place) => place.split(' ').slice(0, 2).some((x) => x === '0' || x === '1');
  const rim = places(mesh).filter(isOnRim);
  assert.equal(rim.length, 96);
  assert.deepEqual(rim.filter((place) => !after.has(place)), []);
});

test('models from packages get good triangles, near the original', async () => {
  assertGood(await run(packaged('bunny'), { vertices: 5000 }), 5000,
    { ...good, worstAngle: 10, hausdorff: 1 });
});

test('the planes of a bracket stay plane, and the edges between them', async () => {
  const { mesh, fromSides } = bracket();
  for (const vertices of [1000, 2500, 4000])
    for (const quality of /** @type {const} */ (['best', 'draft'])) {
      const { mesh: { positions }, report } = await run(mesh, { vertices, quality });
      let farthest = 0;
      for (let i = 0; i < positions.length; i += 3)
        farthest = Math.max(farthest, fromSides(positions.subarray(i, i + 3)));
      assert.ok(farthest < 1e-12, `${vertices} vertices, ${quality}: ${farthest}`);
      assert.ok(report.fidelity.hausdorff < 1e-9);
    }
});

test('bent sheet metal keeps its walls where edges are many times as long as they are high',
  async () => {
    const { mesh } = bracket({ thickness: 0.05, height: 3 });
    for (const vertices of [200, 350, 600])
      for (const quality of /** @type {const} */ (['best', 'draft'])) {
        const { report } = await run(mesh, { vertices, quality });
        assert.equal(report.output.vertices, vertices);
        assert.ok(report.fidelity.hausdorff < 1e-9,
          `${vertices} vertices, ${quality}: ${report.fidelity.hausdorff} %`);
      }
  });

test('a thin ring stays round where its tube is a few edges around', async () => {
  const tube = 0.05;
  const mesh = torus({ columns: 96, rows: 16, radius: 1, tube });
  const diagonal = 2 * Math.hypot(1 + tube, 1 + tube, tube);
  for (const vertices of [400, 600, 800, 1000])
    for (const quality of /** @type {const} */ (['best', 'draft'])) {
      const { report } = await run(mesh, { vertices, quality });
      const off = (report.fidelity.hausdorff / 100) * diagonal;
      assert.ok(off < tube / 2, `${vertices} vertices, ${quality}: ${off} of ${tube}`);
    }
});

test('a draft keeps every promise, and is near what it is a draft of', async () => {
  const mesh = packaged('bunny');
  const draft = await run(mesh, { vertices: 5000, quality: 'draft' });
  assertGood(draft, 5000, { ...good, meanAngle: 53, above50: 80, worstAngle: 10, hausdorff: 2 });

  const names = (/** @type {typeof draft} */ { report }) => report.phases.map(({ name }) => name);
  const best = await run(mesh, { vertices: 5000, quality: 'best' });
  assert.ok(names(best).includes('lower Hausdorff'));
  assert.ok(!names(draft).includes('lower Hausdorff'));
  const { report: { fidelity } } = draft;
  assert.ok(fidelity.rms < 1.7 * best.report.fidelity.rms, `rms ${fidelity.rms}`);
});

test('rounds, the report’s algorithm, is better than what it is given', async () => {
  const mesh = packaged('bunny');
  const { report } = await run(mesh, { vertices: 4000, scheme: 'rounds' });
  const { minAngle: before } = report.input;
  const { minAngle: after } = report.output;
  assert.equal(report.output.vertices, 4000);
  assert.ok(after.mean > before.mean, `${after.mean} > ${before.mean}`);
  assert.ok(after.histogram[5] > 2 * before.histogram[5], `${after.histogram[5]} % in 50–60°`);
  assert.ok(after.worst >= 15, `worst angle ${after.worst}`);
});

test('the report of an inspection is that of the mesh', async () => {
  const report = await inspect(torus({ columns: 20, rows: 10 }));
  const mesh = report.input ?? report;
  assert.equal(mesh.vertices, 200);
  assert.equal(mesh.eulerCharacteristic, 0);
});
