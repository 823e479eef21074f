// SPDX-License-Identifier: MIT
// The public functions as a program uses them.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import * as remesher from 'remesher';

import { rejectsWith } from '../support/errors.js';
import {
  distinctPositions, eulerCharacteristic, offText, sheet, torus,
} from '../support/shapes.js';

const { convertFile, init, inspect, remesh, remeshFile } = remesher;

test('the package exports what it promises and nothing else', () => {
  assert.deepEqual(Object.keys(remesher).sort(),
    ['RemeshError', 'bake', 'bakeFile', 'boolean', 'booleanFiles', 'convertFile', 'init',
      'inspect', 'remesh', 'remeshFile', 'remeshScene', 'repair', 'repairFile', 'unwrap',
      'unwrapFile']);
});

test('init may be called often, and with the bytes', async () => {
  const wasmBinary = await readFile(new URL('../../dist/remesher.wasm', import.meta.url));
  await Promise.all([init({ wasmBinary }), init()]);
  await init();
});

for (const scheme of ['best', 'rounds']) {
  test(`${scheme} gives exactly the vertices asked for, and keeps the topology`, async () => {
    const { mesh, report } = await remesh(torus(), { vertices: 900, scheme });
    assert.equal(distinctPositions(mesh.positions), 900);
    assert.equal(eulerCharacteristic(mesh), 0);
    assert.equal(report.output.vertices, 900);
    assert.equal(report.output.boundaryEdges, 0);
    assert.equal(report.stopped, 'target');
    assert.ok(report.timings.build > 0 && report.timings.remesh > 0);
  });
}

test('the phases of a run are reported in order, and make up its times', async () => {
  const { report } = await remeshFile(new TextEncoder().encode(offText(torus())),
    { name: 'a.off', output: 'a.glb', ratio: 0.5 });
  const names = report.phases.map(({ name }) => name);
  assert.deepEqual([names[0], names.at(-1)], ['read', 'write']);
  assert.ok(names.indexOf('adapt') < names.indexOf('anneal'), names.join());
  const sum = (times) => times.reduce((total, time) => total + time, 0);
  const judging = ['inspect', 'measure'];
  const working = report.phases.filter(({ name }) => !judging.includes(name));
  assert.ok(Math.abs(sum(working.map(({ milliseconds }) => milliseconds))
    - sum(Object.values(report.timings))) < 1e-6);
});

test('the caller’s arrays stay as they were', async () => {
  const mesh = torus();
  const [positions, indices] = [mesh.positions.slice(), mesh.indices.slice()];
  await remesh(mesh, { vertices: 300 });
  assert.deepEqual(mesh.positions, positions);
  assert.deepEqual(mesh.indices, indices);
});

test('a part of a larger buffer is read, and nothing beside it', async () => {
  const mesh = torus({ columns: 12, rows: 8 });
  const buffer = new Float32Array(mesh.positions.length + 20).fill(NaN);
  buffer.set(mesh.positions, 10);
  const part = buffer.subarray(10, 10 + mesh.positions.length);
  const { report } = await remesh({ ...mesh, positions: part }, { vertices: 100 });
  assert.equal(report.input.vertices, 96);
});

test('arrays come back in the types they came in', async () => {
  const { positions, indices } = sheet(8);
  const count = positions.length / 3;
  const attributes = {
    COLOR_0: { array: new Uint8Array(4 * count).fill(200), itemSize: 4 },
    JOINTS_0: { array: new Uint16Array(4 * count).fill(3), itemSize: 4 },
    _HEAT: { array: new Float64Array(count).fill(0.5), itemSize: 1 },
  };
  const given = {
    positions: Float64Array.from(positions), indices: Uint16Array.from(indices), attributes,
  };
  const { mesh } = await remesh(given, { vertices: 120 });
  assert.ok(mesh.positions instanceof Float64Array);
  assert.ok(mesh.indices instanceof Uint16Array);
  for (const [name, { array, itemSize }] of Object.entries(attributes)) {
    const result = mesh.attributes[name];
    assert.equal(result.array.constructor, array.constructor, name);
    assert.equal(result.itemSize, itemSize);
    assert.equal(result.array.length, itemSize * (mesh.positions.length / 3));
  }
  assert.ok(mesh.attributes.COLOR_0.array.every((value) => value === 200));
});

test('an attribute that is linear in space stays so', async () => {
  const { positions, indices } = sheet(16);
  const array = Float32Array.from({ length: positions.length / 3 }, (_, v) =>
    3 * positions[3 * v] - positions[3 * v + 1]);
  const { mesh } = await remesh(
    { positions, indices, attributes: { _LINEAR: { array, itemSize: 1 } } },
    { vertices: 400, scheme: 'rounds' });
  mesh.attributes._LINEAR.array.forEach((value, v) => {
    const expected = 3 * mesh.positions[3 * v] - mesh.positions[3 * v + 1];
    assert.ok(Math.abs(value - expected) < 1e-3, `${value} is ${expected}`);
  });
});

