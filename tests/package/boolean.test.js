// SPDX-License-Identifier: MIT
// Booleans: volumes add up, what nothing cuts stays, attributes are those of both; broken bodies
// count as the bodies that they bound. Files are judged by readers that are not the engine's.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { boolean, booleanFiles, convertFile } from 'remesher';
import { Pool } from 'remesher/pool';

import { parseCommandLine } from '../../dist/cli/cli_arguments.js';
import { reportInWords } from '../../dist/cli/report_in_words.js';
import { tJunctions } from '../support/broken_shapes.js';
import { rejectsWith } from '../support/errors.js';
import { readFile } from '../support/independent/read.js';
import {
  crossingsOf, edgesOf, surfaceOf, volumeOf,
} from '../support/independent/surface.js';
import { octahedron, offText, sheet, stl, torus } from '../support/shapes.js';

const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1],
  [1, 1, 1]];
const sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/** A box from one corner to another, in doubles. */
const box = (low, high) => ({
  positions: Float64Array.from(corners.flatMap((corner) =>
    corner.map((value, k) => low[k] + value * (high[k] - low[k])))),
  indices: Uint32Array.from(sides.flatMap(([p, q, r, u]) => [p, q, r, p, r, u])),
});

const inDoubles = ({ positions, indices }) =>
  ({ positions: Float64Array.from(positions), indices });
const movedBy = (mesh, by) =>
  ({ ...mesh, positions: mesh.positions.map((value, i) => value + by[i % 3]) });
const turnedOver = (mesh) => ({ ...mesh, indices: mesh.indices.map((_, i, all) =>
  all[i - (i % 3) + [0, 2, 1][i % 3]]) });

/** As the independent readers give it. */
const asSurface = ({ positions, indices }) => surfaceOf([{ positions: Float64Array.from(positions),
  triangles: indices, quads: 0 }]);
const allOf = ({ triangles }) => Array.from({ length: triangles.length / 3 }, (_, t) => t);
const volume = (mesh) => {
  const surface = asSurface(mesh);
  return volumeOf(surface, allOf(surface));
};

/** Closed by exact position, with no crossings but those that rounding left and the report has. */
function requireSound(surface, { boolean: { selfIntersections } }) {
  for (const at of edgesOf(surface).values()) assert.equal(at.length % 2, 0);
  assert.equal(crossingsOf(surface).size, selfIntersections);
}

async function made(a, b, operation) {
  const { mesh, report } = await boolean(a, b, operation, { worker: false });
  requireSound(asSurface(mesh), report);
  assert.equal(report.boolean.operation, operation);
  if (!a.attributes && !b.attributes) assert.equal(report.boolean.selfIntersections, 0);
  return mesh;
}

const ring = inDoubles(torus({ columns: 24, rows: 12 }));
const pairs = {
  'boxes in general position': [box([0, 0, 0], [1, 1, 1]), box([0.3, 0.4, 0.6], [1.3, 1.5, 1.7])],
  'boxes with coplanar faces': [box([0, 0, 0], [1, 1, 1]), box([0.5, 0, 0], [2, 1, 0.5])],
  'a box inside another': [box([0, 0, 0], [3, 3, 3]), box([1, 1, 1], [2, 2, 2])],
  'twice the same box': [box([0, 0, 0], [1, 1, 1]), box([0, 0, 0], [1, 1, 1])],
  'boxes that touch': [box([0, 0, 0], [1, 1, 1]), box([1, 0.25, 0], [2, 1, 1])],
  'tori that link': [ring, movedBy(ring, [2, 0.1, 0.3])],
  'a torus and an octahedron': [ring, movedBy(inDoubles(octahedron()), [2, 0, 0])],
};

/** What rejects because nothing is left has no volume. */
const volumeOrNothing = (a, b, operation) => made(a, b, operation).then(volume, (error) => {
  assert.equal(error.code, 'NO_TRIANGLES', error.message);
  return 0;
});

for (const [name, [a, b]] of Object.entries(pairs)) {
  test(`volumes add up: ${name}`, async () => {
    const [inA, inB] = [volume(a), volume(b)];
    const common = await volumeOrNothing(a, b, 'intersect');
    const both = await volumeOrNothing(a, b, 'union');
    const rest = await volumeOrNothing(a, b, 'subtract');
    assert.ok(Math.abs(both + common - inA - inB) < 1e-9 * (inA + inB));
    assert.ok(Math.abs(rest + common - inA) < 1e-9 * (inA + inB));
  });
}

test('broken operands count as the bodies that they bound', async () => {
  const unit = box([0, 0, 0], [1, 1, 1]);
  const half = box([-0.5, -2, -2], [0.5, 2, 2]);
  const open = { ...unit, indices: unit.indices.slice(3) };
  const twice = { positions: Float64Array.from([...unit.positions,
    ...movedBy(unit, [0.25, 0.25, 0.25]).positions]),
  indices: Uint32Array.from([...unit.indices, ...unit.indices.map((v) => v + 8)]) };
  for (const [operand, expected] of [[inDoubles(tJunctions()), 4], [open, 0.5],
    [turnedOver(unit), 0.5], [twice, 0.5 + 0.25 - 0.25 * 0.75 * 0.75]]) {
    assert.ok(Math.abs(volume(await made(operand, half, 'intersect')) - expected) < 1e-6);
    assert.ok(Math.abs(volume(await made(half, operand, 'intersect')) - expected) < 1e-6);
  }
});

