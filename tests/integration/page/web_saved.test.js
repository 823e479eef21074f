// SPDX-License-Identifier: MIT
// The mesh that is shown is the mesh that is saved: of scenes, of what was repaired, of models far
// from the origin, of whole numbers, of older results.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { reportRow, settled, visit } from '../../support/browser_page.js';
import { GltfMaker } from '../../support/gltf.js';
import { facesByPlace } from '../../support/mesh_files.js';
import { objText, torus } from '../../support/shape_files.js';
import { stl, torus as torusArrays } from '../../support/shapes.js';
import { compared, noteWork, number, open, savedInAll } from '../../support/shown_file.js';

const { page, complaints } = await visit({ hash: '#model=gear&vertices=1000', unseen: true,
  viewport: { width: 800, height: 480 }, prepare: noteWork });

/** A scene of two toruses with names and materials, the second moved. */
function sceneGlb() {
  const maker = new GltfMaker();
  const { positions, indices } = torusArrays({ columns: 24, rows: 12 });
  const meshes = ['cup', 'lid'].map((name, material) => ({ name, primitives: [{ material,
    attributes: { POSITION: maker.add(positions, 'VEC3') },
    indices: maker.addIndices(indices) }] }));
  Object.assign(maker.tree, { meshes, scene: 0, scenes: [{ nodes: [0, 1] }],
    nodes: [{ mesh: 0, name: 'cup' }, { mesh: 1, name: 'lid', translation: [8, 0, 0] }],
    materials: [{ name: 'clay', pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1] } },
      { name: 'tin' }] });
  return maker.glb().bytes;
}

test('a scene keeps its parts where a format has them; the others say what they lack', async () => {
  await open(page, { 'scene.glb': sceneGlb() }, 500);
  const { glb, obj, off, ply, stl: printed } = await compared(page);
  const named = (surface) => facesByPlace(surface, { hasMaterials: true });
  assert.deepEqual(named(obj.surface), named(glb.surface));
  assert.deepEqual([...new Set(obj.surface.materials)].sort(), ['clay', 'tin']);
  assert.deepEqual(obj.surface.objects.filter((name) => name !== 'primitive_0'), ['cup', 'lid']);
  for (const { name, news } of [off, ply, printed]) {
    assert.match(news, new RegExp(`^${name} is in your downloads\\..* 2 parts`));
  }
  assert.match(obj.news, /no colours and images of materials/);
});

test('a repaired STL is the same in every format, and named after the repair', async () => {
  const { positions, indices } = torusArrays({ columns: 24, rows: 12 });
  const bytes = stl({ positions, indices: indices.slice(0, -3) });  // with a hole
  await open(page, { 'broken scan.stl': bytes }, 300, { purpose: 'print' });
  const all = await compared(page);
  const vertices = number((await reportRow(page, 'Vertices'))[1]);
  assert.equal(all.stl.name, `broken scan-repaired-${vertices}.stl`);
});

test('far from the origin STL says that it is rounded; the others are not', async () => {
  const near = torus(24, 12);
  const shift = [431234.5, 5412345.75, 312.25];
  const positions = near.positions.map((p) => p.map((x, k) => x / 32 + shift[k]));
  await open(page, { 'far.obj': objText({ ...near, positions }) }, 200);
  const { glb, stl: rounded, ...exact } = await savedInAll(page);
  assert.match(rounded.news, /STL has too few digits so far from the origin.* steps of 0\.5\./);
  const moved = ({ surface }) => ({ ...surface, positions: surface.positions.map((p) =>
    p.map((x, k) => x - shift[k])) });
  const nearby = moved(glb).positions;
  for (const [format, file] of Object.entries(exact)) {
    assert.equal(file.news, '', format);
    assert.equal(file.surface.faces.length, glb.surface.faces.length, format);
    for (const [x, y, z] of moved(file).positions) {
      const distance = Math.min(...nearby.map((p) => Math.hypot(p[0] - x, p[1] - y, p[2] - z)));
      assert.ok(distance < 1e-6, `${format}: ${distance}`);
    }
  }
});

test('an integer PLY is saved as it is shown, not rounded', async () => {
  const { positions, triangles } = torus(24, 12);
  const rows = positions.map((p) => p.map((x) => Math.round(20 * x)).join(' '));
  await open(page, { 'grid.ply': ['ply', 'format ascii 1.0', `element vertex ${rows.length}`,
    'property short x', 'property short y', 'property short z',
    `element face ${triangles.length}`, 'property list uchar int vertex_indices', 'end_header',
    ...rows, ...triangles.map((t) => `3 ${t.join(' ')}`), ''].join('\n') }, 500);
  const { ply } = await compared(page);
  assert.ok(ply.surface.positions.some(([x]) => !Number.isInteger(x)));
});

test('an older result that is shown again is the one that is saved', async () => {
  const [, latest] = await reportRow(page, 'Vertices');
  await page.click('.history-entry >> nth=-1');
  await settled(page);
  assert.notEqual((await reportRow(page, 'Vertices'))[1], latest);
  await compared(page);
  assert.deepEqual(complaints, []);
});
