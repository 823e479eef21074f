// SPDX-License-Identifier: MIT
// The laws of trust notice what they are for: a wrong report, a lost body, a hole, a boundary that
// moved, another mesh, a jump of the error, a run that takes too long.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect } from 'remesher';

import { claims, lawsOfClaim, lawsOfTimes } from '../fuzz/proportion_case.js';
import { changes } from '../fuzz/invariance_case.js';
import { lawsOfMended } from '../fuzz/repair_case.js';
import { holedSheet } from '../fuzz/made_bodies.js';
import { Dice } from '../fuzz/dice.js';
import { joined, moved, shapes } from '../fuzz/made_shapes.js';
import { files, meshOf } from '../fuzz/made_files.js';
import { pairedFaces, objFile } from '../fuzz/trust_files.js';
import { makeSaidCase, runOf } from '../fuzz/trust_case.js';
import { figuresOf } from '../support/independent/figures.js';
import { readFile } from '../support/independent/read.js';
import { lawsOfHarm } from '../support/trust/harm.js';
import { lawsOfDistance, lawsOfWriting } from '../support/trust/said.js';
import { differences } from '../support/trust/same.js';
import { lawsOfNeighbours } from '../support/trust/smooth.js';

const encode = (text) => new TextEncoder().encode(text);
const fileOf = ({ positions, triangles }) => objFile(positions, triangles);
const figures = (file) => figuresOf(readFile(file.bytes, file));
const ofShape = (shape) => figures(fileOf(shape));

/** A report that says what is written. */
const truth = ({ vertices, triangles, components, boundaryEdges, nonManifoldEdges, minAngle,
  maxAngle, quads }) => ({ warnings: [], input: { boundaryEdges }, output: { vertices, triangles,
  components, boundaryEdges, nonManifoldEdges, minAngle, maxAngle,
  ...(quads > 0 ? { quads: { count: quads } } : {}) } });

test('a report that is wrong in one figure is noticed', () => {
  const ball = shapes.ball(3);
  const written = figures(objFile(ball.positions, pairedFaces(ball)));
  const file = { name: 'made.obj', before: written };
  const right = truth(written);
  assert.equal(written.quads, 54);
  assert.deepEqual(lawsOfWriting(written, right, file), []);
  for (const name of ['vertices', 'triangles', 'components', 'boundaryEdges', 'nonManifoldEdges']) {
    const wrong = { ...right, output: { ...right.output, [name]: right.output[name] + 1 } };
    assert.match(lawsOfWriting(written, wrong, file).join(), new RegExp(`^${name}: \\d+ said`));
  }
  const { worst, mean } = written.minAngle;
  for (const wrong of [{ minAngle: { worst: worst + 0.1, mean } }, { maxAngle: NaN },
    { minAngle: { worst, mean: mean - 0.1 } }, { quads: { count: 53 } }]) {
    const output = { ...right.output, ...wrong };
    assert.equal(lawsOfWriting(written, { ...right, output }, file).length, 1);
  }
});

test('what a repair left open or crossing is accepted where a warning says so', async () => {
  const mesh = meshOf(joined(shapes.box(2), moved(shapes['flat sheet'](1), [0.2, 0.3, 0.5])));
  const { length } = await lawsOfMended(mesh, 'repaired', { mayTouch: true });
  assert.equal(length, 2);
  const { faults } = await inspect(mesh, { faults: true });
  const said = [{ code: 'SHEETS_LEFT', count: 1, at: [0.2, 0.3, 0.5] },
    { code: 'CROSSINGS_LEFT', count: faults.selfIntersections, at: [0.2, 0.3, 0.5] }];
  assert.deepEqual(await lawsOfMended(mesh, 'repaired', { mayTouch: true, warnings: said }), []);
  for (const warnings of [said.slice(1), said.map(({ code, count }) => ({ code, count })),
    said.map((warning) => ({ ...warning, count: 1 }))]) {
    assert.notDeepEqual(await lawsOfMended(mesh, 'repaired', { mayTouch: true, warnings }), []);
  }
});

test('a material that the input does not have is noticed', () => {
  const [before, written] = ['red', 'red\nusemtl \u0001'].map((name) => {
    const file = fileOf(shapes.ball(1));
    const text = new TextDecoder().decode(file.bytes).replace('f ', `usemtl ${name}\nf `);
    return figures({ ...file, bytes: encode(text) });
  });
  const file = { name: 'made.obj', before };
  assert.deepEqual(lawsOfWriting(before, truth(before), file), []);
  assert.match(lawsOfWriting(written, truth(written), file).join(), /material "\\u0001"/);
});

