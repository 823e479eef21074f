// SPDX-License-Identifier: MIT
// What a scene shows is what is worked on and what the report speaks of: uneven scales, instances,
// hidden things, levels of detail.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remeshFile } from 'remesher';
import { remeshObject } from 'remesher/three';
import { BatchedMesh, BufferAttribute, BufferGeometry, Group, LOD, Mesh, MeshBasicMaterial }
  from 'three';

import { scenes } from '../fuzz/made_scenes.js';
import { GltfMaker, openGltf, validate, valuesOf } from '../support/gltf.js';
import { distinctPositions, sheetOf, torus } from '../support/shapes.js';

const ring = torus({ columns: 24, rows: 12 });
const shape = {
  positions: Array.from({ length: ring.positions.length / 3 }, (_, i) =>
    [...ring.positions.subarray(3 * i, 3 * i + 3)]),
  triangles: Array.from({ length: ring.indices.length / 3 }, (_, i) =>
    [...ring.indices.subarray(3 * i, 3 * i + 3)]),
};

/** A scene of rings: one for each node, or as it says. */
function sceneOf(nodes, change = () => {}) {
  const maker = new GltfMaker();
  const meshes = nodes.map(() => ({ primitives: [{
    attributes: { POSITION: maker.add(ring.positions, 'VEC3') },
    indices: maker.addIndices(Uint16Array.from(ring.indices)),
  }] }));
  maker.show(meshes[0].primitives);
  Object.assign(maker.tree, { meshes, nodes: nodes.map((node, mesh) => ({ mesh, ...node })) });
  maker.tree.scenes[0].nodes = nodes.map((_, i) => i);
  change(maker.tree);
  return maker.glb();
}

const countsOf = ({ bytes }) => {
  const { tree } = openGltf({ bytes });
  return tree.meshes.map(({ primitives: [{ attributes }] }) =>
    tree.accessors[attributes.POSITION].count);
};
const remeshed = ({ bytes, name }, options) => remeshFile(bytes, { name, ...options });

test('triangles are even where a node scales unevenly, which the report says', async () => {
  const file = sceneOf([{ scale: [20, 1, 1] }]);
  const kept = await remeshed(file, { vertices: 600 });
  const { report, bytes } = await remeshed(file, { vertices: 600, output: 'a.stl' });
  const seen = await inspect(bytes, { name: 'a.stl' });
  for (const one of [kept.report.output, report.output]) {
    assert.ok(Math.abs(one.minAngle.mean - seen.input.minAngle.mean) < 1);
    assert.ok(one.minAngle.mean > 50, `${one.minAngle.mean}°`);
  }
  const again = await inspect(kept.bytes, { name: 'a.glb' });
  assert.ok(Math.abs(again.input.minAngle.mean - kept.report.output.minAngle.mean) < 0.01);
  const converted = await remeshed({ bytes: kept.bytes, name: 'a.glb' }, { output: 'a.obj' });
  assert.ok(converted.report.input.minAngle.mean > 50);
});

test('every instance is a body where there are no scenes, and counted', async () => {
  for (const kind of ['batch', 'uneven']) {
    const file = scenes[kind](shape);
    for (const output of ['obj', 'ply', 'stl', 'off']) {
      const { bytes, report } = await remeshed(file, { vertices: 600, output: `a.${output}` });
      const { input } = await inspect(bytes, { name: `a.${output}` });
      assert.equal(report.output.vertices, 600);
      assert.equal(input.vertices, 600);
      assert.equal(input.components, kind === 'batch' ? 3 : 2);
    }
  }
});

test('what is hidden or unused has its share', async () => {
  const counts = countsOf(await remeshed(scenes.hidden(shape), { vertices: 600 }));
  assert.deepEqual(counts, [200, 200, 200]);
  const { report } = await remeshed(scenes.hidden(shape), { vertices: 600, output: 'a.obj' });
  assert.equal(report.output.components, 1);
});

/** The second of three rings is hidden by its node, the third by the one above. */
const hiddenByNodes = () => sceneOf([{}, { scale: [2, 2, 2] }, {}], (tree) => {
  const extensions = { KHR_node_visibility: { visible: false } };
  tree.nodes[1].extensions = extensions;
  tree.nodes.push({ children: [2], extensions });
  Object.assign(tree, { scenes: [{ nodes: [0, 1, 3] }], extensionsUsed: Object.keys(extensions) });
});

test('what nodes hide has its share, and is left out where there are no nodes', async () => {
  const kept = await remeshed(hiddenByNodes(), { vertices: 600 });
  assert.deepEqual(countsOf(kept), [100, 400, 100]);
  assert.ok(!kept.report.warnings.some(({ code }) => code === 'HIDDEN_LEFT_OUT'));
  for (const output of ['obj', 'ply', 'stl', 'off']) {
    for (const file of [hiddenByNodes(), scenes.hidden(shape)]) {
      const { bytes, report } = await remeshed(file, { vertices: 200, output: `a.${output}` });
      const { input } = await inspect(bytes, { name: `a.${output}` });
      assert.deepEqual([input.vertices, input.components], [200, 1]);
      assert.ok(report.warnings.some(({ code, count }) =>
        code === 'HIDDEN_LEFT_OUT' && count === 2));
    }
  }
});

test('a scene in which nothing is shown becomes no file without scenes, but glTF', async () => {
  const nowhere = sceneOf([{ extensions: { KHR_node_visibility: { visible: false } } }]);
  const error = await remeshed(nowhere, { output: 'a.stl' }).then(assert.fail, (fault) => fault);
  assert.equal(error.code, 'NO_TRIANGLES');
  assert.match(error.hint, /Write a \.glb or \.gltf/);
  assert.deepEqual(countsOf(await remeshed(nowhere, { vertices: 200, output: 'a.glb' })), [200]);
});

