// SPDX-License-Identifier: MIT
// Files in a .gz, through everything that reads files, and those that are not what they seem.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { convertFile, inspect, remeshFile } from 'remesher';
import { gunzip, largestInflated } from 'remesher/gunzip';

import { rejectsWith } from '../support/errors.js';
import { gltfParts } from '../support/shape_files.js';
import { offText, plyText, stl, torus } from '../support/shapes.js';
import { root } from '../support/tree.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-gz-'));
after(() => rmSync(folder, { recursive: true }));

const encode = (text) => new TextEncoder().encode(text);
const plain = { off: encode(offText(torus())), ply: encode(plyText(torus())), stl: stl(torus()) };

for (const [format, bytes] of Object.entries(plain)) {
  test(`a .${format}.gz is read as what is inside, and named after it`, async () => {
    const packed = new Uint8Array(gzipSync(bytes));
    const options = { name: `scan.${format}.gz`, vertices: 300 };
    const result = await remeshFile(packed, options);
    assert.equal(result.name, `scan.${format}`);
    const expected = await remeshFile(bytes, { ...options, name: `scan.${format}` });
    assert.deepEqual(result.bytes, expected.bytes);
    const glb = await remeshFile(packed, { ...options, output: 'glb' });
    assert.equal(glb.name, 'scan.glb');
    assert.equal((await inspect(packed, { name: `scan.${format}` })).input.vertices, 48 * 24);
    const off = await convertFile(packed, { name: options.name, output: 'off' });
    assert.equal(off.name, 'scan.off');
  });
}

test('what a glTF refers to may be in a .gz, and so may the glTF', async () => {
  const triangles = Array.from({ length: torus().indices.length / 3 }, (_, i) =>
    Array.from(torus().indices.subarray(3 * i, 3 * i + 3)));
  const positions = Array.from({ length: torus().positions.length / 3 }, (_, i) =>
    Array.from(torus().positions.subarray(3 * i, 3 * i + 3)));
  const { json, buffer } = gltfParts({ positions, triangles });
  json.buffers[0].uri = 'scene.bin';
  const packed = gzipSync(JSON.stringify(json));
  const resources = { 'scene.bin.gz': new Uint8Array(gzipSync(buffer)) };
  const { input } = await inspect(new Uint8Array(packed), { name: 'scene.gltf.gz', resources });
  assert.equal(input.vertices, 48 * 24);

  writeFileSync(join(folder, 'scene.gltf.gz'), packed);
  writeFileSync(join(folder, 'scene.bin'), buffer);
  const run = (...words) => spawnSync(process.execPath,
    [join(root, 'dist/cli/cli.js'), ...words], { cwd: folder, encoding: 'utf8' });
  const inspection = run('inspect', 'scene.gltf.gz', '--json');
  assert.equal(inspection.status, 0, inspection.stderr);
  assert.equal(JSON.parse(inspection.stdout).input.vertices, 48 * 24);
  const { status, stderr } = run('scene.gltf.gz', '-o', 'out.ply', '--vertices', '300', '--quiet');
  assert.equal(status, 0, stderr);
  assert.match(readFileSync(join(folder, 'out.ply'), 'latin1'), /^ply\n[^]*element vertex 300\n/);
});

test('a .gz that is cut short or damaged is refused in a sentence', async () => {
  const packed = new Uint8Array(gzipSync(plain.stl));
  const options = { name: 'scan.stl.gz', vertices: 300 };
  for (const length of [4, 100, packed.length - 1]) {
    await rejectsWith(remeshFile(packed.subarray(0, length), options), 'PARSE_ERROR',
      /^scan\.stl\.gz: its gzip is damaged or cut short\.$/);
  }
  const damaged = packed.slice();
  damaged[packed.length >> 1] ^= 0xff;
  await rejectsWith(remeshFile(damaged, options), 'PARSE_ERROR', /gzip is damaged/);
});

test('a name that ends in .gz promises nothing', async () => {
  const { input } = await inspect(plain.ply, { name: 'scan.gz' });
  assert.equal(input.vertices, 48 * 24);
});

test('what unpacks to more than the limit is refused before it is all there', async () => {
  assert.equal(largestInflated, 1073741824, 'one gibibyte, as the README says');
  const zeros = new Uint8Array(gzipSync(Buffer.alloc(64 * 2 ** 20)));
  const limit = 2 ** 20;
  const before = process.memoryUsage().arrayBuffers;
  let highest = 0;
  const watch = setInterval(() => {
    highest = Math.max(highest, process.memoryUsage().arrayBuffers - before);
  }, 1);
  await rejectsWith(gunzip({ name: 'bomb.ply.gz', bytes: zeros }, limit), 'UNSUPPORTED',
    /^bomb\.ply\.gz: it unpacks to more than 1048576 bytes/);
  clearInterval(watch);
  assert.ok(highest < 16 * limit, `held ${highest} bytes`);
  const { bytes } = await gunzip({ name: 'a.gz', bytes: zeros.slice() }, 64 * 2 ** 20);
  assert.equal(bytes.length, 64 * 2 ** 20);
});
