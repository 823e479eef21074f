// SPDX-License-Identifier: MIT
// Files that are read in blocks, never whole: binary PLY and STL, also from streams, pipes and .gz;
// GLB and texts, an OBJ in blocks, of which JavaScript holds only the beginning. Read whole, they
// give the same bytes.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import {
  mkdirSync, mkdtempSync, readFileSync, rmSync, truncateSync, writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Readable } from 'node:stream';
import { after, test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { isReadInBlocks } from '../../dist/base/contents.js';
import { blocksOfPieces, Pieces } from '../../dist/base/pieces.js';
import { withInput } from '../../dist/files/input.js';
import { convertFile, inspect, remeshFile } from '../../dist/node.js';
import { objText } from '../support/shape_files.js';
import { offText, stl, torus } from '../support/shapes.js';
import { root } from '../support/tree.js';

const top = mkdtempSync(join(tmpdir(), 'remesher-blocks-'));
const cli = join(root, 'dist/cli/cli.js');
after(() => rmSync(top, { recursive: true }));

/** Large enough for more than one block. */
const [columns, rows] = [230, 120];
const shape = torus({ columns, rows });

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
const numbered = { positions: Array.from({ length: shape.positions.length / 3 }, (_, v) =>
  Array.from(shape.positions.subarray(3 * v, 3 * v + 3), Math.fround)),
triangles: Array.from({ length: shape.indices.length / 3 }, (_, t) =>
  Array.from(shape.indices.subarray(3 * t, 3 * t + 3))) };
const asGlb = await convertFile(stl(shape), { name: 'torus.stl', output: 'glb' });
const begun = { 'torus.glb': Buffer.from(asGlb.bytes), 'torus.obj': Buffer.from(objText(numbered)),
  'torus.off': Buffer.from(offText(shape)) };
for (const [name, bytes] of Object.entries(files)) writeFileSync(join(top, name), bytes);
const options = { vertices: 400, quality: 'draft' };
const asWords = ['--vertices', '400', '--quality', 'draft', '--force'];

/** Bytes in chunks of a length. */
function* chunksOf(bytes, length) {
  for (let at = 0; at < bytes.length; at += length) yield bytes.subarray(at, at + length);
}

/** The ways to give bytes. */
function waysOf(bytes) {
  const packed = gzipSync(bytes);
  return {
    'a Blob': () => new Blob([bytes]),
    'a stream of short chunks': () => ReadableStream.from(chunksOf(bytes, 777)),
    'one of long chunks': () => Readable.from(chunksOf(bytes, 3_000_001)),
    'a .gz': () => packed,
    'a Blob that is packed': () => new Blob([packed]),
    'a packed stream': () => Readable.from(chunksOf(packed, 100_000)),
  };
}

for (const [name, bytes] of Object.entries(files)) {
  test(`${name} gives the same bytes in blocks, whole, as a Blob, by a pipe`, async () => {
    assert.ok(bytes.length > 2 ** 20);
    const request = { name, output: 'out.ply' };
    const whole = Buffer.from((await convertFile(bytes, request)).bytes);
    for (const [i, [way, given]] of Object.entries(waysOf(bytes)).entries()) {
      const worker = i % 2 === (name.endsWith('.ply') ? 0 : 1);  // each way in one, by one of both
      const { bytes: made } = await convertFile(given(), { ...request, worker });
      assert.deepEqual(Buffer.from(made), whole, `${way}${worker ? ', in a worker' : ''}`);
    }
    const run = (/** @type {string[]} */ ...words) =>
      execFileSync(process.execPath, [cli, ...words], { cwd: top, stdio: 'pipe' });
    writeFileSync(join(top, `${name}.gz`), gzipSync(bytes));
    run('convert', `${name}.gz`, '-o', 'unpacked.ply');
    assert.deepEqual(readFileSync(join(top, 'unpacked.ply')), whole);
    execFileSync('sh', ['-c', `cat ${name} | ${process.execPath} ${cli} convert /dev/stdin -o `
      + 'piped.ply'], { cwd: top, stdio: 'pipe' });
    assert.deepEqual(readFileSync(join(top, 'piped.ply')), whole);
    const wanted = Buffer.from((await remeshFile(bytes, { ...request, ...options })).bytes);
    run(name, '-o', 'blocks.ply', ...asWords);
    assert.deepEqual(readFileSync(join(top, 'blocks.ply')), wanted);
    mkdirSync(join(top, 'in'), { recursive: true });
    writeFileSync(join(top, 'in', name), bytes);
    run(join('in', name), '-o', 'out/', '--format', 'ply', ...asWords);
    assert.deepEqual(readFileSync(join(top, 'out', 'torus.ply')), wanted);
  });

  test(`${name} in blocks is inspected, and converted to itself`, () => {
    const run = (/** @type {string[]} */ ...words) => spawnSync(process.execPath, [cli, ...words],
      { cwd: top, encoding: 'utf8' });
    const { input } = JSON.parse(run('inspect', name, '--json').stdout);
    assert.equal(input.vertices, columns * rows);
    assert.equal(input.triangles, 2 * columns * rows);
    assert.equal(run('convert', name, '-o', `same-${name}`, '--quiet').status, 0);
    const same = readFileSync(join(top, `same-${name}`));
    if (name.endsWith('.ply')) assert.deepEqual(same, bytes);
    else assert.equal(same.length, bytes.length);
  });

  test(`${name} tells how much of it is read, and can be left`, async () => {
    for (const worker of [true, false]) {
      const events = [];
      await inspect(new Blob([bytes]), { name, worker, onProgress: (event) => events.push(event) });
      assert.equal(events[0].phase, 'read');
      assert.equal(events.at(-1).phase, 'inspect');
      const fractions = events.map(({ fraction }) => fraction);
      assert.deepEqual(fractions, [...fractions].sort((a, b) => a - b));
      // How many events come in between depends on the machine's speed.
      assert.ok(fractions[0] < 0.2 && fractions.at(-1) === 1, `${fractions}`);
    }
    const controller = new AbortController();
    await assert.rejects(inspect(Readable.from(chunksOf(bytes, 2 ** 16)), { name, worker: false,
      signal: controller.signal, onProgress: () => controller.abort() }), { name: 'AbortError' });
  });

  test(`${name} is opened without being read`, async () => {
    const path = join(top, name);
    const { bytes: begin, handle } = await withInput(path, async (file) => file);
    assert.deepEqual(Buffer.from(begin), bytes.subarray(0, 65536));
    assert.equal(handle?.size, bytes.length);
  });
}

for (const [name, bytes] of Object.entries(begun)) {
  test(`${name}, of which JavaScript holds the beginning, gives the same bytes`, async () => {
    const request = { name, output: 'out.ply' };
    const whole = Buffer.from((await convertFile(bytes, request)).bytes);
    for (const [way, given] of Object.entries(waysOf(bytes))) {
      const { bytes: made } = await convertFile(given(), request);
      assert.deepEqual(Buffer.from(made), whole, way);
    }
    const wanted = Buffer.from((await remeshFile(bytes, { ...request, ...options })).bytes);
    writeFileSync(join(top, name), bytes);
    const path = join(top, name);
    const { bytes: begin, handle } = await withInput(path, async (file) => file);
    assert.deepEqual([begin.length, handle?.size], [65536, bytes.length]);
    execFileSync(process.execPath, [cli, name, '-o', 'text.ply', ...asWords],
      { cwd: top, stdio: 'pipe' });
    assert.deepEqual(readFileSync(join(top, 'text.ply')), wanted);
  });
}

test('a library that a long OBJ names far behind its beginning is read, also from a .gz', () => {
  const far = Buffer.concat([begun['torus.obj'], Buffer.from('mtllib far.mtl\nusemtl red\n'
    + 'f 1 2 3\n')]);
  writeFileSync(join(top, 'far.mtl'), 'newmtl red\nKd 1 0 0\n');
  writeFileSync(join(top, 'far.obj'), far);
  writeFileSync(join(top, 'far.obj.gz'), gzipSync(far));
  for (const input of ['far.obj', 'far.obj.gz']) {
    execFileSync(process.execPath, [cli, 'convert', input, '-o', 'far.glb', '--force'],
      { cwd: top, stdio: 'pipe' });
    const glb = readFileSync(join(top, 'far.glb'));
    const { materials } = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString());
    assert.deepEqual(materials.at(-1).pbrMetallicRoughness.baseColorFactor.slice(0, 3), [1, 0, 0],
      input);
  }
});

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

