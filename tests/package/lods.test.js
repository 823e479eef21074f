// SPDX-License-Identifier: MIT
// Levels of detail: each is what a run of its own would give, and they travel together.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { remesh, remeshFile, remeshScene } from 'remesher';
import { remeshGeometry } from 'remesher/three';
import { TorusGeometry } from 'three';

import { rejectsWith } from '../support/errors.js';
import { openGltf, validate } from '../support/gltf.js';
import { offText, torus } from '../support/shapes.js';
import { skinnedTorus } from '../support/skinned_torus.js';
import { root } from '../support/tree.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-lods-'));
after(() => rmSync(folder, { recursive: true }));

const small = torus({ columns: 24, rows: 12 });
const off = new TextEncoder().encode(offText(small));
const asked = { vertices: 400, quality: 'draft', lods: [0.5, 0.25] };
const alone = (vertices) => ({ vertices, quality: 'draft' });

test('each level is what its own run gives, with its own report', async () => {
  const { mesh, lods, report } = await remesh(small, asked);
  assert.deepEqual([mesh, ...lods].map(({ positions }) => positions.length / 3), [400, 200, 100]);
  for (const [i, lod] of lods.entries()) {
    const own = await remesh(small, alone(400 * asked.lods[i]));
    assert.deepEqual(lod, own.mesh);
    assert.deepEqual(report.lods[i].output, own.report.output);
    assert.deepEqual(report.lods[i].fidelity, own.report.fidelity);
  }
  assert.deepEqual(report.lods.map((level) => level.phases.length > 2), [true, true]);
});

test('shares are of what was asked for: a ratio, a length, or the input', async () => {
  const counts = async (options) => {
    const { report } = await remesh(small, { ...options, quality: 'draft', lods: [0.5] });
    return [report, ...report.lods].map(({ output }) => output.vertices);
  };
  assert.deepEqual(await counts({}), [288, 144]);
  assert.deepEqual(await counts({ ratio: 2 }), [576, 288]);
  const [whole, half] = await counts({ edgeLength: 0.4 });
  assert.ok(Math.abs(half - whole / 2) <= 1, `${whole} and ${half}`);
});

test('a level that asks for too few vertices has about as many as the surface needs', async () => {
  const { report } = await remesh(small, { ...alone(300), lods: [0.001] });
  // A torus has at least seven.
  const { vertices, eulerCharacteristic } = report.lods[0].output;
  assert.ok(vertices >= 7 && vertices <= 20, `${vertices} vertices`);
  assert.equal(eulerCharacteristic, 0);
});

test('a scene has its meshes at each level', async () => {
  const parts = [{ mesh: small }, { mesh: torus({ columns: 24, rows: 12, radius: 4, tube: 1.6 }) }];
  const { meshes, lods } = await remeshScene(parts, asked);
  assert.equal(meshes.length, 2);
  const own = await remeshScene(parts, alone(100));
  assert.deepEqual(lods[1], own.meshes);
});

test('without levels there are none', async () => {
  const { lods, report } = await remesh(small, alone(100));
  assert.deepEqual(lods, []);
  assert.equal('lods' in report, false);
});

/** The vertices of a mesh in the tree. */
const countOf = (tree, mesh) => new Set(tree.meshes[mesh].primitives.map(({ attributes }) =>
  tree.accessors[attributes.POSITION].count)).values().next().value;

test('one file has all levels, as MSFT_lod says, whatever it is made of', async () => {
  const result = await remeshFile(off, { ...asked, name: 'torus.off', output: 'torus.glb' });
  assert.deepEqual(await validate(result), []);
  const { tree } = openGltf(result);
  assert.deepEqual(tree.extensionsUsed, ['MSFT_lod']);
  assert.deepEqual(tree.nodes[0].extensions.MSFT_lod.ids, [1, 2]);
  assert.deepEqual(tree.nodes.map(({ mesh }) => countOf(tree, mesh)), [400, 200, 100]);
  assert.deepEqual(tree.scenes[0].nodes, [0]);
});

/** The skinned torus, its nodes moved by an animation. */
function animated() {
  const { bytes } = skinnedTorus();
  const opened = openGltf({ bytes });
  const { tree, data } = opened;
  const view = tree.bufferViews.push({ buffer: 0, byteOffset: data.length, byteLength: 32 }) - 1;
  const [times, places] = [tree.accessors.length, tree.accessors.length + 1];
  tree.accessors.push(
    { bufferView: view, componentType: 5126, count: 2, type: 'SCALAR', min: [0], max: [1] },
    { bufferView: view, byteOffset: 8, componentType: 5126, count: 2, type: 'VEC3' });
  tree.animations = [{ samplers: [{ input: times, output: places }],
    channels: [{ sampler: 0, target: { node: 3, path: 'translation' } }] }];
  const numbers = Buffer.from(Float32Array.from([0, 1, 0, 0, 3, 0, 1, 3]).buffer);
  const whole = Buffer.concat([data, numbers]);
  tree.buffers = [{ byteLength: whole.length,
    uri: `data:application/octet-stream;base64,${whole.toString('base64')}` }];
  return new TextEncoder().encode(JSON.stringify(tree));
}

