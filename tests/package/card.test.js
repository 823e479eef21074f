// SPDX-License-Identifier: MIT
// The report card: its figures are those of the report and of the files, and it says in three
// languages what is known, and nothing else.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { bakeFile, remeshFile, repairFile } from 'remesher';
import { cardRows, cardText, cardWords } from 'remesher/card';

import { coverageOf } from '../../dist/textures/coverage.js';
import { overlappingBoxes } from '../support/broken_shapes.js';
import { paintedBoxes } from '../support/painted_boxes.js';
import { offText, stl, torus } from '../support/shapes.js';
import { root } from '../support/tree.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-card-'));
after(() => rmSync(folder, { recursive: true }));

const bytesOf = (text) => new TextEncoder().encode(text);
const ring = torus({ columns: 24, rows: 12 });
const sum = (files) => files.reduce((all, { bytes }) => all + bytes.length, 0);
const languages = /** @type {const} */ (['en', 'de', 'fr']);

test('its figures are those of the report, and its bytes those of the files', async () => {
  const bytes = stl(ring);
  const { files, report } = await remeshFile(bytes, { name: 'ring.stl', output: 'gltf',
    vertices: 400, units: 'cm', quality: 'draft', worker: false });
  const { card, input, output, fidelity, diagonal } = report;
  assert.ok(files.length > 1, 'the data are a file of their own');
  assert.deepEqual([card.before.bytes, card.after.bytes], [bytes.length, sum(files)]);
  for (const [side, mesh] of [[card.before, input], [card.after, output]]) {
    const { triangles, vertices, pieces, closed, openEdges } = side;
    assert.deepEqual({ triangles, vertices, pieces, closed, openEdges },
      { triangles: mesh.triangles, vertices: mesh.vertices, pieces: mesh.components, closed: true,
        openEdges: 0 });
    assert.equal(side.selfIntersections, undefined, 'nobody looked for them');
  }
  assert.deepEqual(card.distance, { percent: fidelity.hausdorff,
    length: fidelity.hausdorff / 100 * diagonal, unit: 'cm' });
  assert.equal(card.hidden ?? card.coverage, undefined);
});

test('of a repair it has what met before and after; a sound file is nowhere away', async () => {
  const options = { name: 'a.stl', output: 'stl', worker: false };
  const { report } = await repairFile(stl(overlappingBoxes()), options);
  const { before, after: now, distance } = report.card;
  assert.deepEqual([before.selfIntersections, now.selfIntersections],
    report.repair.selfIntersections);
  assert.ok(before.selfIntersections > 0 && now.selfIntersections === 0);
  assert.equal(distance, undefined, 'it was not measured');
  const sound = await repairFile(stl(ring), options);
  assert.deepEqual([sound.report.card.distance.percent, sound.report.card.distance.length], [0, 0]);
});

test('what new textures use of their square is what baking says', async () => {
  const { files, report } = await bakeFile(paintedBoxes().bytes, bytesOf(offText(ring)),
    { name: 'boxes.glb', nameLow: 'ring.off', textureSize: 64, cage: 50, worker: false });
  assert.ok(Math.abs(coverageOf(files) - report.atlas.coverage) < 0.5,
    `${coverageOf(files)}, ${report.atlas.coverage} by the engine`);
  const options = { name: 'boxes.glb', faces: 300, textures: 'bake', textureSize: 64,
    worker: false };
  const alone = (await remeshFile(paintedBoxes().bytes, options)).report.card;
  const { card } = (await remeshFile(paintedBoxes().bytes, { ...options, lods: [0.5] })).report;
  assert.ok(alone.coverage > 20 && alone.coverage <= 100, `${alone.coverage} %`);
  assert.ok(Math.abs(card.coverage - alone.coverage) < 0.5, 'coarser levels are not added');
});

const side = { bytes: 1234, triangles: 1000, quads: 500, vertices: 502, pieces: 3, closed: false,
  openEdges: 1820, nonManifoldEdges: 7, selfIntersections: 12 };
