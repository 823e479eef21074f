// SPDX-License-Identifier: MIT
// What a message advises can be followed: the number that it names is enough, the option that it
// names helps, and what it calls damaged is.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remeshFile } from 'remesher';

import { GltfMaker } from './support/gltf.js';
import { offText, sheet, torus } from './support/shapes.js';

const ball = torus({ columns: 24, rows: 12 });

/** A GLB with a torus for each size, side by side. */
function toriOf(sizes) {
  const maker = new GltfMaker();
  const meshes = sizes.map((size) => ({ primitives: [{
    attributes: { POSITION: maker.add(ball.positions.map((x) => Math.fround(size * x)), 'VEC3') },
    indices: maker.addIndices(Uint16Array.from(ball.indices)),
  }] }));
  maker.show(meshes[0].primitives);
  Object.assign(maker.tree, { meshes, nodes: meshes.map((_, mesh) => ({ mesh })) });
  maker.tree.scenes[0].nodes = meshes.map((_, i) => i);
  return maker.glb();
}

/** The error of a run, and the number that its hint names. */
async function refusal(bytes, options) {
  const error = await remeshFile(bytes, options).then(() => undefined, (reason) => reason);
  assert.ok(error, 'it was not refused');
  return { error, number: Number(/Ask for (\d+) vertices/.exec(error.hint ?? '')?.[1]) };
}

test('of a file with several meshes the number that is named is enough for all', async () => {
  for (const sizes of [[1, 1], [1, 0.01, 0.01, 5], [3, 2, 1]]) {
    const { bytes, name } = toriOf(sizes);
    const { error, number } = await refusal(bytes, { name, vertices: 12 });
    assert.equal(error.code, 'TARGET_TOO_SMALL');
    assert.match(error.message, /12 vertices is too small for all \d meshes/);
    assert.ok(!/of 0 vertices/.test(error.message));
    const { report } = await remeshFile(bytes, { name, vertices: number });
    assert.equal(report.output.vertices, number);
  }
});

test('loose triangles are joined by the tolerance that is named', async () => {
  const loose = [...ball.indices].flatMap((v, i) =>
    [0, 1, 2].map((k) => ball.positions[3 * v + k] + 1e-6 * ((i + k) % 3)));
  const text = offText({ positions: Float64Array.from(loose),
    indices: Uint32Array.from(ball.indices.keys()) });
  const bytes = new TextEncoder().encode(text);
  const { warnings } = await inspect(bytes, { name: 'loose.off' });
  const { message } = warnings.find(({ code }) => code === 'TRIANGLES_NOT_JOINED');
  const weld = Number(/--weld ([\d.e-]+)/.exec(message)[1]);
  const { report } = await remeshFile(bytes, { name: 'loose.off', vertices: 200, weld });
  assert.equal(report.output.vertices, 200);
  assert.equal(report.output.boundaryEdges, 0);
  assert.ok(!report.warnings.some(({ code }) => code === 'TRIANGLES_NOT_JOINED'));
});

test('capitals in a name are a name', async () => {
  const { positions, indices } = sheet(6);
  const maker = new GltfMaker();
  maker.show([{ attributes: { POSITION: maker.add(positions, 'VEC3'),
    COLOR_0: maker.add(positions.map((x) => Math.min(1, Math.abs(x))), 'VEC3') },
  indices: maker.addIndices(Uint16Array.from(indices)) }]);
  const { bytes } = maker.glb();
  const options = { vertices: 30, textures: 'bake', textureSize: 64, textureFormat: 'png' };
  const result = await remeshFile(bytes, { ...options, name: 'A.GLB', output: 'X.GLB' });
  assert.equal(result.report.output.vertices, 30);
  const { code, message } = await remeshFile(Uint8Array.of(1, 2, 3, 4), { name: 'B.GLB' })
    .then(assert.fail, (error) => error);
  assert.equal(code, 'PARSE_ERROR');
  assert.match(message, /does not begin as a binary glTF/);
});

test('what an unknown extension makes of a file is not called damaged', async () => {
  const maker = new GltfMaker();
  maker.show([{ attributes: { POSITION: maker.add(ball.positions, 'VEC3') },
    indices: maker.addIndices(Uint16Array.from(ball.indices, (v) => v + 1000)) }]);
  const { bytes: damaged } = maker.glb();
  const { error } = await refusal(damaged, { name: 'a.glb' });
  assert.equal(error.code, 'INDEX_OUT_OF_RANGE');
  maker.tree.extensionsUsed = ['ACME_other_numbers'];
  maker.tree.extensionsRequired = ['ACME_other_numbers'];
  const { error: unknown } = await refusal(maker.glb().bytes, { name: 'a.glb' });
  assert.equal(unknown.code, 'UNSUPPORTED');
  assert.match(unknown.message, /requires ACME_other_numbers, which is not known here/);
});
