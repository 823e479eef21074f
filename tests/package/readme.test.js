// SPDX-License-Identifier: MIT
// What README.md prints for programs and the command line runs as it is printed.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { convertFile, inspect, remesh } from 'remesher';

import { printedExample, tableRows } from '../bench/readme.js';
import { linkInstalled } from '../support/installed.js';
import { loadModel } from '../bench/models.js';
import { offText, plyText, sheet, stl, torus } from '../support/shapes.js';
import { readText } from '../support/tree.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-readme-'));
after(() => rmSync(folder, { recursive: true }));
const packages = linkInstalled(folder);
const text = readText('README.md');

const off = offText(torus({ columns: 40, rows: 20 }));
const converted = async (/** @type {string} */ output) =>
  (await convertFile(new TextEncoder().encode(off), { name: 'torus.off', output })).bytes;
const colours = ['red', 'green', 'blue'].map((name) => `\nproperty uchar ${name}`).join('');
const coloured = plyText(sheet()).replace('float z', `float z${colours}`)
  .replace(/^[-\d.e]+ [-\d.e]+ [-\d.e]+$/gm, '$& 200 100 0');

for (const place of ['scans', 'models']) mkdirSync(join(folder, place));
for (const [name, content] of Object.entries({
  'package.json': '{ "type": "module", "private": true }', 'horse.obj': await converted('obj'),
  'horse.glb': await converted('glb'), 'models/b.off': off, 'scans/a.stl': stl(torus()),
  'scan.stl': stl(torus()), 'drill.stl': stl(torus({ radius: 1.7 })),
})) writeFileSync(join(folder, name), content);

/** @param {string} command @param {string[]} words @returns what it prints */
function outputOf(command, words) {
  const { status, stdout, stderr } = spawnSync(command, words, { cwd: folder, encoding: 'utf8',
    timeout: 120_000, stdio: ['ignore', 'pipe', 'pipe'],
    env: { ...process.env, PATH: `${join(packages, '.bin')}:${process.env.PATH}` } });
  assert.equal(status, 0, stderr);
  return stdout;
}

const report = [/10000 vertices, \d+ bytes/, /minimum angle: mean \d\d\.\d°, worst \d\d\.\d°/,
  /distance to the original: \d\.\d{3} % of the diagonal/];

/** Of each program, in their order: what it finds, what is asked of it then, and the answer. */
const programs = [
  { finds: '', asks: '', answer: new RegExp(report.map(({ source }) => source).join('\n')) },
  { finds: `const files = [new File([${JSON.stringify(off)}], 'a.off')];`,
    asks: 'results[0].name + results[0].report.output.vertices', answer: /^a\.off400$/ },
  { finds: `import { Group, Mesh, TorusGeometry } from 'three';
const mesh = new Mesh(new TorusGeometry(1, 0.4, 20, 40));
const gltf = { scene: new Group().add(new Mesh(mesh.geometry)) };`,
  asks: 'report.output.vertices', answer: /^10000$/ },
  { finds: `import { NodeIO } from '@gltf-transform/core';
const document = await new NodeIO().read('horse.glb');`,
  asks: "document.getRoot().listAccessors().map((each) => each.getCount()).join(' ')",
  answer: /\b10000\b/ },
  { finds: `const file = new File([${JSON.stringify(coloured)}], 'scan.ply');`,
    asks: "String(bytes.slice(0, 4)) + String(bytes).includes('255,216,255')",
    answer: /^103,108,84,70true$/ },
];

test('the programs do what is said beside them', { timeout: 240_000 }, () => {
  const printed = [...text.matchAll(/```js\n([^]*?)```/g)];
  assert.equal(printed.length, programs.length);
  for (const [i, { finds, asks, answer }] of programs.entries()) {
    writeFileSync(join(folder, 'program.js'),
      `${finds}\n${printed[i][1]}\n${asks && `console.log(${asks});`}`);
    assert.match(outputOf(process.execPath, ['program.js']).trim(), answer);
  }
  const [, said] = text.match(/prints\n\n((?: {4}.+\n)+)/) ?? [];
  assert.match(said.replace(/^ {4}/gm, '').trim(), programs[0].answer);
});

/** The numbers of a sentence of README. @param {RegExp} sentence */
const printedIn = (sentence) => {
  const found = sentence.exec(text.replace(/\s+/g, ' '));
  assert.ok(found, String(sentence));
  return found.slice(1).map(Number);
};

/** As near as one version of remesher is to the next. */
function near(what, printed, now, far) {
  assert.ok(Math.abs(printed - now) <= far, `${what}: ${printed} in README, ${now} now`);
}

test('the bunny of the pictures has the printed figures', async () => {
  const bunny = loadModel('npm:bunny', undefined);
  const [vertices, ...printed] = printedIn(new RegExp('bunny has (\\d+) vertices on both sides.'
    + ' .* from ([\\d.]+)° to ([\\d.]+)° .* worst from ([\\d.]+)° to ([\\d.]+)°, .* from (\\d+) %'
    + ' to (\\d+) %'));
  const { input } = await inspect(bunny);
  const { report: { output } } = await remesh(bunny, {});
  assert.deepEqual([input.vertices, output.vertices], [vertices, vertices]);
  const now = [input.minAngle.mean, output.minAngle.mean, input.minAngle.worst,
    output.minAngle.worst, input.minAngle.histogram[5], output.minAngle.histogram[5]];
  now.forEach((figure, i) => near('bunny', printed[i], figure, i < 4 ? 0.6 : 3));
  const [count, irregular, angle] = printedIn(new RegExp('bunny has (\\d+) quads and (\\d+)'
    + ' irregular vertices, and its angles are ([\\d.]+)°'));
  const quads = (await remesh(bunny, { quads: true, vertices: 3000 })).report.output.quads;
  near('quads', count, quads.count, 0.01 * count);
  near('irregular vertices', irregular, quads.irregular, 0.3 * irregular);
  near('angles of quads', angle, quads.angleDeviation.mean, 0.3);
});

test('figures that are printed twice are the same', () => {
  const { lines, medians } = printedExample(text);
  const horse = tableRows(text).find(({ model, scheme }) => model === 'horse' && scheme === 'best');
  const [, mean, worst, distance] = horse.figures;
  assert.deepEqual(medians.slice(0, 3), [mean, worst, distance]);
  assert.equal(tableRows(text).length, 6);
  const [[one], [far]] = [lines[2], medians[3]].map((words) => words.match(/\d+\.\d+/));
  assert.ok(Number(one) <= Number(far), 'one count is no worse than the worst of seven');
});

test('the commands work', { timeout: 240_000 }, () => {
  const [, part] = text.match(/## Command line\n\n((?: {4}.+\n)+)/) ?? [];
  const commands = part.trim().split(/\n */);
  assert.ok(commands.length >= 5);
  for (const command of commands) outputOf('bash', ['-ec', `set -o pipefail; ${command}`]);
  assert.deepEqual(readdirSync(join(folder, 'out')), ['a.glb', 'b.glb']);
});
