// SPDX-License-Identifier: MIT
// Lengths with a unit: the same as the percentage or the number that they stand for.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { convertFile, inspect, remesh, remeshFile, repairFile } from 'remesher';
import { checkOptions, inJavaScript } from 'remesher/options';

import { inModelUnits, lengthFrom, lengthInWords, threemfUnits } from '../../dist/base/lengths.js';
import { rejectsWith } from '../support/errors.js';
import { readText, root } from '../support/tree.js';
import { offText, torus } from '../support/shapes.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-units-'));
after(() => rmSync(folder, { recursive: true }));

const ring = torus({ columns: 40, rows: 20 });
const off = new TextEncoder().encode(offText(ring));
const diagonal = Math.hypot(5.6, 5.6, 1.6);
const draft = { quality: /** @type {const} */ ('draft'), worker: false };

test('the core and JavaScript know the same units, of the same lengths', () => {
  const rows = readText('src/io/model/units.cpp').matchAll(/\{"(\w+)", ([\d.e-]+)\}/g);
  assert.deepEqual([...rows].map(([, name, metres]) => [name, Number(metres)]),
    Object.entries(threemfUnits).map(([name, { metres }]) => [name, metres]));
});

test('what is a length is read, and what is none is not', () => {
  assert.deepEqual(lengthFrom('0.1mm'), { value: 0.1, unit: 'mm' });
  assert.deepEqual(lengthFrom(' 1e-3 IN '), { value: 0.001, unit: 'in' });
  for (const text of ['0mm', '-1mm', 'mm', '1', '1km', '1..2mm', '1e999m', 5, undefined]) {
    assert.equal(lengthFrom(text), undefined, String(text));
  }
  assert.throws(() => checkOptions({ ratio: '2mm' }), { code: 'INVALID_OPTION' });
  assert.throws(() => checkOptions({ maxError: '2 miles' }), /a length like 0\.1mm/);
  assert.equal(inJavaScript('--max-error 0.1mm is'), "maxError: '0.1mm' is");
});

test('lengths are in the units of the model', () => {
  const given = { edgeLength: '1in', maxError: '1cm', thickness: 2, dropBelow: 'auto' };
  assert.deepEqual(inModelUnits(given, 'mm'),
    { edgeLength: 25.4, thickness: 2, dropBelow: 'auto', lengths: { maxError: 10 } });
  assert.deepEqual(inModelUnits({ lods: ['1px', '2px'] }).lodsBy, 'pixels');
  assert.throws(() => inModelUnits({ maxError: '1cm' }),
    /--max-error 1cm is a length, but the unit of the model is unknown.*/);
  assert.equal(lengthInWords(0.01234, 'm', 2), '12.3 mm');
  assert.equal(lengthInWords(0.5, 'in', 2), '0.5 in');
});

test('a bound as a length is the same bound in percent of the diagonal', async () => {
  const length = await remesh(ring, { ...draft, units: 'cm', maxError: '0.5mm' });
  const percent = await remesh(ring, { ...draft, maxError: 100 * 0.05 / length.report.diagonal });
  assert.deepEqual(length.mesh, percent.mesh);
  assert.equal(length.report.unit, 'cm');
  assert.ok(Math.abs(length.report.diagonal - diagonal) < 0.1);
  assert.ok(length.report.fidelity.hausdorff / 100 * length.report.diagonal <= 0.05);
});

test('an edge length has a unit in every format', async () => {
  const plain = await remeshFile(off, { name: 'a.off', edgeLength: 0.4, ...draft });
  const given = await remeshFile(off,
    { name: 'a.off', units: 'mm', edgeLength: '0.04cm', ...draft });
  assert.deepEqual(given.bytes, plain.bytes);
  const glb = await convertFile(off, { name: 'a.off', output: 'glb' });
  const metres = await remeshFile(glb.bytes, { name: 'a.glb', edgeLength: '40cm', ...draft });
  assert.equal(metres.report.unit, 'm');
  assert.equal(metres.report.output.vertices, plain.report.output.vertices);
  const threemf = await convertFile(off, { name: 'a.off', output: '3mf' });
  const millimetres = await remeshFile(threemf.bytes,
    { name: 'a.3mf', edgeLength: '0.4mm', ...draft });
  assert.equal(millimetres.report.unit, 'mm');
  assert.equal(millimetres.report.output.vertices, plain.report.output.vertices);
  assert.equal((await inspect(threemf.bytes, { name: 'a.3mf' })).unit, 'mm');
});