test('bytes in pieces are those that came, from any place on', () => {
  const bytes = Uint8Array.from({ length: 9_000_001 }, (_, i) => (i * 7919) >> 8);
  const pieces = new Pieces();
  for (const chunk of chunksOf(bytes, 1_234_567)) pieces.add(chunk);
  assert.deepEqual(pieces.joined(), bytes);
  const zip = new Pieces();
  zip.add(Buffer.from('PK\x03\x04'.padEnd(100_000)));
  assert.equal(zip.open().handle, undefined, 'what JavaScript unpacks');
  const { 'torus.ply': ply } = files;
  const some = new Pieces();
  some.add(ply.subarray(0, 100_000));
  some.add(ply.subarray(100_000));
  const { bytes: begin, handle } = some.open();
  assert.deepEqual(Buffer.from(begin), ply.subarray(0, 65536));
  const read = blocksOfPieces(handle);
  for (const [at, length] of [[0, 10], [99_990, 500], [ply.length - 5, 5]]) {
    const into = new Uint8Array(length);
    assert.ok(read(at, into));
    assert.deepEqual(Buffer.from(into), ply.subarray(at, at + length));
  }
  assert.ok(!read(ply.length - 5, new Uint8Array(6)));
});

test('a stream of no bytes, or that breaks, is refused in a sentence', async () => {
  const request = { name: 'torus.ply', ...options };
  await assert.rejects(remeshFile(Readable.from(['text'], { objectMode: true }), request),
    { code: 'PARSE_ERROR' });
  async function* broken() {
    yield files['torus.ply'].subarray(0, 1000);
    throw new Error('the line is dead');
  }
  await assert.rejects(remeshFile(broken(), request), { code: 'PARSE_ERROR' });
});

