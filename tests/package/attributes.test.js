// SPDX-License-Identifier: MIT
// What hangs on the vertices: texture coordinates stay where they were on the surface, and a
// skinned and morphed body bends as it did.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remesh, remeshFile } from 'remesher';
import { Matrix4, Vector3 } from 'three';

import { GltfMaker, openGltf, validate, valuesOf } from '../support/gltf.js';
import { NearestPoints, vertexOf } from '../support/nearest.js';
import { torus } from '../support/shapes.js';

const [columns, rows, radius, length] = [32, 36, 0.3, 2];
const diagonal = Math.hypot(2 * radius, 2 * radius, length);

/** An upright tube, open at both ends, with a texture wrapped around it once: cut along a seam. */
function tube() {
  const mesh = { positions: [], texcoords: [], indices: [] };
  for (let j = 0; j <= rows; j += 1) {
    for (let i = 0; i <= columns; i += 1) {
      const turn = (2 * Math.PI * (i % columns)) / columns;
      mesh.positions.push(radius * Math.cos(turn), (length * j) / rows, radius * Math.sin(turn));
      mesh.texcoords.push(i / columns, j / rows);
      if (i === columns || j === rows) continue;
      const at = (a, b) => (j + b) * (columns + 1) + i + a;
      mesh.indices.push(at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0));
    }
  }
  return mesh;
}

const { positions, texcoords, indices } = tube();
const heights = positions.filter((_, i) => i % 3 === 1);

const mixed = (values, size, { corners, weights }) => Array.from({ length: size }, (_, c) =>
  weights.reduce((sum, w, k) => sum + w * values[size * corners[k] + c], 0));

const off = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Where on the tube's flat sides given texture coordinates are. */
function placeOf([u, v]) {
  const side = Math.min(Math.floor(u * columns), columns - 1);
  const share = u * columns - side;
  const [from, to] = [side, side + 1].map((i) => positions.slice(3 * i, 3 * i + 3));
  return new Vector3(...from.map((x, c) => x + share * (to[c] - x))).setY(v * length);
}

test('texture coordinates are those of the nearest point of the same chart', async () => {
  const { mesh } = await remesh({
    positions: new Float64Array(positions),
    indices: new Uint32Array(indices),
    attributes: { TEXCOORD_0: { array: new Float32Array(texcoords), itemSize: 2 } },
  }, { vertices: 900 });
  const original = new NearestPoints({ positions, indices });
  const carried = mesh.attributes.TEXCOORD_0.array;
  const error = (point, uv) => Math.min(...original.find(point, 1e-9 * diagonal).places
    .map((place) => off(mixed(texcoords, 2, place), uv)));
  for (let v = 0; v < carried.length / 2; v += 1) {
    const uv = [carried[2 * v], carried[2 * v + 1]];
    const vertex = vertexOf(mesh.positions, v);
    // Off the tube a vertex carries what is beneath it, hardly further away than the nearest.
    const { distance } = original.find(vertex);
    assert.ok(placeOf(uv).distanceTo(vertex) < 1.01 * distance + 5e-5 * diagonal,
      `vertex ${v} carries ${uv}`);
  }
  const inside = [];
  for (let t = 0; t < mesh.indices.length; t += 3) {
    const place = { corners: mesh.indices.slice(t, t + 3), weights: [1 / 3, 1 / 3, 1 / 3] };
    inside.push(error(new Vector3(...mixed(mesh.positions, 3, place)), mixed(carried, 2, place)));
  }
  const mean = inside.reduce((a, b) => a + b) / inside.length;
  assert.ok(mean < 0.5 / 1024, `inside triangles it is off by ${1024 * mean} texels on average`);
  assert.ok(inside.every((one) => one < 0.1), 'no triangle reaches across the seam');
});

