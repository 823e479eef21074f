// SPDX-License-Identifier: MIT
// Files that are read in blocks, never whole: binary PLY and STL. Read whole, they give the same
// bytes.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import {
  mkdirSync, mkdtempSync, readFileSync, rmSync, truncateSync, writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { isReadInBlocks } from '../../dist/base/contents.js';
import { withInput } from '../../dist/files/input.js';
import { remeshFile } from '../../dist/node.js';
import { stl, torus } from '../support/shapes.js';
import { root } from '../support/tree.js';

const top = mkdtempSync(join(tmpdir(), 'remesher-blocks-'));
const cli = join(root, 'dist/cli/cli.js');
after(() => rmSync(top, { recursive: true }));

/** Large enough for more than one block. */
const shape = torus({ columns: 300, rows: 150 });

function plyBytes({ positions, indices }) {
  const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${positions.length / 3}\n`
    + 'property float x\nproperty float y\nproperty float z\n'
    + `element face ${indices.length / 3}\nproperty list uchar int vertex_indices\nend_header\n`;
  const faces = Buffer.alloc((13 * indices.length) / 3);
  for (let i = 0; i < indices.length; i += 3) {
    const at = (13 * i) / 3;
    faces[at] = 3;
    for (let k = 0; k < 3; k += 1) faces.writeInt32LE(indices[i + k], at + 1 + 4 * k);
  }
  return Buffer.concat([Buffer.from(header), Buffer.from(Float32Array.from(positions).buffer),
    faces]);
}

const files = { 'torus.ply': plyBytes(shape), 'torus.stl': Buffer.from(stl(shape)) };
for (const [name, bytes] of Object.entries(files)) writeFileSync(join(top, name), bytes);
const options = { vertices: 400 };

for (const [name, bytes] of Object.entries(files)) {
  test(`${name} gives the same bytes in blocks, whole, as a Blob, by a pipe`, async () => {
    assert.ok(bytes.length > 2 ** 20);
    const request = { name, output: 'out.ply', ...options };
    const wanted = Buffer.from((await remeshFile(bytes, request)).bytes);
    for (const worker of [true, false]) {
      const { bytes: ofBlob } = await remeshFile(new Blob([bytes]), { ...request, worker });
      assert.deepEqual(Buffer.from(ofBlob), wanted, 'a Blob');
    }
    const run = (/** @type {string[]} */ ...words) =>
      execFileSync(process.execPath, [cli, ...words], { cwd: top, stdio: 'pipe' });
    run(name, '-o', 'blocks.ply', '--vertices', '400', '--force');
    assert.deepEqual(readFileSync(join(top, 'blocks.ply')), wanted);
    execFileSync('sh', ['-c', `cat ${name} | ${process.execPath} ${cli} /dev/stdin -o piped.ply `
      + '--vertices 400 --force'], { cwd: top, stdio: 'pipe' });
    assert.deepEqual(readFileSync(join(top, 'piped.ply')), wanted);
    mkdirSync(join(top, 'in'), { recursive: true });
    writeFileSync(join(top, 'in', name), bytes);
    run(join('in', name), '-o', 'out/', '--format', 'ply', '--vertices', '400', '--force');
    assert.deepEqual(readFileSync(join(top, 'out', 'torus.ply')), wanted);
  });

  test(`${name} in blocks is inspected, and converted to itself`, () => {
    const run = (/** @type {string[]} */ ...words) => spawnSync(process.execPath, [cli, ...words],
      { cwd: top, encoding: 'utf8' });
    const { input } = JSON.parse(run('inspect', name, '--json').stdout);
    assert.equal(input.vertices, 300 * 150);
    assert.equal(input.triangles, 2 * 300 * 150);
    assert.equal(run('convert', name, '-o', `same-${name}`, '--quiet').status, 0);
    const same = readFileSync(join(top, `same-${name}`));
    if (name.endsWith('.ply')) assert.deepEqual(same, bytes);
    else assert.equal(same.length, bytes.length);
  });

  test(`${name} is opened without being read`, async () => {
    const path = join(top, name);
    const { bytes: begin, handle } = await withInput(path, async (file) => file);
    assert.deepEqual(Buffer.from(begin), bytes.subarray(0, 65536));
    assert.equal(handle?.size, bytes.length);
  });
}

test('a file that becomes shorter while it is read is refused in a sentence', async () => {
  const path = join(top, 'short.ply');
  writeFileSync(path, files['torus.ply']);
  const { Api } = await import('../../dist/api/api.js');
  const { platform } = await import('../../dist/cli/platform.js');
  await withInput(path, async (file) => {
    truncateSync(path, 100_000);
    const run = { name: 'short.ply', worker: false, ...options };
    await assert.rejects(new Api(platform).remeshFile(file, run), { code: 'INPUT_UNREADABLE',
      message: /^short\.ply cannot be read from byte \d+ on\.$/ });
  });
});

test('only what nothing but the core looks into is read in blocks', () => {
  const begins = (/** @type {Uint8Array} */ bytes, size = bytes.length) =>
    isReadInBlocks(Uint8Array.from(bytes.subarray(0, 65536)), size);
  const { 'torus.ply': ply, 'torus.stl': facets } = files;
  assert.ok(begins(ply) && begins(facets));
  assert.ok(!begins(facets, facets.length + 1), 'no length of an STL');
  const text = Buffer.from(ply.toString('latin1').replace('binary_little_endian', 'ascii'),
    'latin1');
  assert.ok(!begins(text), 'a text');
  assert.ok(!begins(ply.subarray(0, 100)), 'no end of the header');
  const named = Buffer.from(facets);
  named.write('{"asset": 1}');
  assert.ok(!begins(named), 'what may be glTF');
});
