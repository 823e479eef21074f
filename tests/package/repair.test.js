// SPDX-License-Identifier: MIT
// Repair, alone and before remeshing: holes closed and the rest as it was; bodies united; sheets
// wrapped; tests/integration/package/repair.test.js has what takes longer.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remesh, repair, repairFile } from 'remesher';

import { parseCommandLine } from '../../dist/cli/cli_arguments.js';
import { reportInWords } from '../../dist/cli/report_in_words.js';
import * as broken from '../support/broken_shapes.js';
import { rejectsWith } from '../support/errors.js';
import { eulerCharacteristic, offText, sheet, torus } from '../support/shapes.js';
import { assertSound } from '../support/sound.js';

/** Without the triangles from one number to another. */
function withHole({ positions, indices }, from, to) {
  const kept = Array.from(indices).filter((_, i) => i < 3 * from || i >= 3 * to);
  return { positions, indices: Uint32Array.from(kept) };
}

/** Both, the second one moved along x. */
function joined(a, b, by) {
  const moved = b.positions.map((value, i) => value + (i % 3 === 0 ? by : 0));
  return {
    positions: Float32Array.from([...a.positions, ...moved]),
    indices: Uint32Array.from([...a.indices,
      ...Array.from(b.indices, (v) => v + a.positions.length / 3)]),
  };
}

const whole = torus();
const open = withHole(whole, 10, 16);

test('a hole is closed, and what was there is there bit for bit', async () => {
  const { mesh, report } = await repair(open);
  assert.equal(report.repair.mode, 'holes');
  assert.ok(report.repair.holes >= 1);
  assert.deepEqual(report.repair.selfIntersections, [0, 0]);
  assert.ok(report.input.boundaryEdges > 0);
  assert.equal(report.output.boundaryEdges, 0);
  assert.equal(eulerCharacteristic(mesh), eulerCharacteristic(whole));
  assert.deepEqual(mesh.positions.slice(0, open.positions.length), open.positions);
  assert.deepEqual(mesh.indices.slice(0, open.indices.length), open.indices);
});

test('a sound STL in text comes back byte for byte, whatever its digits', async () => {
  const { positions, indices } = whole;
  const place = (/** @type {number} */ v) => Array.from(positions.subarray(3 * v, 3 * v + 3),
    (x) => (x + 1 / 3).toExponential(9));
  const corner = (/** @type {number} */ v) => `vertex ${place(v).join(' ')}`;
  const facets = Array.from({ length: indices.length / 3 }, (_, t) => ['facet normal 0 0 0',
    'outer loop', ...[0, 1, 2].map((k) => corner(indices[3 * t + k])), 'endloop', 'endfacet']);
  const bytes = Buffer.from(['solid torus', ...facets.flat(), 'endsolid torus', ''].join('\n'));
  const { bytes: result, report } = await repairFile(bytes, { name: 'torus.stl', repair: 'auto' });
  assert.equal(report.chosen.rule, 'kept');
  assert.deepEqual(Buffer.from(result), bytes);
});

test('holes longer than asked for stay open, with a warning', async () => {
  const { report } = await repair(open, { holesUpTo: 0.001 });
  assert.equal(report.repair.holes, 0);
  assert.equal(report.output.boundaryEdges, report.input.boundaryEdges);
  assert.ok(report.warnings.some(({ code }) => code === 'HOLES_LEFT_OPEN'));
});

test('a file is mended in its own format or another', async () => {
  const bytes = new TextEncoder().encode(offText(open));
  const { name, bytes: result } = await repairFile(bytes, { name: 'open.off', output: 'stl' });
  assert.equal(name, 'open.stl');
  const { input } = await inspect(result, { name });
  assert.equal(input.boundaryEdges, 0);
});

test('what is remeshed is mended first, if asked for', async () => {
  const { report } = await remesh(open, { vertices: 400, repair: 'holes' });
  assert.equal(report.repair.mode, 'holes');
  assert.ok(report.input.boundaryEdges > 0);
  assert.equal(report.output.boundaryEdges, 0);
  assert.equal(report.output.vertices, 400);
  assert.equal((await remesh(open, { vertices: 400 })).report.repair, undefined);
});

test('without a number of vertices it is the input’s, whatever repair has made of it', async () => {
  const small = torus({ columns: 24, rows: 12 });
  const opened = withHole(small, 10, 16);
  for (const [input, mode, ratio] of
    [[small, 'solid'], [opened, 'wrap', 2], [opened, 'auto'], [opened, 'auto', 2]]) {
    const { report } = await remesh(input, { ratio, repair: mode });
    assert.equal(report.output.vertices, (ratio ?? 1) * report.input.vertices, mode);
  }
});

