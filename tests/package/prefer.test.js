// SPDX-License-Identifier: MIT
// The option `prefer`: isotropic triangles, or vertices of the original where its shape and looks
// need them most; exactly as many as asked for either way, and the report says which.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remesh, remeshScene } from 'remesher';

import { rejectsWith } from '../support/errors.js';
import { engraved, gear, plate, sheetMetal } from '../support/machine_parts.js';
import { torus } from '../support/shapes.js';

const ring = torus({ columns: 48, rows: 24 });
const drawn = { ...ring, attributes: { TEXCOORD_0: { itemSize: 2,
  array: Float32Array.from({ length: 2 * ring.positions.length / 3 },
    (_, i) => ring.positions[3 * (i >> 1) + (i & 1)]) } } };

/** A sheet whose pleats are narrower than an even triangle of the result. */
function pleats() {
  const positions = [];
  const indices = [];
  const [columns, rows] = [40, 32];
  for (let i = 0; i <= columns; i += 1) {
    for (let j = 0; j <= rows; j += 1) positions.push(i / 2, j / 8, i % 2 ? 0.3 : 0);
  }
  const at = (i, j) => i * (rows + 1) + j;
  for (let i = 0; i < columns; i += 1) {
    for (let j = 0; j < rows; j += 1) {
      indices.push(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1),
        at(i, j + 1));
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

test('shape: as many vertices as asked for, nearer than isotropic triangles', async () => {
  const options = { vertices: 200, worker: false };
  const even = await remesh(ring, { ...options, prefer: 'even' });
  const shape = await remesh(ring, { ...options, prefer: 'shape' });
  assert.deepEqual([even.report.prefer, shape.report.prefer], ['even', 'shape']);
  const { input } = await inspect(shape.mesh, { worker: false });
  assert.deepEqual([input.vertices, input.eulerCharacteristic, input.boundaryEdges], [200, 0, 0]);
  assert.ok(shape.report.fidelity.rms < even.report.fidelity.rms);
  assert.ok(shape.report.output.minAngle.mean < even.report.output.minAngle.mean);
});

test('the report says by which rule the mesh was taken, and why', async () => {
  const taken = async (mesh, options) =>
    (await remesh(mesh, { vertices: 200, worker: false, ...options })).report.chosen;
  assert.deepEqual(await taken(ring, { prefer: 'shape' }),
    { rule: 'shape-asked', reason: 'The shape was preferred.' });
  assert.equal((await taken(ring, { prefer: 'even' })).rule, 'isotropic-asked');
  assert.equal((await taken(ring, { scheme: 'rounds' })).rule, 'rounds');
  assert.equal((await taken(ring, { boundary: 'keep' })).rule, 'vertices-placed');
  assert.match((await taken(ring, { quads: true })).rule, /^quads-mirrored$/);
  const { rule } = await taken(pleats(), { featureAngle: 'off' });
  assert.match(rule, /^(isotropic-far|simplified|facets-conforming)/);
});

test('shape: vertices with attributes are those of the original', async () => {
  const { mesh, report } = await remesh(drawn, { vertices: 300, prefer: 'shape', worker: false });
  assert.equal(report.prefer, 'shape');
  const key = (positions, uv, i) =>
    [...positions.slice(3 * i, 3 * i + 3), ...uv.slice(2 * i, 2 * i + 2)].join();
  const known = new Set(Array.from({ length: drawn.positions.length / 3 },
    (_, i) => key(drawn.positions, drawn.attributes.TEXCOORD_0.array, i)));
  const { positions, attributes } = mesh;
  for (let i = 0; i < positions.length / 3; i += 1) {
    assert.ok(known.has(key(positions, attributes.TEXCOORD_0.array, i)), `vertex ${i}`);
  }
});

test('auto: shape where isotropic triangles lose it, even where they do not', async () => {
  const options = { vertices: 150, featureAngle: 'off', worker: false };
  const free = await remesh(pleats(), options);
  const forced = await remesh(pleats(), { ...options, prefer: 'even' });
  assert.deepEqual([free.report.prefer, forced.report.prefer], ['shape', 'even']);
  assert.ok(free.report.fidelity.rms < forced.report.fidelity.rms / 2);
  assert.equal(free.report.output.vertices, 150);
  assert.equal((await remesh(ring, { ratio: 1, worker: false })).report.prefer, 'even');
});

test('auto: a part with flat sides keeps its shape at its own number of vertices', async () => {
  for (const make of [plate, gear, engraved]) {
    const { report } = await remesh(make(), { ratio: 1, worker: false });
    assert.equal(report.prefer, 'shape', make.name);
    assert.ok(report.fidelity.hausdorff <= 0.05, `${make.name}: ${report.fidelity.hausdorff} %`);
    assert.equal(report.output.vertices, report.input.vertices, make.name);
  }
});

test('auto: sheet metal keeps both its bends with more vertices than it has', async () => {
  for (const ratio of [1.5, 3]) {
    const { report } = await remesh(sheetMetal(), { ratio, worker: false });
    assert.equal(report.prefer, 'shape');
    assert.ok(report.fidelity.hausdorff <= 0.05, `${report.fidelity.hausdorff} %`);
    assert.equal(report.output.vertices, Math.round(ratio * report.input.vertices));
  }
});

test('shape: more vertices than the original has stay where it is', async () => {
  for (const mesh of [plate(), ring, drawn]) {
    const { report } = await remesh(mesh, { ratio: 1.5, prefer: 'shape', worker: false });
    assert.equal(report.prefer, 'shape');
    assert.equal(report.output.vertices, Math.round(1.5 * report.input.vertices));
    assert.ok(report.fidelity.hausdorff <= 0.05, `${report.fidelity.hausdorff} %`);
  }
});

test('the report says it for each part where parts differ', async () => {
  const { report } = await remeshScene([{ mesh: ring }, { mesh: pleats() }],
    { ratio: 0.12, featureAngle: 'off', worker: false });
  assert.deepEqual(report.prefer, ['even', 'shape']);
  const areIsotropic = report.chosen.map(({ rule }) => rule.startsWith('isotropic'));
  assert.deepEqual(areIsotropic, [true, false]);
});

test('what decides where vertices lie excludes a shape that is preferred', async () => {
  const others = { scheme: 'rounds', boundary: 'keep', splitObtuse: true, quads: true,
    density: new Float32Array(ring.positions.length / 3).fill(1), featureEdges: [[0, 1]] };
  for (const [name, value] of Object.entries(others)) {
    await rejectsWith(remesh(ring, { vertices: 200, prefer: 'shape', [name]: value }),
      'INVALID_OPTION', new RegExp(name));
  }
});

test('a shape that is preferred is simplified as far as a bound allows', async () => {
  const run = async (options) => (await remesh(pleats(), { prefer: 'shape', maxError: 0.5,
    worker: false, ...options })).report;
  const fewest = await run({});
  assert.ok(fewest.fidelity.hausdorff <= 0.5, `${fewest.fidelity.hausdorff} %`);
  assert.deepEqual(fewest.prefer, 'shape');
  const { output: { vertices }, input } = fewest;
  assert.ok(vertices < 0.9 * input.vertices, `${vertices} of ${input.vertices}`);
  assert.equal((await run({ vertices: Math.ceil(1.2 * vertices) })).output.vertices,
    Math.ceil(1.2 * vertices));
  const raised = await run({ vertices: vertices >> 1 });
  assert.ok(raised.fidelity.hausdorff <= 0.5 && raised.output.vertices > vertices >> 1);
  const without = await remesh(pleats(), { prefer: 'shape', vertices: Math.floor(vertices / 1.3),
    worker: false });
  assert.ok(without.report.fidelity.hausdorff > 0.5, 'about the fewest');
});

test('no number: a part gets the vertices of isotropic triangles, which is said', async () => {
  const { report } = await remesh(plate(), { worker: false });
  const { input, output, fidelity, warnings } = report;
  assert.ok(output.vertices > input.vertices && output.vertices <= 4 * input.vertices);
  assert.ok(output.minAngle.mean >= 40 && fidelity.hausdorff <= 0.05);
  const { message } = warnings.find(({ code }) => code === 'MORE_VERTICES_TAKEN');
  assert.match(message,
    new RegExp(`a mesh of ${input.vertices} vertices now has ${output.vertices},`));
  const { report: plain } = await remesh(ring, { worker: false });
  assert.equal(plain.output.vertices, plain.input.vertices);
  assert.deepEqual(plain.warnings, []);
});

test('a sound mesh is remeshed as if repair had not been asked for', async () => {
  for (const mesh of [plate(), ring]) {
    for (const asked of [{}, { vertices: Math.round(mesh.positions.length / 2) }]) {
      const [plain, repaired] = await Promise.all([{}, { repair: 'auto' }].map((more) =>
        remesh(mesh, { ...asked, ...more, worker: false })));
      assert.deepEqual(repaired.mesh.indices, plain.mesh.indices);
      assert.deepEqual(repaired.mesh.positions, plain.mesh.positions);
    }
  }
});

test('a mesh for simulation keeps its angles, and its shape or says how far it is', async () => {
  for (const part of [plate(), gear()]) {
    const { report } = await remesh(part, { preset: 'simulation', worker: false });
    const isSaid = report.warnings.some(({ code }) => code === 'SHAPE_TAKES_MORE');
    assert.ok(report.output.minAngle.worst >= 20, `${report.output.minAngle.worst}`);
    assert.ok(report.fidelity.hausdorff <= (isSaid ? 0.1 : 0.05), `${report.fidelity.hausdorff}`);
  }
});
