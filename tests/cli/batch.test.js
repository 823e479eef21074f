// SPDX-License-Identifier: MIT
// Many files on the command line: what is found, what is written where, and what one bad file does.
import assert from 'node:assert/strict';
import {
  existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { clashes, plan } from '../../dist/cli/plan.js';
import { interrupted, run, snapshot } from '../support/faults.js';
import { glbBytes, objText, torus } from '../support/shape_files.js';

const top = mkdtempSync(join(tmpdir(), 'remesher-batch-'));
after(() => rmSync(top, { recursive: true }));
const at = (...parts) => join(top, ...parts);

for (const folder of ['models/deep/er', 'models/.hidden', 'scans']) {
  mkdirSync(at(folder), { recursive: true });
}
const obj = objText(torus(12, 8));
for (const file of ['models/a.obj', 'models/deep/b.obj', 'models/deep/er/a.OBJ', 'scans/x.obj',
  'scans/y.obj', 'models/.hidden/no.obj', 'models/.no.obj']) writeFileSync(at(file), obj);
writeFileSync(at('scans/z.glb'), glbBytes(torus(12, 8)));
writeFileSync(at('models/readme.txt'), 'text');
writeFileSync(at('scan.stl.gz'), '');
symlinkSync('..', at('models/deep/up'));

/** input → output, from the top. */
const planned = (names, format = '') => Object.fromEntries(
  plan(names.map((name) => at(name)), at('out/'), format).map(({ input, output }) =>
    [input.slice(top.length + 1), output.slice(top.length + 1)]));

test('folders, patterns and files are planned; results keep their way below a folder', () => {
  assert.deepEqual(planned(['models'], 'glb'), {
    'models/a.obj': 'out/a.glb',
    'models/deep/b.obj': 'out/deep/b.glb',
    'models/deep/er/a.OBJ': 'out/deep/er/a.glb',
  });
  assert.deepEqual(planned(['scans/*.obj']),
    { 'scans/x.obj': 'out/x.obj', 'scans/y.obj': 'out/y.obj' });
  assert.deepEqual(planned(['scans/?.glb', 'scans/x.obj', 'scans']),
    { 'scans/z.glb': 'out/z.glb', 'scans/x.obj': 'out/x.obj', 'scans/y.obj': 'out/y.obj' });
  assert.deepEqual(planned(['models/**/b.obj']), { 'models/deep/b.obj': 'out/b.obj' });
  assert.deepEqual(planned(['scan.stl.gz'], ''), { 'scan.stl.gz': 'out/scan.stl' });
  for (const nothing of ['scans/*.off', 'models/.hidden/er*']) {
    const [{ error }] = plan([at(nothing)], at('out/'), '');
    assert.match(error.message, /there is no model/);
  }
});

test('two inputs with one result are found', () => {
  const steps = plan([at('scans/x.obj'), at('models'), at('models/deep/er')], at('out/'), 'glb');
  assert.deepEqual([...clashes(steps)], []);
  const alike = plan([at('models/a.obj'), at('models/deep/er/a.OBJ')], at('out/'), 'glb');
  assert.deepEqual([...clashes(alike)].map(({ input }) => input), [at('models/deep/er/a.OBJ')]);
});

test('all are remeshed, and one bad file does not stop the others', () => {
  writeFileSync(at('scans/bad.obj'), 'f 1 2 3\n');
  const words = ['scans/', 'models/deep', '-o', 'out/', '--format', 'glb', '--vertices', '60'];
  const { status, stdout, stderr } = run(top, ...words, '--jobs', '2', '--json');
  assert.equal(status, 2, stderr);
  assert.match(stderr, /^remesher: scans\/bad\.obj: [^\n]*INDEX_OUT_OF_RANGE\]\n$/);
  const lines = stdout.trim().split('\n').map((line) => JSON.parse(line));
  const byFile = Object.fromEntries(lines.map((line) => [line.file, line]));
  assert.deepEqual(Object.keys(byFile).sort(), ['models/deep/b.obj', 'models/deep/er/a.OBJ',
    'scans/bad.obj', 'scans/x.obj', 'scans/y.obj', 'scans/z.glb']);
  assert.equal(byFile['scans/bad.obj'].error.code, 'INDEX_OUT_OF_RANGE');
  assert.equal(byFile['scans/x.obj'].output.vertices, 60);
  assert.equal(byFile['models/deep/er/a.OBJ'].result, 'out/er/a.glb');
  assert.deepEqual(Object.keys(snapshot(at('out'))),
    ['b.glb', 'er/a.glb', 'x.glb', 'y.glb', 'z.glb']);
});

