// SPDX-License-Identifier: MIT
// Meshes of a scene, remeshed together, and meshes in groups.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remesh, remeshScene } from 'remesher';

import { rejectsWith } from '../support/errors.js';
import { distinctPositions, eulerCharacteristic, sheet, torus } from '../support/shapes.js';

const scaled = (factor) => [factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, 1];
const countOf = ({ positions }) => distinctPositions(positions);

test('a scene shares vertices out by area in the world', async () => {
  const parts = [{ mesh: torus(), places: [scaled(2)] }, { mesh: torus(), places: [scaled(1)] }];
  const { meshes, report } = await remeshScene(parts, { vertices: 2000 });
  const counts = meshes.map(countOf);
  assert.equal(counts[0] + counts[1], 2000);
  assert.ok(Math.abs(counts[0] / counts[1] - 4) < 0.02, `${counts}`);
  assert.equal(report.output.vertices, 2000);
  for (const mesh of meshes) assert.equal(eulerCharacteristic(mesh), 0);
});

test('a mesh alone is a scene of one', async () => {
  const alone = await remesh(torus(), { vertices: 500 });
  const { meshes } = await remeshScene([{ mesh: torus() }], { vertices: 500 });
  assert.deepEqual(meshes, [alone.mesh]);
});

test('groups keep their triangles, and the border between them', async () => {
  const { positions, indices } = sheet(20);
  const middleOf = (mesh, t) => [0, 1, 2].reduce(
    (sum, k) => sum + mesh.positions[3 * mesh.indices[3 * t + k]], 0) / 3;
  const given = { positions, indices, groups: new Uint16Array(indices.length / 3) };
  given.groups.forEach((_, t) => (given.groups[t] = middleOf(given, t) < 0.5 ? 7 : 3));
  const { mesh } = await remesh(given, { vertices: 300 });
  assert.ok(mesh.groups instanceof Uint16Array);
  assert.equal(mesh.groups.length, mesh.indices.length / 3);
  mesh.groups.forEach((group, t) => assert.equal(group, middleOf(mesh, t) < 0.5 ? 7 : 3));
  for (let t = 0; t < mesh.groups.length; t += 1) {
    const sides = [0, 1, 2].map((k) => mesh.positions[3 * mesh.indices[3 * t + k]] - 0.5);
    assert.ok(Math.min(...sides) > -1e-6 || Math.max(...sides) < 1e-6, 'none lies across');
  }
});

test('scenes that cannot be are refused in a sentence', async () => {
  const mesh = torus({ columns: 8, rows: 6 });
  await rejectsWith(remeshScene(), 'INVALID_MESH', /list of \{ mesh, places \}/);
  await rejectsWith(remeshScene([]), 'INVALID_MESH', /at least one/);
  await rejectsWith(remeshScene([{ mesh }, {}]), 'INVALID_MESH', /object/);
  await rejectsWith(remeshScene([{ mesh, places: 1 }]), 'INVALID_MESH', /places must be a list/);
  for (const place of [null, [1, 2], scaled(NaN), scaled(1).reverse().with(3, 4)]) {
    await rejectsWith(remeshScene([{ mesh, places: [place] }]), 'INVALID_MESH',
      /parts\[0\]\.places\[0\].*16/);
  }
  await rejectsWith(remesh({ ...mesh, groups: [0] }), 'INVALID_MESH', /mesh\.groups.*Uint32Array/);
  await rejectsWith(remesh({ ...mesh, groups: new Uint32Array(5) }), 'INVALID_MESH',
    /groups has 5 numbers for 96 triangles/);
});