test('in the calling thread the result is the same', async () => {
  const inWorker = await remesh(torus(), { vertices: 300 });
  const here = await remesh(torus(), { vertices: 300, worker: false });
  assert.deepEqual(here.mesh, inWorker.mesh);
});

test('a file goes in and comes out as bytes, in the format asked for', async () => {
  const bytes = new TextEncoder().encode(offText(torus()));
  const same = await remeshFile(bytes, { name: 'torus.off', vertices: 500 });
  assert.equal(same.name, 'torus.off');
  assert.match(new TextDecoder().decode(same.bytes), /^OFF\s+500 /);
  const named = await remeshFile(bytes, { name: 'a/torus.off', vertices: 500, output: 'x.obj' });
  assert.equal(named.name, 'x.obj');
  const format = await remeshFile(bytes, { name: 'torus.off', vertices: 500, output: 'obj' });
  assert.equal(format.name, 'torus.obj');
  assert.equal(new TextDecoder().decode(format.bytes).match(/^v /gm).length, 500);
  assert.equal(format.files[0].bytes.length, format.bytes.length);
});

test('bytes may be a Blob, an ArrayBuffer or a Node Buffer', async () => {
  const text = offText(torus({ columns: 8, rows: 6 }));
  const bytes = new TextEncoder().encode(text);
  for (const given of [bytes.buffer, new Blob([bytes]), Buffer.from(text)]) {
    const report = await inspect(given, { name: 'torus.off' });
    assert.equal(report.input.vertices, 48);
  }
});

test('the edges of a mesh are listed by kind, for arrays only', async () => {
  const cells = 10;
  const { input, edges } = await inspect(sheet(cells), { edges: true });
  assert.equal(edges.boundary.length, 2 * input.boundaryEdges);
  assert.equal(edges.boundary.length, 2 * 4 * cells);
  assert.deepEqual([edges.nonManifold.length, edges.flipped.length], [0, 0]);
  assert.equal(edges.bends.length, edges.bent.length / 2);
  assert.equal(edges.first.length, sheet(cells).positions.length / 3);
  assert.equal((await inspect(sheet(cells))).edges, undefined);
  const bytes = new TextEncoder().encode(offText(sheet(cells)));
  await rejectsWith(inspect(bytes, { name: 'a.off', edges: true }),
    'INVALID_OPTION', /arrays/);
});

test('an inspection tells what a mesh is like', async () => {
  const { input, version } = await inspect(sheet(10));
  assert.equal(input.vertices, 11 * 11);
  assert.equal(input.triangles, 2 * 10 * 10);
  assert.equal(input.boundaryEdges, 4 * 10);
  assert.equal(input.eulerCharacteristic, 1);
  assert.equal(input.components, 1);
  const sum = input.minAngle.histogram.reduce((a, b) => a + b);
  assert.ok(Math.abs(sum - 100) < 1e-9);
  const manifest = await readFile(new URL('../../package.json', import.meta.url), 'utf8');
  assert.equal(version, JSON.parse(manifest).version);
});

test('what is not a mesh is refused before it travels', async () => {
  const { positions, indices } = torus({ columns: 8, rows: 6 });
  await rejectsWith(remesh(), 'INVALID_MESH', /positions/);
  await rejectsWith(inspect('a.off'), 'INVALID_MESH', /object/);
  await rejectsWith(remesh({ positions: [0, 0, 0], indices }), 'INVALID_MESH', /Float32Array/);
  await rejectsWith(remesh({ positions, indices: [0, 1, 2] }), 'INVALID_MESH', /Uint32Array/);
  await rejectsWith(remesh({ positions: positions.slice(1), indices }), 'INVALID_MESH', /143/);
  await rejectsWith(remesh({ positions, indices: indices.slice(1) }), 'INVALID_MESH', /287/);
  await rejectsWith(remesh({ positions, indices, group: new Uint32Array(96) }), 'INVALID_MESH',
    /mesh\.group is not known/);
  const attributes = { NORMAL: { array: new Float32Array(3), itemSize: 3 } };
  await rejectsWith(remesh({ positions, indices, attributes }), 'INVALID_MESH', /NORMAL.*144/);
});

