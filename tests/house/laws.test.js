// SPDX-License-Identifier: MIT
// What must hold of every run, tried on random cases: surfaces good and bad, as arrays and as files
// good and bad, with random options. tests/integration/laws.test.js has more of them, and npm run
// laws tries others.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remesh } from 'remesher';

import { makeCase } from '../fuzz/cases.js';
import { makeInvarianceCase, runInvarianceCase } from '../fuzz/invariance_case.js';
import { makeQuadsCase } from '../fuzz/quads_case.js';
import { makeRepairCase, runRepairCase } from '../fuzz/repair_case.js';
import { runCase } from '../fuzz/run_case.js';
import { commandOf, makeHarmCase, makeSaidCase, runTrustCase } from '../fuzz/trust_case.js';
import { lawsOfErrors, lawsOfFiles, lawsOfMeshes, lawsOfQuads, lawsOfReports }
  from '../support/laws.js';
import { files } from '../fuzz/made_files.js';
import { shapes } from '../fuzz/made_shapes.js';

test('a broken law is noticed', async () => {
  const side = { vertices: 8, components: 1, boundaryEdges: 0, nonManifoldEdges: 0,
    eulerCharacteristic: 2, degenerateTriangles: 0, minAngle: { worst: 20 } };
  const report = { input: side, output: side, fidelity: { hausdorff: 1 }, warnings: [],
    stopped: 'target' };
  assert.deepEqual(lawsOfReports(report, { vertices: 8, maxError: 2 }), []);
  assert.match(lawsOfReports(report, { vertices: 9 })[0], /8 vertices instead of 9/);
  assert.match(lawsOfReports(report, { maxError: 0.5 })[0], /1 % away/);
  const worse = { boundaryEdges: 3, nonManifoldEdges: 1, components: 2, eulerCharacteristic: 3,
    degenerateTriangles: 1 };
  assert.equal(lawsOfReports({ ...report, output: { ...side, ...worse } }, {}).length, 5);
  const said = ['NON_MANIFOLD_EDGES_SPLIT', 'NON_MANIFOLD_EDGES_MADE', 'SURFACE_OPENED']
    .map((code) => ({ code, message: 'The first near (0, 0, 0).' }));
  const output = { ...side, boundaryEdges: 3, nonManifoldEdges: 1 };
  assert.deepEqual(lawsOfReports({ ...report, output, warnings: said }, {}), []);
  assert.equal(lawsOfReports({ ...report, output, warnings: said.slice(1) }, {}).length, 2);
  assert.equal(lawsOfReports({ ...report, output, warnings: said.slice(0, 1) }, {}).length, 2);
  const lost = { ...report, output: { ...side, degenerateTriangles: 2 } };
  const made = { code: 'DEGENERATE_TRIANGLES_MADE', message: 'As near (0, 0, 0).' };
  assert.match(lawsOfReports({ ...lost, warnings: [made] }, {})[0], /2 degenerate triangles/);
  const rounded = [made, { code: 'VERTICES_COINCIDE', message: 'They do.' }];
  assert.deepEqual(lawsOfReports({ ...lost, warnings: rounded }, {}), []);
  assert.match(lawsOfReports({ ...report, fidelity: { hausdorff: 101 } }, {})[0], /101 % of/);
  assert.match(lawsOfErrors({ code: 'INTERNAL', message: 'Oh.' })[0], /INTERNAL/);
  assert.match(lawsOfErrors({ code: 'PARSE_ERROR', message: 'Oh' })[0], /not a sentence/);
  assert.match(lawsOfErrors(new TypeError('Oh'))[0], /not a RemeshError/);
  const mesh = { positions: Float32Array.of(0, 0, NaN), indices: Uint32Array.of(0, 0, 1),
    attributes: { NORMAL: { array: Float32Array.of(0, 0, 2), itemSize: 3 } } };
  assert.equal(lawsOfMeshes(mesh).length, 3);
  const good = files.skinned(shapes.ball(1));
  const bad = files.skinned(shapes.ball(1));
  bad.bytes = Uint8Array.from(Buffer.from(Buffer.from(bad.bytes).toString('latin1')
    .replace('"joints":[1,2,3]', '"joints":[1]    '), 'latin1'));
  assert.deepEqual(await lawsOfFiles(good, good), []);
  const words = new TextEncoder().encode('v 0 nan 0\n');
  assert.match((await lawsOfFiles(good, { name: 'a.obj', bytes: words }))[0], /not finite/);
  assert.match((await lawsOfFiles(good, bad))[0], /ACCESSOR_JOINTS_INDEX_OOB/);
});