test('what is lost without a word is noticed', () => {
  const written = ofShape(shapes.ball(1));
  const before = { ...written, holds: new Set(['COLOR_0', 'materials', 'looks']) };
  const laws = (...warnings) => lawsOfWriting(written, { ...truth(written), warnings },
    { name: 'made.obj', before });
  assert.match(laws().join(), /COLOR_0.*nothing said.*materials.*nothing said.*looks/);
  const named = (message) => ({ code: 'ATTRIBUTE_NOT_CARRIED', message });
  assert.equal(laws(named('The STL has no place for NORMAL, materials.')).length, 1);
  assert.deepEqual(laws(named('COLOR_0, materials'), { code: 'MATERIALS_BY_NAME' }), []);
  assert.equal(laws(named('COLOR_0'), { code: 'MATERIALS_BY_NAME' }).length, 1);
});

test('an open edge that only rounding hides is noticed in the file', () => {
  const noisy = shapes.ball(2);
  noisy.positions.push(noisy.positions[0].map((x) => x + 1e-17 + Math.abs(x) * 2e-16));
  noisy.triangles[noisy.triangles.findIndex((t) => t[0] === 0)][0] = noisy.positions.length - 1;
  const written = ofShape(noisy);
  assert.equal(written.boundaryEdges, 4);
});

test('crossings that nobody speaks of are noticed, within a mesh and across meshes', () => {
  const balls = joined(shapes.ball(3), moved(shapes.ball(3), [1, 0, 0]));
  const [before, written] = [ofShape(shapes.ball(3)), ofShape(balls)];
  const report = truth(written);
  const file = { name: 'made.obj', before };
  assert.match(lawsOfWriting(written, report, file).join(), /nothing said, \d+ written/);
  const repair = (count) => ({ ...report, repair: { selfIntersections: [0, count] } });
  assert.match(lawsOfWriting(written, repair(0), file).join(), /crossings: 0 said/);
  assert.deepEqual(lawsOfWriting(written, repair(written.crossings), file), []);
  const warned = (count) => ({ ...report, warnings: [{ code: 'CROSSINGS_LEFT', count }] });
  assert.deepEqual(lawsOfWriting(written, warned(written.crossings), file), []);
  assert.match(lawsOfWriting(written, warned(1), file).join(), /1 warned of/);
  const crossed = { ...file, before: written };
  assert.deepEqual(lawsOfWriting(written, report, crossed), []);
  const across = { ...before, crossingsAcross: 9 };
  assert.match(lawsOfWriting(across, truth(before), file).join(), /of parts: nothing said, 9/);
});

test('a distance that is too small is noticed', () => {
  const [before, written] = [1, 1.1].map((factor) => ofShape({ ...shapes.ball(4),
    positions: shapes.ball(4).positions.map((p) => p.map((x) => factor * x)) }));
  assert.match(lawsOfDistance(before, written, { fidelity: { hausdorff: 0.1 } })[0], /0.1 % said/);
  assert.deepEqual(lawsOfDistance(before, written, { fidelity: { hausdorff: 3.2 } }), []);
});

const repaired = (before, after, report = {}) => lawsOfHarm(ofShape(before), ofShape(after),
  { report: { warnings: [], repair: {}, ...report }, isRepair: true });

test('a repair that loses a body, opens a surface or remakes a sound one is noticed', () => {
  const edge = shapes['two boxes that touch along an edge'](1);
  assert.deepEqual(repaired(edge, edge), []);
  assert.match(repaired(edge, shapes.box(1))[0], /% of the volume of a body of 24 triangles/);
  const two = shapes['two balls'](4);
  assert.match(repaired(two, shapes.ball(4)).join(), /100 % of the volume.*another: /s);
  assert.match(repaired(two, two).join(), /^nothing was wrong, and the same mesh/);
  const warned = { warnings: [{ code: 'SCRAPS_REMOVED', count: 1 }] };
  assert.doesNotMatch(repaired(two, shapes.ball(4), warned).join(), /volume/);
  const holed = { ...shapes.ball(4), triangles: shapes.ball(4).triangles.slice(2) };
  assert.match(repaired(shapes.ball(4), holed).join(), /0 open edges before, 4 written/);
  assert.deepEqual(repaired(holed, shapes.ball(4)), []);
  const turned = { ...edge, triangles: edge.triangles.map(([a, b, c]) => [a, c, b]) };
  assert.deepEqual(repaired(turned, edge), [], 'bodies that were inside out');
});

test('a boundary that moves, closes or becomes longer is noticed', () => {
  const sheet = holedSheet(32, 4);
  const before = ofShape(sheet);
  const report = truth(before);
  const after = (change) => lawsOfHarm(before, ofShape({ ...sheet,
    positions: sheet.positions.map(change) }), { report });
  assert.deepEqual(after((p) => p), []);
  const notch = ([x, y, z], i) => (i === 0 ? [x - 0.05, y, z] : [x, y, z]);
  assert.match(after(notch).join(), /1 of 64 vertices of boundaries are off them/);
  assert.match(after(([x, y, z]) => [1.01 * x, y, z]).join(), /off them.*loop of/s);
  const inner = new Set([...sheet.positions.keys()].filter((v) => v % 5 === 0));
  const fan = [...inner].map((v) => [v, sheet.positions.length, (v + 5) % 160]);
  const filled = ofShape({ positions: [...sheet.positions, [0, 0, 0]],
    triangles: [...sheet.triangles, ...fan] });
  assert.match(lawsOfHarm(before, filled, { report }).join(), /2 boundary loops before, 1 written/);
});

