// SPDX-License-Identifier: MIT
// What the page shows beside the surfaces: distances, creases, borders and faults, the triangle
// under the pointer, and the places that warnings speak of.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { BufferAttribute, BufferGeometry } from 'three';

import { withNormals } from '../web/triangles/normals.js';
import { drop, opened, reportRow, settled, visit } from './support/browser_page.js';
import { objText, torus } from './support/shape_files.js';

const { page, complaints } = await visit(
  { hash: '#model=gear&vertices=600', viewport: { width: 800, height: 480 } });

const picture = () => page.locator('#canvas').screenshot();

/** Opens a shape from its text. */
async function open(name, text) {
  await drop(page, { [name]: text });
  await opened(page, name);
}

const number = (text) => Number(text.replace(/[^\d.].*/, ''));

test('the largest distance is near what the report says, and one click away', async () => {
  await page.waitForSelector('#distances:not([hidden])');
  const text = await page.textContent('#visit-largest');
  const found = number(/\(([\d.]+) %\)/.exec(text)[1]);
  const told = number((await reportRow(page, 'Largest distance'))[1]);
  assert.ok(found > 0.4 * told && found < 1.02 * told, `${found} % beside ${told} %`);
  const earlier = await picture();
  await page.click('#visit-largest');
  await page.waitForSelector('#legend:not([hidden]) .legend-marks span >> nth=2');
  assert.match(await page.textContent('#legend'), /Distance to the original.*%/);
  assert.equal(await page.getAttribute('[data-shading=distance]', 'aria-pressed'), 'true');
  assert.notDeepEqual(await picture(), earlier);
});

test('every view is a picture of its own, by button and by key', async () => {
  await page.click('[data-do=fit]');
  await page.click('#wireframe');
  const pictures = [];
  for (const view of ['plain', 'flat', 'normals', 'angles', 'distance']) {
    await page.click(`[data-shading=${view}]`);
    await page.waitForTimeout(150);
    pictures.push(String(await picture()));
  }
  // On a gear, whose faces are all flat, smooth is flat.
  assert.ok(new Set(pictures).size >= 4);
  assert.equal(await page.isDisabled('[data-shading=textured]'), true);
  await page.focus('#canvas');
  await page.keyboard.press('5');
  assert.equal(await page.getAttribute('[data-shading=angles]', 'aria-pressed'), 'true');
  await page.keyboard.press('w');
});

test('creases are counted as the angle changes', async () => {
  await page.focus('#canvas');
  await page.keyboard.press('e');
  const creases = async () => Number(await page.getAttribute('#features', 'data-count'));
  // A section has eight corners; of those around a tooth's flank some bend less.
  const first = await creases();
  assert.ok(first >= 8 * 56, `${first} creases`);
  await page.keyboard.press('e');
  await page.click('.more > summary');
  await page.fill('#option-featureAngle', '120');
  assert.equal(await page.getAttribute('#features', 'aria-pressed'), 'true');
  assert.equal(await creases(), 0);
  await page.fill('#option-featureAngle', 'off');
  assert.equal(await creases(), 0);
  await page.fill('#option-featureAngle', '');
  assert.equal(await creases(), first);
  await settled(page);
});

test('a pointer finds its triangle', async () => {
  await page.click('[data-do=fit]');
  const box = await page.locator('#canvas').boundingBox();
  await page.mouse.move(box.x + 0.635 * box.width, box.y + 0.4 * box.height);
  await page.mouse.move(box.x + 0.64 * box.width, box.y + 0.4 * box.height);
  await page.waitForSelector('#probe:not([hidden])');
  const text = await page.textContent('#probe');
  const angles = /Angles ([\d.]+)° ([\d.]+)° ([\d.]+)°/.exec(text).slice(1).map(Number);
  assert.ok(Math.abs(angles[0] + angles[1] + angles[2] - 180) < 0.3, text);
  assert.match(text, /Edges .*\nDistance .*%/);
  await page.mouse.move(5, 5);
});

