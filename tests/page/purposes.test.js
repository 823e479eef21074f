// SPDX-License-Identifier: MIT
// What purposes and presets ask for, and the units of their numbers.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remesh } from 'remesher';

import { ownChoices, presets, withPreset } from '../../web/model/presets.js';
import { amountOf, exactFrom, firstAmount, purposes, valuesFor } from '../../web/model/purposes.js';
import { lengthIn, roundLength, scaleOf, unitLike } from '../../web/model/units.js';
import { cornersOf } from '../../web/survey/lines.js';
import { octahedron, torus } from '../support/shapes.js';

test('a preset keeps the visitor’s own target, and not that of a purpose', () => {
  const choices = [{ vertices: 500 }, { ratio: 0.5 }, { edgeLength: 2, textures: 'keep' },
    { vertices: 70, textures: 'bake', textureSize: 64 }];
  const subject = { triangles: 996, diagonal: 3, unit: 1, exact: 0, isBaked: () => true,
    isPaintable: true };
  for (const preset of presets) {
    for (const own of choices) {
      assert.deepEqual(withPreset(preset, own), { ...own, ...preset.values });
      for (const purpose of purposes) {
        const values = valuesFor(purpose, firstAmount(purpose, subject), subject);
        assert.deepEqual(ownChoices(values, own), own, purpose);
      }
    }
  }
});

test('the number of a purpose is what it was set to, in the visitor’s unit', () => {
  const subject = { triangles: 9996, diagonal: 0.094, unit: 0.001, exact: 0,
    isBaked: () => false, isPaintable: true };
  for (const purpose of purposes) {
    for (const amount of [firstAmount(purpose, subject), 300]) {
      const values = valuesFor(purpose, amount, subject, { isRepairOnly: false });
      assert.ok(Math.abs(amountOf(values, subject) / amount - 1) < 0.01, `${purpose} ${amount}`);
    }
  }
  assert.equal(firstAmount('print', subject), 0.1);  // millimetres, of 94
  assert.equal(firstAmount('simulation', subject), 1);
  assert.equal(firstAmount('asset', subject), 5000);
  assert.equal(firstAmount('asset', { ...subject, triangles: 50_000 }), 8000);
  assert.equal(firstAmount('asset', { ...subject, triangles: 3e6 }), 20_000);
  assert.equal(firstAmount('asset', { ...subject, triangles: 12 }), 12);
  assert.deepEqual(valuesFor('print', 0.1, subject),
    { purpose: 'print', work: 'repair', repair: 'auto' });
  assert.equal(valuesFor('asset', 100, { ...subject, isBaked: () => true }).textures, 'bake');
  assert.deepEqual(valuesFor('asset', 100, { ...subject, isBaked: () => true }),
    { purpose: 'asset', faces: 100, prefer: 'shape', textures: 'bake', textureFormat: 'webp' },
    'its openings stay');
  assert.equal(valuesFor('simulation', 1, subject).repair, 'auto');
  assert.deepEqual([0.0013, 0.9, 34, 8].map(roundLength), [0.001, 1, 50, 10]);
  assert.deepEqual(scaleOf(null, 0.1), { name: 'mm', size: 0.001 });
  assert.deepEqual(scaleOf(null, 40), { name: 'm', size: 1 });
  assert.deepEqual(scaleOf('in', 40), { name: 'in', size: 1 });
});