test('what is not an option is refused before anything runs', async () => {
  const mesh = torus({ columns: 8, rows: 6 });
  const bytes = new TextEncoder().encode(offText(mesh));
  for (const options of [null, 5, 'vertices', [100]]) {
    await rejectsWith(remesh(mesh, options), 'INVALID_OPTION', /options must be an object/);
    await rejectsWith(inspect(mesh, options), 'INVALID_OPTION', /options must be an object/);
    await rejectsWith(remeshFile(bytes, options), 'INVALID_OPTION', /options must be an object/);
  }
  for (const worker of [true, false]) {
    await rejectsWith(remesh(mesh, { worker, onProgress: 5 }), 'INVALID_OPTION', /onProgress/);
    await rejectsWith(remesh(mesh, { worker, signal: {} }), 'INVALID_OPTION', /AbortSignal/);
  }
  await rejectsWith(remesh(mesh, { worker: 'no' }), 'INVALID_OPTION', /worker.*true or false/);
  const resources = null;
  await rejectsWith(inspect(bytes, { name: 'a.off', resources }), 'INVALID_OPTION', /resources/);
  const { report } = await remesh(mesh, { vertices: 60, signal: null, onProgress: null });
  assert.equal(report.output.vertices, 60);
});

test('arrays and bytes whose memory was given away are refused', async () => {
  const { positions, indices } = torus({ columns: 8, rows: 6 });
  const given = (array) => {
    const copy = array.slice();
    structuredClone(copy, { transfer: [copy.buffer ?? copy] });
    return copy;
  };
  await rejectsWith(remesh({ positions: given(positions), indices }), 'INVALID_MESH', /positions/);
  await rejectsWith(remesh({ positions, indices: given(indices) }), 'INVALID_MESH', /indices/);
  for (const bytes of [given(new Uint8Array(9)), given(new ArrayBuffer(9))]) {
    await rejectsWith(inspect(bytes, { name: 'a.off' }), 'PARSE_ERROR', /memory/);
  }
});

test('a mesh that cannot be remeshed is refused with the place', async () => {
  const { positions, indices } = torus({ columns: 8, rows: 6 });
  const wild = Uint32Array.from(indices);
  wild[4] = 1000;
  await rejectsWith(
    remesh({ positions, indices: wild }), 'INDEX_OUT_OF_RANGE', /Triangle 1 .*1000/);
  const broken = Float32Array.from(positions);
  broken[7] = NaN;
  await rejectsWith(remesh({ positions: broken, indices }), 'NON_FINITE', /Vertex 2 /);
  await rejectsWith(remesh({ positions, indices: new Uint32Array(0) }), 'NO_TRIANGLES');
  await rejectsWith(remesh({ positions, indices: new Uint32Array(9) }), 'NO_TRIANGLES');
  await rejectsWith(remesh({ positions, indices }, { vertices: 3 }), 'TARGET_TOO_SMALL', /3 vert/);
});

test('an output of no known format is refused before the work', async () => {
  const bytes = new TextEncoder().encode(offText(torus()));
  const phases = [];
  const call = (output) => remeshFile(bytes,
    { name: 'a.off', output, vertices: 900, onProgress: ({ phase }) => phases.push(phase) });
  await rejectsWith(call('a.step'), 'UNKNOWN_FORMAT', /^a\.step names no format/);
  await rejectsWith(call('doc'), 'UNKNOWN_FORMAT', /^a\.doc names no format/);
  await rejectsWith(convertFile(bytes, { name: 'a.off', output: 'a.' }), 'UNKNOWN_FORMAT', /^a\./);
  assert.deepEqual(phases, []);
});

test('a file without a name is known by its first bytes, and spoken of', async () => {
  const bytes = new TextEncoder().encode(offText(torus({ columns: 8, rows: 6 })));
  assert.equal((await inspect(bytes)).input.vertices, 48);
  const { name, report } = await remeshFile(bytes, { output: 'glb', vertices: 60 });
  assert.equal(name, 'remeshed.glb');
  assert.equal(report.output.vertices, 60);
  await rejectsWith(remeshFile(bytes), 'UNKNOWN_FORMAT', /^The output has no name/);
  await assert.rejects(remeshFile(bytes), ({ hint }) => /`name`.*`output`/.test(hint));
  await rejectsWith(inspect(bytes.slice(1)), 'UNKNOWN_FORMAT', /^The file is in no format/);
  await rejectsWith(inspect(bytes.slice(0, 9)), 'PARSE_ERROR', /^The file, line \d/);
});

test('a file that cannot be read is refused with its name', async () => {
  const bytes = (text) => new TextEncoder().encode(text);
  await rejectsWith(remeshFile(bytes(''), { name: 'a.off' }), 'EMPTY_FILE', /a\.off/);
  await rejectsWith(remeshFile(bytes('x'), { name: 'a.doc' }), 'UNKNOWN_FORMAT', /a\.doc/);
  await rejectsWith(remeshFile(bytes('OFF\n3 1 0\n'), { name: 'a.off' }), 'PARSE_ERROR', /a\.off/);
  await rejectsWith(remeshFile('a.off', { name: 'a.off' }), 'PARSE_ERROR', /Uint8Array/);
  await assert.rejects(remeshFile('a.off'), ({ hint }) => /readFile\(path\)/.test(hint));
  await rejectsWith(inspect(bytes('OFF'), { name: 'a.off', vertices: 3 }), 'UNKNOWN_OPTION');
});