test('the same mesh is found in any order, another is not', () => {
  const ball = shapes.ball(4);
  const surface = ofShape(ball).surface;
  const dice = new Dice(3);
  for (const kind of ['in another order of vertices', 'in another order of triangles']) {
    const other = ofShape(changes[kind](dice).shape(ball)).surface;
    assert.deepEqual(differences(surface, other, 1e-9), [], kind);
  }
  const nudged = ofShape({ ...ball, positions: ball.positions.map((p, i) =>
    (i === 7 ? p.map((x) => 1.001 * x) : p)) }).surface;
  assert.match(differences(surface, nudged, 1e-5)[0], /1 of 98 vertices are elsewhere/);
  assert.deepEqual(differences(surface, nudged, 1e-2), []);
  const [a, b, c] = ball.triangles[0];
  const d = ball.triangles[1].find((v) => ![a, b, c].includes(v));
  const flipped = ofShape({ ...ball, triangles: [[b, c, d], [d, a, b],
    ...ball.triangles.slice(2)] }).surface;
  assert.match(differences(surface, flipped, 1e-9)[0], /2 of 192 triangles differ/);
  const fewer = ofShape({ ...ball, triangles: ball.triangles.slice(1) }).surface;
  assert.match(differences(surface, fewer, 1e-9)[0], /192 triangles; 98 and 191/);
});

test('a jump of the error is noticed unless it is said', () => {
  const runs = (...errors) => errors.map((hausdorff, i) => ({ asked: 100 + i,
    report: { fidelity: { hausdorff }, warnings: [], stopped: 'target' } }));
  assert.deepEqual(lawsOfNeighbours(runs(0, 0.04, 0.1, 0.14)), []);
  assert.match(lawsOfNeighbours(runs(0, 0.907, 0.611))[0], /0.907 % at 101 .* 0.000 % at 100/);
  assert.equal(lawsOfNeighbours(runs(0.5, 0.1, 0.5)).length, 2);
  const around = (first) => runs(0.8, 0, 0.9).map((run) =>
    ({ ...run, report: { ...run.report, input: { vertices: first } } }));
  assert.match(lawsOfNeighbours(around(101)).join(), /^0.900 % at 102 .* at 101$/);
  assert.match(lawsOfNeighbours(around(400)).join(), /^0.900 % at 102 .* at 101$/);
  assert.equal(lawsOfNeighbours(around(50)).length, 2);
  // Where counts pass over the original's number, those on both sides of it are its neighbours.
  assert.match(lawsOfNeighbours(around(100.5)).join(), /^0.900 % at 102 .* at 101$/);
  const said = runs(0, 0.9);
  for (const code of ['TOO_FEW_VERTICES', 'SHAPE_TAKES_MORE']) {
    said[1].report.warnings = [{ code }];
    assert.deepEqual(lawsOfNeighbours(said), []);
  }
  const byRule = (...rules) => runs(0, 0.9).map((run, i) =>
    ({ ...run, report: { ...run.report, chosen: { rule: rules[i] } } }));
  assert.deepEqual(lawsOfNeighbours(byRule('isotropic-far-unfinished', 'resampled')), []);
  assert.equal(lawsOfNeighbours(byRule('resampled', 'resampled')).length, 1);
  assert.equal(lawsOfNeighbours(byRule('quads-mirrored', 'quads')).length, 1);
});

test('a run out of proportion is noticed, and claims beyond the bytes are refused', async () => {
  assert.deepEqual(lawsOfTimes(20, 1), []);
  assert.deepEqual(lawsOfTimes(1.9, 0.001), []);
  assert.match(lawsOfTimes(31, 1)[0], /31.0 s, 31 times/);
  assert.match((await lawsOfClaim(files.obj(shapes.ball(1))))[0], /as if it were whole/);
  for (const [kind, claiming] of Object.entries(claims)) {
    for (const count of [10, 2e9, 4e9]) {
      assert.deepEqual(await lawsOfClaim(claiming(count)), [], `${kind}, ${count}`);
    }
  }
});

test('cases are the same each time, and run', async () => {
  assert.deepEqual(makeSaidCase(11), makeSaidCase(11));
  const { written, report } = await runOf({ description: '', isRepair: false, output: 'ply',
    options: { vertices: 50 }, file: { name: 'a.off', bytes: encode('OFF\n4 4 0\n0 0 0\n1 0 0\n'
      + '0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n') } });
  assert.equal(written.vertices, 50);
  assert.equal(report.output.vertices, 50);
});