/** The surface of unit cubes in a lattice. @param {number[][]} cubes */
function cubes(all) {
  const has = new Set(all.map(String));
  const numbers = new Map(), positions = [], indices = [];
  const vertex = (place) => {
    if (!numbers.has(String(place))) {
      numbers.set(String(place), positions.length / 3);
      positions.push(...place);
    }
    return numbers.get(String(place));
  };
  for (const cube of all) {
    for (const [axis, side] of [[0, 0], [0, 1], [1, 0], [1, 1], [2, 0], [2, 1]]) {
      if (has.has(String(cube.map((x, k) => x + (k === axis ? 2 * side - 1 : 0))))) continue;
      const corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(([u, v]) => {
        const place = [...cube];
        place[axis] += side;
        place[(axis + 1) % 3] += u;
        place[(axis + 2) % 3] += v;
        return vertex(place);
      });
      const [a, b, c, d] = side ? corners : corners.reverse();
      indices.push(a, b, c, a, c, d);
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

/** A bumpy ball of cubes. @param {number} width */
const ball = (width) => cubes(Array.from({ length: width ** 3 }, (_, i) =>
  [i % width, Math.floor(i / width) % width, Math.floor(i / width ** 2)])
  .filter((cube) => {
    const [x, y, z] = cube.map((at) => (2 * at + 1) / width - 1);
    const bumps = Math.sin(5 * x) * Math.sin(4 * y) * Math.cos(6 * z);
    return Math.hypot(x, y, z) < 0.75 + 0.15 * bumps;
  }));

test('a lighter model of flat sides keeps all its corners', async () => {
  const mesh = ball(24);
  const triangles = mesh.indices.length / 3;
  const { edges } = await inspect(mesh, { edges: true });
  const exact = exactFrom(cornersOf(mesh, edges), triangles);
  const subject = { triangles, diagonal: 20, unit: 1, exact, isBaked: () => false,
    isPaintable: false };
  const faces = firstAmount('asset', subject);
  assert.ok(exact > 0 && exact === faces && faces < 0.9 * triangles, `${faces} of ${triangles}`);
  const { report } = await remesh(mesh, { faces, prefer: 'shape' });
  assert.ok(report.output.triangles <= faces);
  assert.ok(report.fidelity.hausdorff < 1e-6, `${report.fidelity.hausdorff} %`);
  const { report: coarser } = await remesh(mesh, { faces: Math.floor(faces / 2), prefer: 'shape' });
  assert.ok(coarser.fidelity.hausdorff > 0.1);
});

test('a cube has eight corners, a round body none; few corners less make nothing lighter',
  async () => {
    const cornersIn = async (mesh) =>
      cornersOf(mesh, (await inspect(mesh, { edges: true })).edges);
    assert.equal(await cornersIn(cubes([[0, 0, 0]])), 8);
    assert.equal(await cornersIn(cubes([[0, 0, 0], [1, 0, 0]])), 8, 'on a straight edge is none');
    assert.equal(await cornersIn(torus({ columns: 24, rows: 12 })), 0);
    assert.equal(await cornersIn(octahedron()), 0, 'each triangle is a side of its own');
    const box = cubes([[0, 0, 0], [1, 0, 0]]);
    const corners = Array.from(box.indices, (v) => [...box.positions.subarray(3 * v, 3 * v + 3)]);
    const apart = { positions: Float32Array.from(corners.flat()),
      indices: box.indices.map((_, i) => i) };
    assert.equal(await cornersIn(apart), 12, 'where each triangle has its own colour it is one');
    assert.equal(exactFrom(0, 1000), 0);
    assert.equal(exactFrom(480, 1000), 1000);
    assert.equal(exactFrom(441, 1000), 890, 'as a person would type, and no fewer');
    assert.equal(exactFrom(60_000, 1e6), 0);
  });

test('a file without a unit is in millimetres where that is plain, and never in metres', () => {
  assert.deepEqual([0.02, 1.8, 9.9, 10, 100, 9000, 20_000].map(unitLike),
    ['none', 'none', 'none', 'mm', 'mm', 'mm', 'none']);
  for (const side of [0.02, 1.8, 100, 20_000]) {
    assert.doesNotMatch(lengthIn(scaleOf(unitLike(side), side), side), / m$/);
  }
  assert.equal(lengthIn(scaleOf('none', 3), 0.25), '0.25 units');
  assert.equal(lengthIn(scaleOf('mm', 100), 0.25), '0.25 mm');
});