const levels = () => sceneOf([{ extensions: { MSFT_lod: { ids: [1] } } }, {}], (tree) => {
  tree.scenes[0].nodes = [0];
  tree.extensionsUsed = ['MSFT_lod'];
});

test('levels keep their proportions to the finest, which the number is for', async () => {
  const result = await remeshed(levels(), { vertices: 144 });
  assert.deepEqual(countsOf(result), [144, 144]); // both had as many
  assert.equal(result.report.output.vertices, 144);
  assert.deepEqual(await validate(result), []);
  assert.deepEqual(openGltf(result).tree.nodes[0].extensions.MSFT_lod.ids, [1]);
});

test('nodes side by side that are named so are levels, too', async () => {
  const named = () => sceneOf(['ring_LOD0', 'ring_LOD1', 'ring'].map((name) => ({ name })));
  const result = await remeshed(named(), { vertices: 288 });
  assert.deepEqual(countsOf(result), [144, 144, 144]);
  assert.equal(result.report.output.vertices, 288);
  const replaced = await remeshed(named(), { vertices: 288, lods: [0.5] });
  assert.deepEqual(countsOf(replaced), [144, 144, 72, 72]);
  assert.deepEqual(await validate(replaced), []);
  assert.ok(replaced.report.warnings.some(({ code }) => code === 'LEVELS_REPLACED'));
  const { bytes } = await remeshed(named(), { vertices: 288, output: 'a.obj' });
  assert.equal(new TextDecoder().decode(bytes).match(/^o /gm)?.length, 2);
});

test('levels that are asked for replace those that were, which is said', async () => {
  for (const options of [{}, { lodFiles: true }]) {
    const result = await remeshed(levels(), { vertices: 200, lods: [0.5, 0.25], ...options });
    assert.ok(result.report.warnings.some(({ code }) => code === 'LEVELS_REPLACED'));
    assert.deepEqual(countsOf(result), options.lodFiles ? [200] : [200, 100, 50]);
    assert.deepEqual(await validate(result), []);
    const [{ extensions }] = openGltf(result).tree.nodes;
    assert.deepEqual(extensions?.MSFT_lod.ids, options.lodFiles ? undefined : [1, 2]);
  }
});

test('the levels of a LOD in three.js keep their proportions, and batches are named', async () => {
  const meshOf = ({ positions, indices }) => new Mesh(new BufferGeometry()
    .setAttribute('position', new BufferAttribute(positions.slice(), 3))
    .setIndex(new BufferAttribute(indices.slice(), 1)), new MeshBasicMaterial());
  const lod = new LOD();
  const coarse = torus({ columns: 12, rows: 6 });
  lod.addLevel(meshOf(ring), 0);
  lod.addLevel(meshOf(coarse), 10);
  const batch = new BatchedMesh(1, 300, 2000, new MeshBasicMaterial());
  const { report } = await remeshObject(new Group().add(lod, batch), { vertices: 144 });
  const counts = lod.levels.map(({ object }) =>
    distinctPositions([...object.geometry.attributes.position.array]));
  assert.deepEqual(counts, [144, 36]);
  assert.equal(report.output.vertices, 144);
  assert.ok(report.warnings.some(({ message }) => /Batched meshes are not remeshed/.test(message)));
});

const seamAt = 1;

/** Tiles of the ground, each so many cells from its x on, under nodes of their own. */
function tiles(cells) {
  const maker = new GltfMaker();
  const placed = cells.map((count, x) => sheetOf(count, (i, j) => {
    const [u, v] = [x + i / count, j / count];
    return [u - 3 * x, v, 0.2 * Math.sin(3 * u) * Math.cos(5 * v)];
  }));
  const meshes = placed.map(({ positions, indices }) => ({ primitives: [{
    attributes: { POSITION: maker.add(positions, 'VEC3') },
    indices: maker.addIndices(Uint16Array.from(indices)),
  }] }));
  maker.show(meshes[0].primitives);
  Object.assign(maker.tree, { meshes,
    nodes: meshes.map((_, mesh) => ({ mesh, translation: [3 * mesh, 0, 0] })) });
  maker.tree.scenes[0].nodes = meshes.map((_, i) => i);
  return maker.glb();
}

/** The places of a tile of a result at the seam, by their y. */
function seamOf({ bytes }, number) {
  const opened = openGltf({ bytes });
  const { primitives: [{ attributes }] } = opened.tree.meshes[number];
  const places = valuesOf(opened, attributes.POSITION).map(([x, y, z]) => [x + 3 * number, y, z]);
  return places.filter(([x]) => Math.abs(x - seamAt) < 1e-5).sort((a, b) => a[1] - b[1]);
}

test('the borders of tiles that meet stay on each other', async () => {
  for (const options of [{ vertices: 120 }, { vertices: 400 }, { ratio: 2 }, {},
    { vertices: 300, scheme: 'rounds' }, { vertices: 300, boundary: 'keep' }]) {
    const result = await remeshed(tiles([16, 16]), options);
    const { input, output } = result.report;
    assert.equal(output.vertices, options.vertices ?? input.vertices * (options.ratio ?? 1));
    assert.deepEqual(await validate(result), []);
    const [left, right] = [seamOf(result, 0), seamOf(result, 1)];
    assert.ok(left.length > 2);
    assert.equal(left.length, right.length);
    left.forEach((place, i) =>
      place.forEach((x, k) => assert.ok(Math.abs(x - right[i][k]) < 1e-6)));
  }
});