test('overlapping bodies become one that passes through itself nowhere', async () => {
  const both = joined(whole, whole, 0.9);
  const { mesh, report } = await repair(both);
  assert.equal(report.repair.mode, 'solid');
  assert.ok(report.repair.selfIntersections[0] > 0);
  assert.equal(report.repair.selfIntersections[1], 0);
  assert.deepEqual([report.output.components, report.output.boundaryEdges,
    report.output.nonManifoldEdges], [1, 0, 0]);
  assert.ok(mesh.positions instanceof Float32Array);
  assert.deepEqual((await repair(both)).mesh, mesh);
});

test('an open sheet is wrapped, and can be remeshed then', async () => {
  const { report } = await remesh(sheet(), { vertices: 600, repair: 'wrap', gap: 3 });
  assert.equal(report.repair.mode, 'wrap');
  assert.equal(report.output.vertices, 600);
  assert.equal(report.output.boundaryEdges, 0);
});

const { askewBoxes, nestedBoxes, thinHouse, manyBodies, doubledScan, cracked, tJunctions,
  looseTriangles } = broken;
const fewLooseTriangles = () => looseTriangles(20);
for (const make of [askewBoxes, nestedBoxes, thinHouse, manyBodies, doubledScan, cracked,
  tJunctions, fewLooseTriangles]) {
  test(`${make.name}: repaired and remeshed it is sound`, async () => {
    const { mesh, report } = await remesh(make(), { repair: 'auto', vertices: 1000 });
    await assertSound(mesh, make.name);
    assert.equal(report.output.vertices, 1000);
  });
}

test('a sheet with one side only is wrapped, where that is asked for', async () => {
  const { mesh } = await remesh(broken.moebiusStrip(), { repair: 'wrap', vertices: 1000 });
  await assertSound(mesh, 'Möbius strip');
});

test('what repair makes gets no curves where its lattice happens to be flat', async () => {
  const { report } = await remesh(askewBoxes(), { repair: 'auto', vertices: 2000 });
  assert.equal(report.repair.mode, 'solid');
  assert.ok(report.output.minAngle.worst > 15, `${report.output.minAngle.worst}`);
});

test('an inspection tells what is broken, and what would mend it', async () => {
  assert.equal((await inspect(open)).faults, undefined);
  const sound = (await inspect(whole, { faults: true })).faults;
  assert.deepEqual(sound, { openLoops: [], selfIntersections: 0, innerShells: 0, insideOut: 0,
    repair: 'off', needs: { bytes: 0, seconds: 0 },
    places: { openLoops: [], selfIntersections: [], innerShells: [], insideOut: [] } });
  const { faults } = await inspect(open, { faults: true });
  assert.ok(faults.openLoops.length >= 1);
  assert.ok(faults.openLoops.every((length, i, all) => length > 0 && !(length > all[i - 1])));
  assert.equal(faults.repair, 'holes');
  assert.equal(faults.places.openLoops.length, 3 * faults.openLoops.length);
  const bytes = new TextEncoder().encode(offText(open));
  const ofFile = await inspect(bytes, { name: 'open.off', faults: true });
  assert.equal(ofFile.faults.openLoops.length, faults.openLoops.length);
  const crossed = (await inspect(joined(whole, whole, 0.9), { faults: true })).faults;
  assert.ok(crossed.selfIntersections > 0);
  assert.equal(crossed.repair, 'solid');
  const [x, y, z] = crossed.places.selfIntersections;
  assert.ok(Math.abs(Math.hypot(Math.hypot(x, y) - 2, z) - 0.8) < 0.1
    || Math.abs(Math.hypot(Math.hypot(x - 0.9, y) - 2, z) - 0.8) < 0.1, `${x} ${y} ${z}`);
  const inwards = { ...whole, indices: whole.indices.slice().reverse() };
  assert.equal((await inspect(inwards, { faults: true })).faults.insideOut, 1);
  await rejectsWith(inspect(open, { faults: 1 }), 'INVALID_OPTION', /faults must be true or false/);
});

test('faults are said in words', async () => {
  const words = reportInWords(await inspect(open, { faults: true }));
  assert.match(words, /faults: 1 open loop, in length [\d.]+ % of the diagonal/);
  assert.match(words, /what would repair it: holes.*; it takes about \d+ MB and [\d.]+ s/);
});