test('a 3MF states the unit that was said', async () => {
  for (const units of /** @type {const} */ (['in', 'm', 'mm'])) {
    const { bytes } = await repairFile(off, { name: 'a.off', output: '3mf', units, worker: false });
    assert.equal((await inspect(bytes, { name: 'a.3mf' })).unit, units);
    const again = await repairFile(bytes, { name: 'a.3mf', worker: false });
    assert.deepEqual(again.bytes, bytes);
    const converted = await convertFile(off, { name: 'a.off', output: '3mf', units });
    assert.equal((await inspect(converted.bytes, { name: 'a.3mf' })).unit, units);
  }
});

test('a glTF is in metres, by one node', async () => {
  const threemf = await convertFile(off, { name: 'a.off', output: '3mf', units: 'in' });
  const diagonalOf = async (/** @type {any} */ { bytes, name }) =>
    (await inspect(bytes, { name })).diagonal;
  const numbers = await diagonalOf({ bytes: threemf.bytes, name: 'a.3mf' });
  for (const output of ['glb', 'gltf']) {
    const metres = await convertFile(threemf.bytes, { name: 'a.3mf', output });
    const about = { name: metres.name,
      resources: Object.fromEntries(metres.files.map(({ name, bytes }) => [name, bytes])) };
    const { diagonal: length } = await inspect(metres.bytes, about);
    assert.ok(Math.abs(length / numbers - 0.0254) < 1e-6, `${length} of ${numbers}`);
    const again = await convertFile(metres.bytes, { ...about, output: '3mf' });
    assert.equal((await inspect(again.bytes, { name: 'a.3mf' })).unit, 'm');
  }
  const said = await repairFile(off, { name: 'a.off', output: 'glb', units: 'mm', worker: false });
  assert.ok(Math.abs(await diagonalOf(said) / numbers - 0.001) < 1e-6);
  const kept = await convertFile(threemf.bytes, { name: 'a.3mf', output: 'glb', metres: false });
  assert.ok(Math.abs(await diagonalOf(kept) / numbers - 1) < 1e-6);
});

test('repair takes lengths, too', async () => {
  const open = { ...ring, indices: ring.indices.slice(3 * 40) };
  const file = new TextEncoder().encode(offText(open));
  const name = 'open.off';
  const small = await repairFile(file,
    { name, repair: 'holes', units: 'mm', holesUpTo: '1mm', worker: false });
  const large = await repairFile(file,
    { name, repair: 'holes', units: 'mm', holesUpTo: '10cm', worker: false });
  assert.equal(small.report.repair.holes, 0);
  assert.ok(large.report.repair.holes > 0);
});

test('without a unit there is one sentence, on the command line in its words', async () => {
  await rejectsWith(remesh(ring, { maxError: '0.1mm', worker: false }), 'INVALID_OPTION',
    /^maxError: '0.1mm' is a length, but the unit of the model is unknown\./);
  writeFileSync(join(folder, 'a.off'), off);
  const run = (...words) => [join(root, 'dist/cli/cli.js'), 'a.off', ...words];
  const { status, stderr } = spawnSync(process.execPath,
    run('-o', 'b.stl', '--max-error', '0.1mm'), { cwd: folder, encoding: 'utf8' });
  assert.equal(status, 2);
  assert.match(stderr, /--max-error 0\.1mm is a length.* --units mm, cm, m or in\./);
  const { stderr: words } = spawnSync(process.execPath,
    run('-o', 'c.stl', '--units', 'mm', '--edge-length', '0.04cm', '--quality', 'draft'),
    { cwd: folder, encoding: 'utf8' });
  assert.match(words, /distance to the input: [\d.]+ % \([\d.]+ mm\)/);
  assert.match(words, /output: .*, 1 component, closed\n/);
  assert.match(words, /file: [\d.]+ kB, the input's [\d.]+ kB\n/);
});
