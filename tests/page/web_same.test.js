// SPDX-License-Identifier: MIT
// The mesh that is shown is the mesh that is saved: triangles and quads of an OBJ, in every format;
// tests/integration/page/web_saved.test.js has the other formats that are opened.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { nameFor } from '../../web/model/names.js';
import { visit } from '../support/browser_page.js';
import { facesByPlace } from '../support/mesh_files.js';
import { objText, torus } from '../support/shape_files.js';
import { compared, noteWork, open } from '../support/shown_file.js';

const { page, complaints } = await visit({ hash: '#model=gear&vertices=1000', unseen: true,
  viewport: { width: 800, height: 480 }, prepare: noteWork });

test('triangles of an OBJ are the same in every format', async () => {
  const all = await compared(page);
  assert.deepEqual(Object.values(all).map(({ name }) => name), ['gear-1000.glb', 'gear-1000.zip',
    'gear-1000.obj', 'gear-1000.off', 'gear-1000.ply', 'gear-1000.stl']);
  assert.deepEqual(Object.values(all).map(({ news }) => news), ['', '', '', '', '', '']);
});

/** A torus of two groups of an object, with a material each. */
function namedObj() {
  const lines = objText(torus(24, 12)).trim().split('\n');
  const points = lines.filter((line) => line.startsWith('v '));
  const faces = lines.filter((line) => line.startsWith('f '));
  const half = faces.length / 2;
  return ['mtllib ring.mtl', ...points, 'o ring', 'g near', 'usemtl red', ...faces.slice(0, half),
    'g far', 'usemtl blue', ...faces.slice(half), ''].join('\n');
}

test('quads of an OBJ are faces of four, with its names and materials', async () => {
  const files = { 'named.obj': namedObj(), 'ring.mtl': 'newmtl red\nKd 1 0 0\nnewmtl blue\n' };
  await open(page, files, 400, { purpose: 'quads' });
  const { glb, gltf, obj, off, ply, stl: printed } = await compared(page, { hasQuads: true });
  const named = (surface) => facesByPlace(surface, { hasMaterials: true });
  assert.deepEqual(named(obj.surface), named(glb.surface), 'the materials are where they are');
  assert.deepEqual(named(gltf.surface), named(glb.surface));
  assert.deepEqual([...new Set(obj.surface.materials)].sort(), ['blue', 'red']);
  assert.deepEqual(obj.surface.objects, ['ring', 'near', 'far']);
  assert.deepEqual(Object.keys(obj.files).sort(),
    [obj.name.replace('.zip', '.obj'), 'ring.mtl'].sort());
  assert.match(obj.name, /^named-quads-\d+\.zip$/);
  assert.match(printed.news, /STL holds triangles only.*2 parts and materials/);
  assert.match(ply.news, /PLY holds one surface: 2 parts and materials/);
  assert.match(off.news, /OFF holds one surface/);
  assert.doesNotMatch(`${ply.news}${off.news}`, /triangles only/);
  assert.equal(obj.news, '');
  assert.deepEqual(complaints, []);
});

test('names tell what was done, and are fit for every file system', () => {
  const nothing = { holes: 0, islands: 0, shells: 0, turned: 0 };
  const report = (parts) => ({ output: { vertices: 5000 }, fidelity: {}, ...parts });
  assert.equal(nameFor('horse.obj', report({}), 'glb'), 'horse-5000.glb');
  assert.equal(nameFor('a.b.stl', report({}), 'stl'), 'a.b-5000.stl');
  assert.equal(nameFor('cad.stl', report({ repair: { mode: 'solid', ...nothing } }), 'stl'),
    'cad-repaired-5000.stl');
  assert.equal(nameFor('cad.stl', report({ repair: { mode: 'holes', ...nothing } }), 'stl'),
    'cad-5000.stl', 'nothing was repaired');
  assert.equal(nameFor('x.glb', report({ output: { vertices: 9, quads: {} } }), 'png', 'normals'),
    'x-quads-9-normals.png');
  const only = (parts) => ({ output: { vertices: 12 }, repair: { mode: 'solid', ...nothing,
    ...parts } });
  assert.equal(nameFor('cadsoup.stl', only({ reason: 'united' }), 'stl'), 'cadsoup-repaired.stl');
  assert.equal(nameFor('box.stl', only({ reason: 'sound' }), 'stl'), 'box-unchanged.stl');
  assert.equal(nameFor('a/b\\c:d\n.obj', report({}), 'obj'), 'a_b_c_d_-5000.obj');
});
