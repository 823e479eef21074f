// SPDX-License-Identifier: MIT
// A report describes the file that is written: as one surface where the format joins parts, in the
// numbers that the file holds, with a word for each thing that it does not hold. The files are read
// without the engine.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { files } from '../fuzz/made_files.js';
import { joined, moved, shapes } from '../fuzz/made_shapes.js';
import { scenes } from '../fuzz/made_scenes.js';
import { runOf } from '../fuzz/trust_case.js';
import { figuresOf } from '../support/independent/figures.js';
import { readFile } from '../support/independent/read.js';
import { lawsOfWriting } from '../support/trust/said.js';

const encode = (/** @type {string} */ text) => new TextEncoder().encode(text);

/** The broken laws of a run, and its report. */
async function judged(file, output, options) {
  const isRepair = !('vertices' in options);
  const run = await runOf({ description: '', file, output, options, isRepair });
  const before = figuresOf(readFile(file.bytes, file));
  return { ...run, laws: lawsOfWriting(run.written, run.report, { name: run.name, before }) };
}

const runs = [{ vertices: 60 }, { vertices: 90, quads: true }, { repair: 'auto' }];

for (const output of ['obj', 'ply', 'stl', 'off']) {
  test(`two meshes that meet are one surface in .${output}`, async () => {
    for (const shape of output === 'obj' ? [shapes.box(3), shapes.sheet(3)] : [shapes.sheet(3)]) {
      for (const options of runs) {
        const { laws, report, written } = await judged(scenes.halves(shape), output, options);
        assert.deepEqual(laws, [], JSON.stringify(options));
        assert.equal(report.output.components, 1);
        if (options.vertices === 60) assert.equal(written.vertices, 60);
      }
    }
  });
}

test('the same two meshes stay two in glTF, and meet as they did', async () => {
  for (const options of runs.slice(0, 2)) {
    const { laws, report } = await judged(scenes.halves(shapes.sheet(3)), 'glb', options);
    assert.deepEqual(laws, []);
    assert.equal(report.output.components, 2);
  }
});

test('meshes that cross where the format joins them are said to', async () => {
  const balls = joined(shapes.ball(3), moved(shapes.ball(3), [1.2, 0.1, 0.2]));
  for (const output of ['obj', 'ply']) {
    const { laws, report } = await judged(scenes.halves(balls), output, { repair: 'auto' });
    assert.deepEqual(laws, [], output);
    if (output === 'obj') assert.ok(report.warnings.some(({ code }) => code === 'PARTS_MEET'));
    const remeshed = await judged(scenes.uneven(shapes.box(3)), output,
      { repair: 'auto', vertices: 98 });
    assert.deepEqual(remeshed.laws, [], output);
  }
});

/** A text PLY whose coordinates are whole numbers. @param {import('../fuzz/made_shapes.js').Shape}
 * shape */
function wholePly({ positions, triangles }) {
  const text = ['ply', 'format ascii 1.0', `element vertex ${positions.length}`,
    ...['x', 'y', 'z'].map((axis) => `property int ${axis}`), `element face ${triangles.length}`,
    'property list uchar int vertex_indices', 'end_header',
    ...positions.map((p) => p.map((x) => Math.round(10 * x)).join(' ')),
    ...triangles.map((t) => `3 ${t.join(' ')}`), ''].join('\n');
  return { name: 'made.ply', bytes: encode(text) };
}

test('coordinates of whole numbers are not rounded behind the report', async () => {
  for (const options of [{ vertices: 60 }, { vertices: 80, quads: true }]) {
    const { laws } = await judged(wholePly(shapes.ball(3)), 'ply', options);
    assert.deepEqual(laws, []);
  }
  const unchanged = wholePly(shapes.box(1));
  const { bytes } = await judged(unchanged, 'ply', { repair: 'auto' });
  assert.deepEqual(Buffer.from(bytes), Buffer.from(unchanged.bytes));
});

test('single coordinates far from the origin are judged as they are written', async () => {
  const far = moved(shapes.ball(4), [3e5, -2e5, 5e5]);
  for (const options of [{ vertices: 60 }, { repair: 'auto' }]) {
    const { laws, report } = await judged(files.off(far), 'stl', options);
    assert.deepEqual(laws, [], JSON.stringify(options));
    const { degenerateTriangles } = report.output;
    const said = ['SHAPE_LOST_TO_ROUNDING', 'DEGENERATE_TRIANGLES_MADE'];
    assert.ok(degenerateTriangles === 0
      || report.warnings.some(({ code }) => said.includes(code)), JSON.stringify(options));
  }
});

for (const kind of ['textured', 'quantized', 'instanced', 'obj', 'off with colours']) {
  test(`${kind}: what a format has no place for is named`, async () => {
    for (const output of ['obj', 'ply', 'stl', 'off', 'glb']) {
      for (const options of [{ vertices: 40 }, { repair: 'auto' }]) {
        const { laws } = await judged(files[kind](shapes.ball(2)), output, options);
        assert.deepEqual(laws, [], `${output}, ${JSON.stringify(options)}`);
      }
    }
  });
}

test('the materials of an OBJ keep their colours in glTF', async () => {
  const { bytes } = await runOf({ description: '', file: files.obj(shapes.ball(2)), output: 'glb',
    options: { vertices: 40 }, isRepair: false });
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  const { materials } = JSON.parse(Buffer.from(bytes.subarray(20, 20 + length)).toString());
  assert.deepEqual(materials.map(({ name }) => name), ['paint']);
  assert.deepEqual(materials[0].pbrMetallicRoughness.baseColorFactor, [1, 0, 0, 1]);
});