test('a broken law of quads is noticed', () => {
  // A cube, and the cube without its last side.
  const positions = Float32Array.from([0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) =>
    [i & 1, i >> 1 & 1, i >> 2]));
  const cube = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 1, 3, 7, 5, 3, 2, 6, 7, 2, 0, 4, 6];
  const mesh = (/** @type {number[]} */ quads) => ({ positions, quads: Uint32Array.from(quads),
    indices: Uint32Array.from({ length: 6 * quads.length / 4 }, () => 0) });
  assert.deepEqual(lawsOfQuads(mesh(cube)), []);
  assert.deepEqual(lawsOfQuads(mesh(cube.slice(4))), []);
  assert.match(lawsOfQuads(mesh([0, 2, 3, 0]))[0], /equal corners/);
  assert.match(lawsOfQuads(mesh([0, 1, 3, 2, 0, 2, 3, 1]))[0], /4 inner vertices of two quads/);
  assert.match(lawsOfQuads({ ...mesh(cube), indices: new Uint32Array(39) })[0], /of no quad/);
  const side = { vertices: 101, components: 1, boundaryEdges: 0, nonManifoldEdges: 0,
    eulerCharacteristic: 2, degenerateTriangles: 0, minAngle: { worst: 20 } };
  const report = { input: side, output: side, warnings: [], stopped: 'target' };
  assert.deepEqual(lawsOfReports(report, { vertices: 100, quads: true }), []);
  assert.match(lawsOfReports(report, { vertices: 100, quads: true, exact: true })[0], /101 vert/);
});

test('a star of 8,000 triangles around one vertex is as good as any surface', async () => {
  const count = 8_000;
  const turn = (i) => (2 * Math.PI * i) / count;
  const positions = Float64Array.from([0, 0, 0, ...Array.from({ length: count }, (_, i) =>
    [Math.cos(turn(i)), Math.sin(turn(i)), 0]).flat()]);
  const indices = Uint32Array.from(Array.from({ length: count }, (_, i) =>
    [0, i + 1, (i + 1) % count + 1]).flat());
  for (const vertices of [count + 1, 1000]) {
    const options = { vertices, scheme: 'rounds' };
    const { mesh, report } = await remesh({ positions, indices }, options);
    assert.deepEqual(lawsOfReports(report, options), []);
    assert.deepEqual(lawsOfMeshes(mesh), []);
    assert.equal(report.output.vertices, vertices);
  }
});

const [first, last] = [179, 208];

/** Cases that broke a law once, one of each kind. */
const found = [
  1620, // a body that is smaller than what its coordinates are rounded to
  200066, 200344, // triangles without area in bodies without a volume, in either scheme
  202327, // joints whose weights are too small for a number
  209975, // colours beyond 1, read where nothing checks them
  504814, // a primitive without attributes, before others
  511086, 511979, // vertices that came to one place: of a surface folded onto itself, of a curve
  605045, // triangles that are no lines before they are written
  765195, // a flat book on the current mesh, whose vertices nothing may lift
  631917, // splits that an error bound asks for, along a side of a triangle
  606743, // a surface of the smallest numbers, which have few digits
  729070, 775329, // vertices of boundaries that came upon corners
  1241169, // the first of two sets of texture coordinates means nothing
  1000988, 1057247, // sheets that a node shows as lines, but for rounding
  908105, // a flat fan folded onto itself, edges of which came upon each other
  826166, // values that are no numbers, of a mesh that is not touched
  605896, // a ring lost to rounding, samples of which were near no triangle
  1314146, // a spike so long that a vertex on its way there made steps without end
  3001982, // coordinates of whole steps, judged before they were rounded to them
  4006967, // a list of the required of which an element is no name
  1960143, // the tip of a triangle that goes into its only neighbour, within a bound
];

const seeds = [...found, ...Array.from({ length: last - first + 1 }, (_, i) => first + i)];
for (const seed of seeds) {
  const input = makeCase(seed);
  test(`case ${seed}: ${input.description}`, async () => {
    const { broken } = await runCase(input, { repeats: seed % 8 === 0 });
    assert.deepEqual(broken, []);
  });
}

/** The second, third and sixth take seconds each. */
const quadsCases = [1, 4, 5, 7, 8, 9, 10, 11];

for (const seed of quadsCases) {
  const input = makeQuadsCase(seed);
  test(`quads, case ${seed}: ${input.description}`, async () => {
    assert.deepEqual((await runCase(input, { repeats: seed % 4 === 0 })).broken, []);
  });
}

/** The others of the first twelve take a second and more each. */
const repairCases = [2, 6, 11];

for (const seed of repairCases) {
  const input = makeRepairCase(seed);
  test(`repair, case ${seed}: ${input.description}`, async () => {
    assert.deepEqual((await runRepairCase(input)).broken, []);
  });
}

/** Of the laws of trust: short cases. npm run laws -- --law trust tries others. */
const trustCases = { said: [1, 3, 4, 6, 7], harm: [2, 4, 7, 8, 9, 10] };

for (const [law, make] of [['said', makeSaidCase], ['harm', makeHarmCase]]) {
  for (const seed of trustCases[law]) {
    const input = make(seed);
    test(`${law}, case ${seed}: ${input.description}, ${commandOf(input)}`, async () => {
      assert.deepEqual((await runTrustCase(input, law)).broken, []);
    });
  }
}

for (const seed of [1, 2, 3]) {
  const input = makeInvarianceCase(seed);
  test(`invariance, case ${seed}: ${input.description}`, async () => {
    assert.deepEqual((await runInvarianceCase(input)).broken, []);
  });
}
