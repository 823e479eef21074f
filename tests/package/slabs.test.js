// SPDX-License-Identifier: MIT
// A scan in slabs, each the work of a run of its own: joined, they become the bytes of one run.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { convertFile, remesh, remeshFile } from 'remesher';

import { joined } from '../../examples/queue/join.js';
import { offText, stl, torus } from '../support/shapes.js';

const shape = torus({ columns: 60, rows: 30 });
const options = { vertices: 300, quality: /** @type {const} */ ('draft'), worker: false };
const asPly = async (/** @type {Uint8Array} */ bytes, /** @type {string} */ name) =>
  (await convertFile(bytes, { name, output: 'ply', worker: false })).bytes;

const off = new TextEncoder().encode(offText(shape));
const scans = { 'scan.ply': await asPly(off, 'scan.off'), 'scan.stl': stl(shape) };

for (const [name, bytes] of Object.entries(scans)) {
  test(`slabs of ${name}, joined, are remeshed to the bytes of one run`, async () => {
    const run = (/** @type {object} */ more) => remeshFile(bytes, { name, ...options, ...more });
    const pieces = [];
    for (const slab of [1, 2, 3]) {
      const piece = await run({ output: 'piece.ply', slabs: 3, slab });
      const { input, output } = piece.report;
      assert.equal(output.triangles, input.triangles);
      assert.ok(input.triangles < shape.indices.length / 6 && input.boundaryEdges > 50);
      pieces.push(piece.bytes);
    }
    const last = await remeshFile(joined(pieces),
      { name, ...options, output: 'result.glb' });
    const one = await run({ output: 'result.glb', slabs: 3 });
    assert.deepEqual(last.bytes, one.bytes);
    assert.equal(one.report.output.boundaryEdges, 0);
    assert.equal(one.report.output.vertices, 300);
  });
}

test('slabs that would not be those of one run are refused in a sentence', async () => {
  const refused = async (/** @type {object} */ more, /** @type {RegExp} */ message) =>
    assert.rejects(remeshFile(off, { name: 'scan.off', output: 'ply', worker: false, ...more }),
      { code: 'INVALID_OPTION', message });
  await refused({ slab: 3, vertices: 300 }, /slab needs slabs/);
  const slabs = 3, vertices = 300;
  for (const more of [{}, { vertices, slab: 4 }, { vertices, maxError: 1 }, { vertices, weld: 1 },
    { vertices, slab: 1, lods: [0.5], output: 'glb' }]) {
    await refused({ slabs, ...more }, /^scan\.off: Slabs need one mesh/);
  }
  await assert.rejects(remesh(shape, { ...options, slabs: 2 }), { code: 'INVALID_OPTION',
    message: /slabs are for files/ });
});