test('places have the digits that tell them, and widths the unit', async () => {
  const far = { ...open, positions: Float64Array.from(open.positions, (x) => 5e6 + x) };
  const words = reportInWords(await inspect(far, { faults: true }));
  assert.match(words, /open loop.*, the first near \((?:-?\d{7}\.\d+, ){2}-?\d{7}\.\d+\)/);
  const { report } = await repair(open);
  assert.match(reportInWords({ ...report, unit: 'cm' }), /\(the widest [\d.]+ cm across, near/);
});

test('what a repair takes is said before it begins, and too much is refused', async () => {
  const [holes, solid] = await Promise.all([open, joined(whole, whole, 0.9)]
    .map(async (mesh) => (await inspect(mesh, { faults: true })).faults.needs));
  assert.ok(0 < holes.bytes && holes.bytes < solid.bytes, `${holes.bytes} ${solid.bytes}`);
  assert.ok(0 < holes.seconds && holes.seconds < solid.seconds);
  const next = (() => {
    let state = 1;
    return () => (state = (state * 48271) % 2147483647) / 2147483647;
  })();
  // Each as large as the whole.
  const soup = { positions: Float32Array.from({ length: 9 * 60000 }, next),
    indices: Uint32Array.from({ length: 3 * 60000 }, (_, i) => i) };
  await rejectsWith(repair(soup), 'OUT_OF_MEMORY', /takes about [\d.]+ GB of memory for this mesh/);
  const { input, faults, warnings } = await inspect(soup, { faults: true });
  assert.deepEqual([input.triangles, faults], [60000, undefined]);
  assert.match(warnings.find(({ code }) => code === 'FAULTS_NOT_SOUGHT').message,
    /^Faults could not be looked for\. .*takes about [\d.]+ GB/);
});

test('what is lost is an area with places; what keeps all loses nothing', async () => {
  const exact = (await repair(joined(whole, whole, 0.9), { repair: 'solid' })).report.repair;
  assert.deepEqual([exact.lost, exact.lostBeyond, exact.lostAt], [0, 0, []]);
  const { report } = await repair(joined(whole, whole, 0.9), { repair: 'wrap' });
  assert.deepEqual([report.repair.lost, report.repair.lostAt], [0, []]);
  assert.ok(report.repair.lostBeyond > 0.2 && report.repair.lostBeyond < 1);
  assert.match(reportInWords(report), /0\.00 % of the area seen from outside is farther from/);
});

test('walls thinner than the lattice keep both sides where they are', async () => {
  for (const wall of [0.005, 0.001]) {
    const { mesh, report } = await repair(broken.thinHouse(wall), { repair: 'solid' });
    assert.ok(report.repair.lost < 0.01, `${report.repair.lost} %`);
    assert.ok(!report.warnings.some(({ code }) => code === 'SEEN_PARTS_LOST'));
    await assertSound(mesh, `walls of ${wall}`);
  }
});

/** One within the other, which faces into what it encloses. */
function hollow() {
  const { positions, indices } = torus({ columns: 24, rows: 12 });
  const thinner = positions.map((x, i) => {
    const [a, b, c] = positions.slice(i - (i % 3), i - (i % 3) + 3);
    const ring = Math.hypot(a, b);
    return [a / ring * 2 + 0.4 * (a - a / ring * 2), b / ring * 2 + 0.4 * (b - b / ring * 2),
      0.4 * c][i % 3];
  });
  return joined({ positions, indices }, { positions: thinner, indices: indices.toReversed() }, 0);
}

test('cavities are filled, or kept where that is asked for', async () => {
  for (const [cavities, components] of [[false, 1], [true, 2]]) {
    const { mesh, report } = await repair(hollow(), { repair: 'solid', cavities });
    assert.equal(report.output.components, components);
    assert.equal(report.repair.shells, 2 - components);
    await assertSound(mesh, `cavities: ${cavities}`);
    const remeshed = await remesh(hollow(), { repair: 'solid', cavities, vertices: 600 });
    assert.equal(remeshed.report.output.components, components);
    await assertSound(remeshed.mesh, `remeshed, cavities: ${cavities}`);
  }
});

test('sheets become thin solids, or are left out; both is said with a place', async () => {
  const both = joined(torus({ columns: 24, rows: 12 }), sheet(), 6);
  for (const [sheets, components, code] of
    [['thicken', 2, 'SHEETS_THICKENED'], ['drop', 1, 'SHEETS_DROPPED']]) {
    const { mesh, report } = await repair(both, { repair: 'wrap', sheets });
    assert.equal(report.output.components, components);
    assert.ok(report.warnings.some((warning) => warning.code === code), code);
    assert.equal(report.repair.lost > 1, sheets === 'drop', `${report.repair.lost} %`);
    const lost = report.warnings.find((warning) => warning.code === 'SEEN_PARTS_LOST');
    if (sheets === 'drop') {
      assert.match(lost.message, /near \([5-9][.\d]*, /);
      assert.ok(report.repair.lostAt.every((x, i) => i % 3 > 0 || x > 4), 'places on the sheet');
    }
    await assertSound(mesh, sheets);
  }
  const square = { positions: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0),
    indices: Uint32Array.of(0, 1, 2, 0, 2, 3) };
  await rejectsWith(repair(square, { repair: 'wrap', sheets: 'drop' }), 'NO_TRIANGLES',
    /only sheets/);
});

test('what thin solids made of sheets enclose is filled', async () => {
  const { mesh, report } = await repair(cracked(), { repair: 'wrap' });
  assert.ok(report.warnings.some(({ code }) => code === 'SHEETS_THICKENED'));
  assert.equal((await repair(mesh, { repair: 'solid' })).report.repair.shells, 0);
});

test('the report says that bodies which touch along edges stay as they are', async () => {
  const tetrahedra = [[0, 1, 2, 3], [0, 1, 4, 5]];
  const mesh = { positions: new Float32Array([0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, -1, 0, 0,
    -1, -1, 0]), indices: new Uint32Array(tetrahedra.flatMap(([a, b, c, d]) => [a, c, b, a, b, d,
    b, c, d, a, d, c])) };
  const words = /nothing (needs|needed) repair: bodies that touch along 1 edge stay as they are/;
  assert.match(reportInWords((await repair(mesh)).report), words);
  assert.match(reportInWords(await inspect(mesh, { faults: true })), words);
});

test('an inspection says that a surface of one side stays as it is', async () => {
  const report = await inspect(broken.moebiusStrip(), { faults: true });
  assert.match(reportInWords(report), /repair leaves it as it is: a surface of one side/);
});

test('the report says why a mode was chosen', async () => {
  const inwards = { ...whole, indices: whole.indices.slice().reverse() };
  for (const [mesh, options, mode, reason] of [
    [whole, {}, 'holes', 'sound'], [open, {}, 'holes', 'closed'], [inwards, {}, 'holes', 'closed'],
    [sheet(), {}, 'holes', 'sheets'], [looseTriangles(20), {}, 'wrap', 'open'],
    [broken.askewBoxes(), {}, 'solid', 'united'],
    [open, { repair: 'solid' }, 'solid', 'asked']]) {
    const { report } = await repair(mesh, options);
    assert.deepEqual([report.repair.mode, report.repair.reason], [mode, reason]);
    const isKept = reason === 'sound' || reason === 'sheets';
    assert.equal(report.chosen.rule, isKept ? 'kept' : 'repaired');
    assert.match(reportInWords(report), reason === 'sound' ? /repair: nothing needed repair\n/
      : new RegExp(`repair \\(${mode}, \\w+ .*\\)`));
  }
});

test('places that differ only by rounding become one, as an inspection says before', async () => {
  const v = whole.positions.findIndex((x, i) => i % 3 === 1 && x === 0);
  const beside = Array.from(whole.positions.slice(v - 1, v + 2), (x) => (x === 0 ? 1e-17 : x));
  const mesh = { positions: Float64Array.from([...whole.positions, ...beside]),
    indices: whole.indices.slice() };
  mesh.indices[mesh.indices.indexOf((v - 1) / 3)] = whole.positions.length / 3;
  const said = reportInWords(await inspect(mesh, { faults: true }));
  assert.match(said, /\n {2}places that differ only by rounding are to be made one: 1\n/);
  const { mesh: made, report } = await repair(mesh);
  assert.equal(report.repair.reason, 'joined');
  assert.match(reportInWords(report), /repair: nearly equal positions were merged;/);
  const again = await inspect(made, { faults: true });
  assert.ok(!again.warnings.some(({ code }) => code === 'PLACES_JOINED'));
});

test('options that say nothing to a repair are refused', async () => {
  await rejectsWith(repair(open, { vertices: 100 }), 'INVALID_OPTION', /vertices does not belong/);
  await rejectsWith(remesh(open, { holesUpTo: 5 }), 'INVALID_OPTION',
    /holesUpTo needs repair: 'holes'/);
  await rejectsWith(repair(open, { repair: 'wrap', cavities: true }), 'INVALID_OPTION',
    /cavities needs repair: 'solid'/);
  await rejectsWith(remesh(open, { sheets: 'drop' }), 'INVALID_OPTION', /sheets needs repair/);
  await rejectsWith(
    remesh(open, { repair: 'holes', density: new Float32Array(open.positions.length / 3).fill(1) }),
    'INVALID_OPTION', /density/);
  assert.throws(() => parseCommandLine(['repair', 'a.stl', '-o', 'b.stl', '--ratio', '0.5']),
    /does not remesh: --ratio/);
  assert.equal(parseCommandLine(['repair', 'a.stl', '-o', 'b.stl']).command, 'repair');
});
