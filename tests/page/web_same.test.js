// SPDX-License-Identifier: MIT
// The mesh that is shown is the mesh that is saved: every format is opened by readers of the tests'
// own, and compared with the figures of the report and with the numbers in the graphics card.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { unzipSync } from 'fflate';

import { nameFor } from '../../web/model/names.js';
import { drop, opened, reportRow, saved, settled, visit } from '../support/browser_page.js';
import { GltfMaker } from '../support/gltf.js';
import {
  facesByPlace, placesOf, readSurface, rowsOf, triangulated,
} from '../support/mesh_files.js';
import { objText, torus } from '../support/shape_files.js';
import { stl, torus as torusArrays } from '../support/shapes.js';

/** Runs in a page: notes the jobs that workers get, and the numbers that the graphics card gets. */
function noteWork() {
  Object.assign(globalThis, { jobs: [], uploads: [] });
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function postAndNote(message, ...others) {
    if (message.job) globalThis.jobs.push(message.job.kind);
    return postMessage.call(this, message, ...others);
  };
  const { prototype } = WebGL2RenderingContext;
  const { bufferData } = prototype;
  prototype.bufferData = function bufferAndNote(target, data, ...others) {
    if (data instanceof Float32Array) globalThis.uploads.push(Array.from(data));
    return bufferData.call(this, target, data, ...others);
  };
}

const { page, complaints } = await visit({ hash: '#model=gear&vertices=1000', unseen: true,
  viewport: { width: 800, height: 480 }, prepare: noteWork });

const labels = { glb: 'GLB', gltf: 'glTF (ZIP)', obj: 'OBJ', off: 'OFF', ply: 'PLY',
  stl: 'STL' };

/** Saves the shown result in every format. */
async function savedInAll() {
  const all = {};
  for (const [format, label] of Object.entries(labels)) {
    const { name, bytes } = await saved(page, `.takeaway button:text-is("${label}")`);
    await settled(page);
    const files = name.endsWith('.zip') ? unzipSync(bytes) : { [name]: bytes };
    const news = await page.isVisible('#news') ? await page.textContent('#news') : '';
    all[format] = { name, files, surface: readSurface(files), news };
  }
  return all;
}

/** The distinct positions that the graphics card got, of those in a list. */
async function shownAmong(places) {
  const wanted = new Set(places);
  const shown = new Set();
  for (const upload of await page.evaluate(() => globalThis.uploads)) {
    if (upload.length % 3) continue;
    const own = placesOf(rowsOf(upload));
    if (own.every((place) => wanted.has(place))) own.forEach((place) => shown.add(place));
  }
  return [...shown].sort();
}

const number = (text) => Number(text.replaceAll(',', ''));

/** Saves in all formats and compares them with each other, the report and the graphics card.
 * @returns what was saved */
async function compared({ hasQuads = false } = {}) {
  const before = await page.evaluate(() => globalThis.jobs.length);
  const all = await savedInAll();
  const jobs = await page.evaluate((count) => globalThis.jobs.slice(count), before);
  assert.deepEqual([...new Set(jobs)], ['convertFile'], 'nothing is remeshed again');
  const [, vertices] = await reportRow(page, 'Vertices');
  const [, faces] = await reportRow(page, hasQuads ? 'Quads' : 'Triangles');
  const { surface } = all.glb;
  const places = placesOf(surface.positions);
  assert.equal(places.length, number(vertices));
  assert.equal(surface.faces.length, number(faces));
  const stored = placesOf(surface.stored);
  assert.deepEqual(await shownAmong(stored), stored, 'the graphics card has them');
  for (const [format, { surface: other }] of Object.entries(all)) {
    const wanted = format === 'stl' ? triangulated(surface) : surface;
    assert.deepEqual(placesOf(other.positions), places, format);
    assert.deepEqual(facesByPlace(other), facesByPlace(wanted), format);
    if (hasQuads && format !== 'stl') {
      assert.ok(other.faces.every((face) => face.length === 4), `${format} has quads`);
    }
  }
  return all;
}

/** Opens a file, asks for so many vertices, and waits for the best result. */
async function open(files, vertices, { purpose = null } = {}) {
  const [name] = Object.keys(files);
  await drop(page, files);
  await opened(page, name);
  if (purpose) await page.click(`#purpose-${purpose}`);
  await page.selectOption('.target select', 'vertices');
  await page.fill('#target', String(vertices));
  await page.click('form button[type=submit]');
  await page.waitForFunction(() => document.body.dataset.state === 'idle'
    && document.querySelector('.takeaway'));
  await page.waitForTimeout(600);  // longer than a slider has to rest
  await settled(page);
}

test('triangles of an OBJ are the same in every format', async () => {
  const all = await compared();
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
  await open({ 'named.obj': namedObj(), 'ring.mtl': 'newmtl red\nKd 1 0 0\nnewmtl blue\n' }, 400,
    { purpose: 'quads' });
  const { glb, gltf, obj, off, ply, stl: printed } = await compared({ hasQuads: true });
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
});

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
  await open({ 'scene.glb': sceneGlb() }, 500);
  const { glb, obj, off, ply, stl: printed } = await compared();
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
  await open({ 'broken scan.stl': bytes }, 300, { purpose: 'print' });
  const all = await compared();
  const vertices = number((await reportRow(page, 'Vertices'))[1]);
  assert.equal(all.stl.name, `broken scan-repaired-${vertices}.stl`);
});

test('far from the origin STL says that it is rounded; the others are not', async () => {
  const near = torus(24, 12);
  const shift = [431234.5, 5412345.75, 312.25];
  const positions = near.positions.map((p) => p.map((x, k) => x / 32 + shift[k]));
  await open({ 'far.obj': objText({ ...near, positions }) }, 200);
  const { glb, stl: rounded, ...exact } = await savedInAll();
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
  await open({ 'grid.ply': ['ply', 'format ascii 1.0', `element vertex ${rows.length}`,
    'property short x', 'property short y', 'property short z',
    `element face ${triangles.length}`, 'property list uchar int vertex_indices', 'end_header',
    ...rows, ...triangles.map((t) => `3 ${t.join(' ')}`), ''].join('\n') }, 500);
  const { ply } = await compared();
  assert.ok(ply.surface.positions.some(([x]) => !Number.isInteger(x)));
});

test('an older result that is shown again is the one that is saved', async () => {
  await page.click('.history-entry >> nth=-1');
  await settled(page);
  assert.equal(number((await reportRow(page, 'Vertices'))[1]), 288);
  await compared();
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