test('all are mended and made of quads', () => {
  mkdirSync(at('torn'));
  for (const name of ['a', 'b']) {
    writeFileSync(at('torn', `${name}.obj`), obj.trimEnd().split('\n').slice(0, -1).join('\n'));
  }
  const words = ['torn/', '-o', 'whole/', '--quads', '--repair', 'auto', '--vertices', '200'];
  const { status, stdout, stderr } = run(top, ...words, '--jobs', '2', '--json');
  assert.equal(status, 0, stderr);
  const reports = stdout.trim().split('\n').map((line) => JSON.parse(line));
  assert.deepEqual(reports.map(({ file }) => file).sort(), ['torn/a.obj', 'torn/b.obj']);
  for (const { input, output, repair } of reports) {
    assert.deepEqual([input.boundaryEdges, repair.holes, output.boundaryEdges], [3, 1, 0]);
    assert.equal(output.triangles, 2 * output.quads.count);
  }
  for (const name of ['a', 'b']) {
    const faces = readFileSync(at('whole', `${name}.obj`), 'utf8').match(/^f .*$/gm);
    assert.ok(faces.every((face) => face.split(' ').length === 5), name);
  }
});

test('results that are there stay, unless --force; --skip-existing goes on where it was', () => {
  mkdirSync(at('again'));
  writeFileSync(at('again/x.obj'), 'mine');
  const words = ['convert', 'scans/x.obj', 'scans/y.obj', '-o', 'again/'];
  const refused = run(top, ...words);
  assert.equal(refused.status, 2);
  assert.match(refused.stderr, /again\/x\.obj cannot be written: it is there already.*--force/);
  assert.match(refused.stderr, /scans\/y\.obj → again\/y\.obj: done/);
  assert.equal(readFileSync(at('again/x.obj'), 'utf8'), 'mine');
  const skipped = run(top, ...words, '--skip-existing');
  assert.equal(skipped.status, 0, skipped.stderr);
  assert.match(skipped.stderr, /scans\/x\.obj: skipped/);
  assert.equal(readFileSync(at('again/x.obj'), 'utf8'), 'mine');
  assert.equal(run(top, ...words, '--force', '--quiet').status, 0);
  assert.match(readFileSync(at('again/x.obj'), 'utf8'), /^v /m);
});

test('no input is written over, even with --force', () => {
  const before = snapshot(at('scans'));
  const { status } = run(top, 'convert', 'scans/', '-o', 'scans/', '--force');
  assert.equal(status, 2);
  assert.deepEqual(snapshot(at('scans')), before);
});

test('folders that a run made for nothing go again, when it is interrupted and when all fail',
  async () => {
    const words = ['models/deep/', '-o', 'none/at/all/', '--vertices', '100000'];
    const { signal } = await interrupted(top, words, { signal: 'SIGINT', after: 100, since: top });
    assert.equal(signal, 'SIGINT');
    assert.ok(!existsSync(at('none')));
    mkdirSync(at('mine'));
    assert.equal(run(top, 'scans/bad.obj', '-o', 'mine/none/').status, 2);
    assert.deepEqual(readdirSync(at('mine')), []);
  });

test('words that do not go together are refused', () => {
  const cases = {
    'is for many files': ['scans/x.obj', '-o', 'x.glb', '--jobs', '2'],
    'whole number': ['scans/x.obj', '-o', 'x/', '--jobs', 'all'],
    'end in /': ['scans/x.obj', 'scans/y.obj', '-o', 'x.glb'],
    'no such file': ['nothere/', '-o', 'x/'],
  };
  for (const [words, line] of Object.entries(cases)) {
    const { status, stderr } = run(top, ...line);
    assert.equal(status, 2);
    assert.match(stderr, new RegExp(`^remesher: [^\\n]*${words}[^\\n]*\\n$`));
  }
  assert.ok(!existsSync(at('x')));
});
