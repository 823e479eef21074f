// SPDX-License-Identifier: MIT
// What a file is by its bytes decides, and its name only helps: any format under any name, packed
// or compressed, with what it refers to; through the package and the command line.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { convertFile, inspect, remeshFile } from 'remesher';
import { readFormats } from 'remesher/formats';

import { meshopt } from '../fuzz/compressed_case.js';
import { rejectsWith } from '../support/errors.js';
import { glbBytes, torus } from '../support/shape_files.js';
import { root } from '../support/tree.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-names-'));
after(() => rmSync(folder, { recursive: true }));

const ring = glbBytes(torus(12, 8));
/** The same model in each format, with the files that it refers to. */
const models = Object.fromEntries(await Promise.all(readFormats.map(async (format) => {
  const { files: [{ bytes }, ...others] } =
    await convertFile(ring, { name: 'a.glb', output: format });
  return [format, { bytes, resources: Object.fromEntries(others.map((file) =>
    [file.name, file.bytes])) }];
})));
const contradictions = (warnings) =>
  warnings.filter(({ code }) => code === 'NAME_CONTRADICTS').map(({ message }) => message);

test('any format is read under any name, and a wrong one is said', async () => {
  const pairs = readFormats.flatMap((format) => readFormats.flatMap((called) =>
    ['', '.gz'].map((end) => ({ format, called, end }))));
  for (const { format, called, end } of pairs) {
    const { bytes, resources } = models[format];
    const name = `x.${called}${end}`;
    const packed = end === '' ? bytes : new Uint8Array(gzipSync(bytes));
    const { input, warnings } = await inspect(packed, { name, resources });
    assert.equal(input.triangles, 192, `${format} called ${name}`);
    const said = contradictions(warnings);
    const expected = new RegExp(`^x\\.${called} is an? .* called \\.${called}:`);
    assert.equal(said.length, format === called ? 0 : 1, `${format} called ${name}`);
    for (const message of said) assert.match(message, expected);
  }
});

test('compressed glTF is unpacked under any name', async () => {
  const { input } = await inspect(meshopt.bytes, { name: 'a.glb' });
  for (const called of ['gltf', 'obj', 'stl']) {
    const wrong = await inspect(meshopt.bytes, { name: `a.${called}` });
    assert.equal(wrong.input.triangles, input.triangles);
    assert.equal(contradictions(wrong.warnings).length, 1);
  }
});

test('a result is what its name says, whatever the input was called', async () => {
  const { bytes, warnings } = await convertFile(models.obj.bytes, { name: 'a.stl', output: 'ply' });
  assert.match(Buffer.from(bytes.subarray(0, 4)).toString(), /^ply\n/);
  assert.equal(contradictions(warnings).length, 1);
  const run = await remeshFile(models.ply.bytes, { name: 'a.obj', vertices: 60 });
  assert.equal(run.name, 'a.obj');
  assert.match(Buffer.from(run.bytes).toString(), /^v /m);
  assert.equal(contradictions(run.report.warnings).length, 1);
});

test('what is no model is called what it is', async () => {
  const pages = { '<!DOCTYPE html><html><title>404</title></html>': /a web page \(HTML\)/,
    '{"message":"Not Found"}': /JSON/, '# vtk DataFile Version 3.0\n': /a VTK file/,
    'Kaydara FBX Binary  ': /an FBX file/, 'ISO-10303-21;\n': /a STEP file/ };
  for (const [text, what] of Object.entries(pages)) {
    for (const name of ['a.obj', 'a.stl', 'a.ply', 'a.off', 'a.glb']) {
      await rejectsWith(inspect(new TextEncoder().encode(text), { name }), 'UNKNOWN_FORMAT', what);
    }
  }
});

test('the command line finds what a file of a wrong name refers to, and says so', () => {
  mkdirSync(join(folder, 'beside'));
  for (const [name, bytes] of Object.entries(models.gltf.resources)) {
    writeFileSync(join(folder, name), bytes);
  }
  writeFileSync(join(folder, 'ring.ply'), models.gltf.bytes);
  writeFileSync(join(folder, 'm.mtl'), 'newmtl red\nKd 1 0 0\n');
  writeFileSync(join(folder, 'red.off'), `mtllib m.mtl\nusemtl red\n${
    Buffer.from(models.obj.bytes).toString().replace(/^mtllib.*$/gm, '')}`);
  const run = (...words) => spawnSync(process.execPath, [join(root, 'dist/cli/cli.js'), ...words],
    { cwd: folder, encoding: 'utf8', timeout: 60_000 });
  for (const name of ['ring.ply', 'red.off']) {
    const { status, stderr, stdout } = run('convert', name, '-o', 'beside/out.obj', '--json',
      '--force');
    assert.equal(status, 0, stderr);
    assert.equal(contradictions(JSON.parse(stdout).warnings).length, 1, stdout);
  }
  assert.match(readFileSync(join(folder, 'beside/m.mtl'), 'utf8'), /newmtl red/);
});