const full = { before: side, after: { ...side, closed: true, openEdges: 0, bytes: 2_500_000 },
  distance: { percent: 0.25, length: 0.005, unit: 'm' }, hidden: 9, coverage: 63.25 };

test('it says all that is known, in each language with the same lines', () => {
  const [english, ...others] = languages.map((language) => cardRows(full, language));
  assert.deepEqual(english.map(({ name }) => name), ['triangles', 'quads', 'vertices', 'pieces',
    'closed', 'nonManifoldEdges', 'selfIntersections', 'hidden', 'coverage', 'distance', 'bytes']);
  for (const rows of others) {
    assert.deepEqual(rows.map(({ name }) => name), english.map(({ name }) => name));
  }
  const said = Object.fromEntries(english.map(({ name, before, after: now }) =>
    [name, [before, now]]));
  assert.deepEqual(said.closed, ['no: 1,820 open edges', 'yes']);
  assert.deepEqual(said.distance, ['', '0.25 % of the diagonal (5 mm)']);
  assert.deepEqual(said.bytes, ['1.23 kB', '2.5 MB']);
  assert.deepEqual(said.hidden, ['9', '0']);
  const { hidden, coverage, distance, ...least } = full;
  assert.ok(hidden && coverage && distance);
  assert.ok(!cardRows(least).some(({ name }) => ['hidden', 'coverage', 'distance'].includes(name)));
  const tiny = { ...full, distance: { percent: 1e-6, length: 1e-8, unit: 'm' } };
  assert.equal(cardRows(tiny).find(({ name }) => name === 'distance').after,
    '< 0.0001 % of the diagonal');
});

test('every language has every word, with the same gaps', () => {
  const gaps = (text) => text.match(/\{\w+\}/g);
  for (const words of Object.values(cardWords)) {
    assert.deepEqual(Object.keys(words), Object.keys(cardWords.en));
    for (const [name, text] of Object.entries(words)) {
      assert.ok(text.trim());
      assert.deepEqual(gaps(text), gaps(cardWords.en[name]), name);
    }
  }
});

test('its text is a heading and a table, whatever the title', () => {
  for (const language of languages) {
    const lines = cardText(full, { language, title: 'a|b\n# c_d.glb' }).split('\n');
    assert.equal(lines[0], `# ${cardWords[language].title}: a\\|b \\# c\\_d.glb`);
    const table = lines.slice(2, -1);
    assert.equal(table.length, 2 + cardRows(full, language).length);
    assert.ok(table.every((line) => line.split('|').length === 5), table.join('\n'));
    assert.equal(lines.at(-1), '');
  }
});

const run = (...words) => spawnSync(process.execPath, [join(root, 'dist/cli/cli.js'), ...words],
  { cwd: folder, encoding: 'utf8' });

test('the command line writes it beside the result, or not at all', () => {
  writeFileSync(join(folder, 'ring.stl'), stl(ring));
  const words = ['ring.stl', '-o', 'out.stl', '--vertices', '300', '--quality', 'draft'];
  const { status, stdout } = run(...words, '--card', 'card.md', '--json');
  assert.equal(status, 0);
  assert.equal(readFileSync(join(folder, 'card.md'), 'utf8'),
    cardText(JSON.parse(stdout).card, { title: 'ring.stl' }));
  for (const [refused, why] of [
    [['inspect', 'ring.stl', '--card', 'b.md'], /remesher inspect has no --card/],
    [['ring.stl', '-o', 'many/', '--card', 'b.md'], /--card takes a single input file/],
    [[...words, '--card', 'b.stl'], /b\.stl is a text/],
    [[...words, '--card', 'none/b.md'], /none.b\.md cannot be written/],
    [['lost.stl', '-o', 'c.stl', '--card', 'b.md'], /lost\.stl/]]) {
    const result = run(...refused);
    assert.equal(result.status, 2, result.stderr);
    assert.match(result.stderr, why);
    assert.ok(!existsSync(join(folder, 'b.md')));
  }
});