test('a stream that never ends is left when its run is cancelled', async () => {
  const controller = new AbortController();
  let isLeft = false;
  const endless = new ReadableStream({
    async pull(stream) {
      await new Promise((resolve) => { setImmediate(resolve); });
      stream.enqueue(new Uint8Array(100));
      controller.abort();
    },
    cancel() {
      isLeft = true;
    },
  });
  await assert.rejects(remeshFile(endless, { name: 'a.ply', signal: controller.signal }),
    { name: 'AbortError' });
  assert.ok(isLeft);
});

test('only what nothing but the core looks into is read in blocks', () => {
  const begins = (/** @type {Uint8Array} */ bytes, size = bytes.length) =>
    isReadInBlocks(Uint8Array.from(bytes.subarray(0, 65536)), size);
  const { 'torus.ply': ply, 'torus.stl': facets } = files;
  assert.ok(begins(ply) && begins(facets) && begins(begun['torus.obj']));
  assert.ok(!begins(begun['torus.off']));
  assert.ok(!begins(facets, facets.length + 1), 'no length of an STL');
  const text = Buffer.from(ply.toString('latin1').replace('binary_little_endian', 'ascii'),
    'latin1');
  assert.ok(!begins(text), 'a text');
  assert.ok(!begins(ply.subarray(0, 100)), 'no end of the header');
  const named = Buffer.from(facets);
  named.write('{"asset": 1}');
  assert.ok(!begins(named), 'what may be glTF');
});