test('materials and textures are there once; skins, morphs, places and animations for each level',
  async () => {
    const bytes = animated();
    const before = JSON.parse(new TextDecoder().decode(bytes));
    const result = await remeshFile(bytes,
      { name: 'torus.gltf', output: 'torus.glb', ratio: 0.5, quality: 'draft', lods: [0.6, 0.4] });
    assert.deepEqual(await validate(result), []);
    const { tree } = openGltf(result);
    for (const list of ['materials', 'textures', 'images', 'skins']) {
      assert.equal(tree[list].length, before[list].length, list);
    }
    assert.equal(tree.meshes.length, 3 * before.meshes.length);
    for (const [i, node] of tree.nodes.slice(0, before.nodes.length).entries()) {
      const levels = node.extensions?.MSFT_lod.ids ?? [];
      assert.equal(levels.length, before.nodes[i].mesh === undefined ? 0 : 2);
      for (const level of levels.map((id) => tree.nodes[id])) {
        assert.deepEqual([level.translation, level.scale, level.skin],
          [node.translation, node.scale, node.skin]);
        assert.equal(level.children, undefined);
        assert.deepEqual(tree.meshes[level.mesh].primitives.map(({ material, targets }) =>
          [material, targets?.length]), tree.meshes[node.mesh].primitives.map(
          ({ material, targets }) => [material, targets?.length]));
      }
    }
    const moved = tree.animations[0].channels.map(({ target }) => target.node);
    assert.deepEqual(moved, [3, ...tree.nodes[3].extensions.MSFT_lod.ids]);
  });

test('a file has no level that is as fine as the one before it', async () => {
  const tetrahedron = 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3';
  const { bytes, report } = await remeshFile(new TextEncoder().encode(tetrahedron),
    { name: 'a.off', output: 'a.glb', faces: 4, lods: [0.5, 0.25] });
  assert.deepEqual(report.lods.map(({ output }) => output.triangles), [4, 4]);
  const [{ message, count }] = report.warnings.filter(({ code }) => code === 'LEVEL_NOT_COARSER');
  assert.match(message, /^Levels of detail 1, 2 .* not in the file\.$/);
  assert.equal(count, 2);
  const { tree } = openGltf({ bytes });
  assert.equal(tree.meshes.length, 1);
  assert.equal(tree.nodes[0].extensions, undefined);
});

test('a file each, if that is asked for, as runs of their own write them', async () => {
  const { files } = await remeshFile(off,
    { ...asked, name: 'torus.off', output: 'torus.obj', lodFiles: true });
  assert.deepEqual(files.map(({ name }) => name),
    ['torus.obj', 'torus_lod1.obj', 'torus_lod2.obj']);
  const own = await remeshFile(off, { ...alone(100), name: 'torus.off', output: 'torus.obj' });
  assert.deepEqual(files[2].bytes, own.bytes);
});

test('the command line has them too', () => {
  writeFileSync(join(folder, 'torus.off'), off);
  const run = (...words) => JSON.parse(execFileSync(process.execPath,
    [join(root, 'dist/cli/cli.js'), 'torus.off', '--vertices', '400', '--quality', 'draft',
      '--lods', '0.5,0.25', '--json', ...words],
    { cwd: folder, timeout: 60_000, stdio: ['ignore', 'pipe', 'pipe'] }));
  const report = run('-o', 'one.glb');
  assert.deepEqual(report.lods.map(({ output }) => output.vertices), [200, 100]);
  run('-o', 'each.ply', '--lod-files');
  assert.deepEqual(readdirSync(folder).sort(),
    ['each.ply', 'each_lod1.ply', 'each_lod2.ply', 'one.glb', 'torus.off']);
  assert.match(readFileSync(join(folder, 'each_lod2.ply'), 'latin1'), /element vertex 100\n/);
});

test('levels by pixels are off by no more, with fewer vertices, and say when they take over',
  async () => {
    const fine = new TextEncoder().encode(offText(torus({ columns: 96, rows: 48 })));
    const result = await remeshFile(fine,
      { name: 'a.off', output: 'a.glb', quality: 'draft', lods: ['1px', '4px'] });
    assert.deepEqual(await validate(result), []);
    const { report } = result;
    const [first, second] = report.lods;
    const pixels = report.lods.map(({ fidelity }) => fidelity.hausdorff / 100 * 1080);
    assert.ok(pixels[0] <= 1 && pixels[1] <= 4, `${pixels} px`);
    assert.ok(pixels[0] > 0.3 && pixels[1] > 1.5, `${pixels} px`);
    assert.ok(first.output.vertices < report.output.vertices);
    assert.ok(second.output.vertices < first.output.vertices);
    assert.ok(second.takesOver.distance > first.takesOver.distance);
    // Where it takes over, its distance is a pixel: 1080 are twice the tangent of 25 degrees.
    const seen = second.fidelity.hausdorff / 100 * report.diagonal * 1080
      / (2 * second.takesOver.distance * Math.tan(25 * Math.PI / 180));
    assert.ok(Math.abs(seen - 1) < 1e-6);
    const { tree } = openGltf(result);
    assert.deepEqual(tree.nodes[0].extras.MSFT_screencoverage,
      [first.takesOver.coverage, second.takesOver.coverage, 0]);
  });

test('what cannot be is refused in a sentence', async () => {
  const file = (options) => remeshFile(off, { name: 'torus.off', vertices: 400, ...options });
  await rejectsWith(file({ lods: [0.5], output: 'obj' }), 'INVALID_OPTION',
    /torus\.obj cannot hold levels of detail/);
  for (const lods of [[], [0], [-1], ['a'], 0.5, Array(17).fill(0.5)]) {
    await rejectsWith(file({ lods, output: 'glb' }), 'INVALID_OPTION', /lods must be 1 to 16/);
  }
  await rejectsWith(file({ lodFiles: true }), 'INVALID_OPTION', /lodFiles needs lods/);
  await rejectsWith(remeshGeometry(new TorusGeometry(), { lods: [0.5] }), 'INVALID_OPTION',
    /lods does not belong here/);
});