test('types are the first mesh’s, doubles where either has them; the same bytes', async () => {
  const single = torus({ columns: 24, rows: 12 });
  const small = { ...movedBy(single, [2, 0.25, 0.5]), indices: Uint16Array.from(single.indices) };
  const once = await made(single, small, 'union');
  assert.ok(once.positions instanceof Float32Array);
  assert.deepEqual(await made(single, small, 'union'), once);
  assert.ok((await made(small, small, 'union')).indices instanceof Uint16Array);
  assert.ok((await made(single, box([0, 0, 0], [3, 3, 3]), 'union')).positions
    instanceof Float64Array);
  const apart = await made(single, movedBy(single, [9, 0, 0]), 'subtract');
  assert.deepEqual([apart.positions, apart.indices], [single.positions, single.indices]);
});

test('texture coordinates stay linear, colours of the other are white, groups follow', async () => {
  const a = { ...ring, attributes: { TEXCOORD_0: { itemSize: 2, array: Float32Array.from(
    { length: 2 * (ring.positions.length / 3) }, (_, i) =>
      0.25 * ring.positions[3 * Math.floor(i / 2) + (i % 2)] + 1) } },
  groups: new Uint32Array(ring.indices.length / 3) };
  const b = { ...box([0, 0, -2], [4, 4, 2]), attributes: { COLOR_0: { itemSize: 4,
    array: new Uint8Array(32).fill(99) } } };
  const mesh = await made(a, b, 'subtract');
  const { TEXCOORD_0: uv, COLOR_0: color } = mesh.attributes;
  assert.deepEqual([...new Set(mesh.groups)].sort(), [0, 1]);
  mesh.indices.forEach((v, corner) => {
    if (mesh.groups[Math.floor(corner / 3)] === 1) {
      assert.deepEqual([uv.array[2 * v], color.array[4 * v]], [0, 99]);
      return;
    }
    for (const k of [0, 1]) {
      assert.ok(Math.abs(uv.array[2 * v + k] - 0.25 * mesh.positions[3 * v + k] - 1) < 1e-6);
    }
    assert.equal(color.array[4 * v], 255);
  });
});

test('files of different formats give files that are closed as they are written', async () => {
  const a = new TextEncoder().encode(offText(torus({ columns: 24, rows: 12 })));
  const b = stl(movedBy(torus({ columns: 20, rows: 10 }), [2, 0.25, 0.5]));
  const { bytes: glb } = await convertFile(a, { name: 'a.off', output: 'glb' });
  for (const [first, nameA] of [[a, 'a.off'], [glb, 'a.glb']]) {
    for (const output of ['c.stl', 'c.glb', 'c.obj', 'c.ply', 'c.off']) {
      const run = await booleanFiles(first, b, 'subtract', { nameA, nameB: 'b.stl', output });
      assert.equal(run.name, output);
      const surface = surfaceOf(readFile(run.bytes, { name: output }).parts);
      requireSound(surface, run.report);
      assert.equal(run.report.output.triangles, surface.triangles.length / 3);
      assert.match(reportInWords(run.report), /subtract, the first body without the second: \d+/);
    }
  }
});

test('one sentence says which operand is at fault', async () => {
  const a = box([0, 0, 0], [1, 1, 1]);
  await rejectsWith(boolean(a, sheet(), 'union'), 'INVALID_MESH', /^The second operand .* near \(/);
  await rejectsWith(boolean(sheet(), a, 'union'), 'INVALID_MESH', /^The first operand /);
  await rejectsWith(boolean(a, movedBy(a, [3, 0, 0]), 'intersect'), 'NO_TRIANGLES', /in common/);
  await rejectsWith(boolean(a, a, 'subtract'), 'NO_TRIANGLES', /all of the first operand lies/);
  await rejectsWith(boolean(a, a, 'xor'), 'INVALID_OPTION', /'union', 'subtract' or 'intersect'/);
  await rejectsWith(boolean(a, a, 'union', { vertices: 9 }), 'UNKNOWN_OPTION');
  await rejectsWith(booleanFiles(stl(sheet()), stl(torus()), 'union',
    { nameA: 'sheet.stl', nameB: 'b.stl' }), 'INVALID_MESH', /^sheet\.stl /);
});

test('a pool makes Booleans too, and a signal ends them', async () => {
  const pool = new Pool({ size: 1 });
  const [a, b] = pairs['boxes in general position'];
  const { report } = await pool.boolean(a, b, 'union');
  assert.equal(report.input.triangles, 24);
  await assert.rejects(pool.boolean(a, b, 'union', { signal: AbortSignal.abort() }),
    { name: 'AbortError' });
  pool.close();
});

test('the command line takes two files and no options of remeshing', () => {
  const line = parseCommandLine(['subtract', 'a.stl', 'b.glb', '-o', 'c.glb', '--json']);
  assert.deepEqual([line.command, line.inputs], ['subtract', ['a.stl', 'b.glb']]);
  for (const [words, message] of [[['union', 'a.stl', '-o', 'c.stl'], /takes two input files/],
    [['union', 'a.stl', 'b.stl', 'c.stl', '-o', 'd.stl'], /takes two input files, not 3/],
    [['union', 'a.stl', 'b.stl', '-o', 'out/'], /out\/ is a folder/],
    [['union', 'a.stl', 'b.stl'], /No output file/],
    [['union', 'a.stl', 'b.stl', '-o', 'c.stl', '--ratio', '0.5'], /does not remesh: --ratio/],
    [['union', 'a.stl', 'b.stl', '-o', 'c.stl', '--jobs', '2'], /for many files/]]) {
    assert.throws(() => parseCommandLine(words), message);
  }
});