test('borders, faults and flips of the input are counted and shown', async () => {
  const fault = (lines) => `${lines.join('\n')}\n`;
  const sheet = ['v 0 0 0', 'v 1 0 0', 'v 1 1 0', 'v 0 1 0', 'v 2 0 0', 'v 2 1 0', 'v 1 0 1',
    'v 1 -2.4e-16 0'];
  // Two squares side by side, but for rounding, a fin on their common edge, and one triangle
  // turned over.
  await open('faults.obj', fault([...sheet, 'f 1 2 3', 'f 1 3 4', 'f 8 5 6', 'f 8 3 6',
    'f 2 3 7']));
  await page.waitForSelector('#landmark-nonManifold');
  assert.match(await page.textContent('#landmark-nonManifold'), /^1 /);
  assert.match(await page.textContent('#landmark-flipped'), /^1 /);
  assert.match(await page.textContent('#landmark-boundary'), /^8 /);
  const earlier = await picture();
  await page.click('#landmark-nonManifold');
  await page.waitForFunction(() => document.getElementById('status').textContent
    .includes('at that place'));
  assert.notDeepEqual(await picture(), earlier);
  await page.click('#result .notice button >> nth=0');
});

test('a model far from the origin is measured as the same one near it', async () => {
  const ring = torus(24, 12);
  const positions = ring.positions.map(([x, y, z]) =>
    [x + 431234.5, y + 5412345.75, z + 312.25]);
  const told = [];
  for (const [name, shape] of [['near.obj', ring], ['far.obj', { ...ring, positions }]]) {
    await open(name, objText(shape));
    await page.waitForSelector('#distances:not([hidden])');
    assert.ok(await page.isHidden('#landmarks'), 'no fault is seen where there is none');
    told.push([number(/\(([\d.]+) %\)/.exec(await page.textContent('#visit-largest'))[1]),
      await page.getAttribute('#features', 'data-count')]);
  }
  const [[distance, creases], [farDistance, farCreases]] = told;
  assert.equal(farCreases, creases);
  assert.ok(Math.abs(farDistance - distance) < 0.1 * distance, `${told}`);
});

test('dragging on the distances sets the largest error', async () => {
  await open('ring.obj', objText(torus(24, 12)));
  await page.waitForSelector('#distances:not([hidden])');
  await page.focus('#error-handle');
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => location.hash.includes('maxError='));
  await settled(page);
  const asked = Number(await page.inputValue('#option-maxError'));
  const told = number((await reportRow(page, 'Largest distance'))[1]);
  assert.ok(asked > 0 && told <= asked, `${told} % within ${asked} %`);
});

/** A geometry of three.js. */
function geometryOf({ positions, triangles }) {
  const geometry = new BufferGeometry().setIndex(triangles.flat());
  return geometry.setAttribute('position',
    new BufferAttribute(Float32Array.from(positions.flat()), 3));
}

/** A box of twelve triangles over eight corners. */
const box = { positions: [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, i >> 2]),
  triangles: [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 6, 7],
    [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]] };

test('normals follow bends, and break at creases', async () => {
  const { attributes: { position, normal } } = await withNormals(geometryOf(box));
  assert.equal(normal.count, 36);
  for (let i = 0; i < 36; i += 1) {
    const own = [normal.getX(i), normal.getY(i), normal.getZ(i)];
    const axis = own.findIndex((value) => Math.abs(value) === 1);
    assert.deepEqual(own.filter((_, k) => k !== axis).map(Math.abs), [0, 0]);
    assert.equal(own[axis], 2 * position.getComponent(i, axis) - 1, 'outwards');
  }
  const ring = torus(80, 60);
  const smooth = await withNormals(geometryOf(ring));
  assert.equal(smooth.attributes.normal.count, ring.positions.length);
  ring.positions.forEach(([x, y, z], i) => {
    const share = 1 - 2 / Math.hypot(x, z);  // from the middle of the tube outwards
    const exact = [share * x / 0.8, y / 0.8, share * z / 0.8];
    const cosine = exact.reduce((sum, value, k) =>
      sum + value * smooth.attributes.normal.getComponent(i, k), 0);
    assert.ok(cosine > 0.999, `${cosine}`);
  });
});

test('turning the model draws two meshes with their lines and nothing else', async () => {
  const { calls, triangles } = await page.evaluate(() =>
    ({ ...document.getElementById('canvas').dataset }));
  assert.ok(Number(calls) <= 8, `${calls} calls`);
  assert.ok(Number(triangles) <= 4 * 576 + 100, `${triangles} triangles`);
  assert.deepEqual(complaints, []);
});