/** The tube with two joints, an animation that bends it, and two morph targets. */
function body() {
  const maker = new GltfMaker();
  const floats = (values) => Float32Array.from(values);
  const row = (values, count, type) => maker.describe(
    { bufferView: maker.addView(floats(values)), componentType: 5126, count, type });
  const bend = heights.map((y) => 0.5 - 0.5 * Math.cos((Math.PI * y) / length));
  const bulge = positions.map((p, i) => (i % 3 === 1 ? 0
    : 0.5 * p * Math.sin((Math.PI * positions[i - (i % 3) + 1]) / length) ** 2));
  const lean = positions.map((_, i) => (i % 3 === 0 ? 0.2 * (positions[i + 1] / length) ** 2 : 0));
  const primitive = {
    attributes: {
      POSITION: maker.add(floats(positions), 'VEC3'),
      JOINTS_0: maker.add(Uint8Array.from(heights.flatMap(() => [0, 1, 0, 0])), 'VEC4'),
      WEIGHTS_0: maker.add(floats(bend.flatMap((w) => [1 - w, w, 0, 0])), 'VEC4'),
    },
    targets: [bulge, lean].map((values) => ({ POSITION: maker.add(floats(values), 'VEC3') })),
    indices: maker.addIndices(Uint16Array.from(indices)),
  };
  maker.show([primitive]);
  const turned = Math.SQRT1_2;
  const identity = new Matrix4().toArray();
  const up = new Matrix4().makeTranslation(0, -length / 2, 0).toArray();
  maker.tree.nodes = [{ mesh: 0, skin: 0 }, { children: [2] },
    { translation: [0, length / 2, 0] }];
  maker.tree.scenes = [{ nodes: [0, 1] }];
  maker.tree.skins = [{
    joints: [1, 2],
    inverseBindMatrices: row([...identity, ...up], 2, 'MAT4'),
  }];
  const time = row([0, 1], 2, 'SCALAR');
  Object.assign(maker.tree.accessors[time], { min: [0], max: [1] });
  maker.tree.animations = [{
    samplers: [{ input: time, output: row([0, 0, 0, 1, 0, 0, turned, turned], 2, 'VEC4') }],
    channels: [{ sampler: 0, target: { node: 2, path: 'rotation' } }],
  }];
  return maker;
}

/** The positions at a time between 0 and 1, both morph targets at work. */
function posed(file, time) {
  const [primitive] = file.tree.meshes[0].primitives;
  const read = (accessor) => valuesOf(file, accessor);
  const base = read(primitive.attributes.POSITION);
  const targets = primitive.targets.map(({ POSITION }) => read(POSITION));
  const joints = read(primitive.attributes.JOINTS_0);
  const weights = read(primitive.attributes.WEIGHTS_0);
  const bent = new Matrix4().makeTranslation(0, length / 2, 0)
    .multiply(new Matrix4().makeRotationZ((Math.PI / 2) * time))
    .multiply(new Matrix4().makeTranslation(0, -length / 2, 0));
  const matrices = [new Matrix4(), bent];
  const result = base.flatMap((p, v) => {
    const morphed = new Vector3(...p)
      .addScaledVector(new Vector3(...targets[0][v]), time)
      .addScaledVector(new Vector3(...targets[1][v]), 1 - time);
    const sum = new Vector3();
    weights[v].forEach((w, k) => w > 0 && sum.addScaledVector(
      morphed.clone().applyMatrix4(matrices[joints[v][k]]), w));
    return sum.toArray();
  });
  return { positions: result, indices: read(primitive.indices).flat() };
}

test('a skinned and morphed body bends the same', async () => {
  const made = body().glb();
  const result = await remeshFile(made.bytes, { name: made.name, vertices: 1000 });
  assert.deepEqual(await validate(result), []);
  const [before, after] = [openGltf(made), openGltf(result)];
  for (const part of ['nodes', 'scenes']) assert.deepEqual(after.tree[part], before.tree[part]);
  assert.equal(after.tree.animations[0].channels[0].target.node, 2);

  const [primitive] = after.tree.meshes[0].primitives;
  for (const weights of valuesOf(after, primitive.attributes.WEIGHTS_0)) {
    assert.ok(Math.abs(weights.reduce((a, b) => a + b) - 1) < 1e-6, `weights ${weights}`);
  }
  for (let k = 0; k < 10; k += 1) {
    const [was, is] = [posed(before, k / 9), posed(after, k / 9)];
    const [toOriginal, toResult] = [new NearestPoints(was), new NearestPoints(is)];
    for (let v = 0; v < is.positions.length / 3; v += 1) {
      const distance = toOriginal.distance(vertexOf(is.positions, v));
      assert.ok(distance < 0.003 * diagonal, `vertex ${v} is ${distance} off at ${k / 9}`);
    }
    for (let v = 0; v < was.positions.length / 3; v += 1) {
      const distance = toResult.distance(vertexOf(was.positions, v));
      assert.ok(distance < 0.003 * diagonal, `place ${v} is ${distance} away at ${k / 9}`);
    }
  }
});

for (const quality of ['draft', 'best']) {
  test(`far fewer vertices have what hangs on their places (${quality})`, async () => {
    const shape = torus({ columns: 64, rows: 32 });
    const groups = Uint32Array.from({ length: shape.indices.length / 3 },
      (_, i) => Number(i >= shape.indices.length / 6));
    const attributes = { _PLACE: { array: shape.positions, itemSize: 3 } };
    const { mesh } = await remesh({ ...shape, groups, attributes }, { vertices: 150, quality });
    const places = mesh.attributes._PLACE.array;
    const away = Array.from(mesh.positions, (x, i) => Math.abs(x - places[i]));
    // Corners stand a little off a curved surface, by which the triangles follow it.
    assert.ok(Math.max(...away) < 0.15, `${Math.max(...away)}`);
  });
}
