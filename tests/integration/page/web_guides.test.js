// SPDX-License-Identifier: MIT
// Guides are drawn on the model by real events, quads follow them, and they are undone, erased,
// mirrored, cleared, and there again when the model is.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { barriers } from '../../support/barriers.js';
import { drop, opened, saved, settled, visit } from '../../support/browser_page.js';
import { verdict } from '../../support/doors.js';
import { readSurface } from '../../support/mesh_files.js';
import { objText, torus } from '../../support/shape_files.js';

const { page, complaints } = await visit(
  { hash: '#model=gear&vertices=200', unseen: true, viewport: { width: 1000, height: 600 } });

/** What the browser keeps of the strokes. */
const strokes = () => page.evaluate(() =>
  JSON.parse(localStorage.getItem('remesher.guides') ?? '{}').strokes ?? []);

/** Waits until there are so many strokes, and the best result with them. */
async function drawn(count) {
  await page.waitForFunction((wanted) =>
    (JSON.parse(localStorage.getItem('remesher.guides') ?? '{}').strokes ?? []).length === wanted,
  count);
  await page.waitForTimeout(600);  // longer than a stroke has to rest
  return verdict(page);
}

/** Draws from one place of the left picture to another, in shares of that picture. */
async function draw(from, to) {
  const box = await page.locator('#canvas').boundingBox();
  const at = ([x, y]) => [box.x + x * box.width / 2, box.y + y * box.height];
  await page.mouse.move(...at(from));
  await page.mouse.down();
  await page.mouse.move(...at(to), { steps: 5 });
  await page.mouse.up();
}

/** From above, the tube's right side is in the picture's right part. */
async function lookFromAbove() {
  await page.focus('#canvas');
  for (let i = 0; i < 20; ++i) await page.keyboard.press('ArrowUp');
}

const [across, along] = [[[0.58, 0.44], [0.9, 0.57]], [[0.42, 0.63], [0.58, 0.63]]];

test('the door to quads has them, other doors have not', async () => {
  await drop(page, { 'ring.obj': objText(torus(40, 20)) });
  await opened(page, 'ring.obj');
  assert.equal(await page.isVisible('#guides'), false);
  await page.focus('#canvas');
  await page.keyboard.press('g');
  assert.equal(await page.isVisible('#pencil'), false, 'there are no quads');
  await page.click('#purpose-quads');
  await verdict(page);
  await page.click('#guides');
  assert.equal(await page.getAttribute('#guides', 'aria-pressed'), 'true');
  assert.ok(await page.isVisible('#pencil'));
  assert.deepEqual(await barriers(page), []);
});

test('a line that is too short is said to be, and none is kept', async () => {
  await lookFromAbove();
  await draw([0.74, 0.5], [0.743, 0.5]);
  await page.waitForSelector('#news:visible');
  assert.match(await page.textContent('#news'), /too short for quads to follow/);
  assert.deepEqual(await strokes(), []);
});

test('a stroke across the tube is a ring round it, and becomes sides of quads', async () => {
  await lookFromAbove();
  await page.check('#pencil-loop');
  await draw(...across);
  await drawn(1);
  const [{ kind, points }] = await strokes();
  assert.equal(kind, 'loop');
  const heights = points.map(([, y]) => y);
  assert.ok(Math.min(...heights) < -0.7 && Math.max(...heights) > 0.7, 'it goes on behind');
  const { bytes } = await saved(page, '#download');
  await settled(page);
  const { positions, faces } = readSurface({ 'a.obj': bytes });
  assert.ok(faces.every((face) => face.length === 4));
  const sides = faces.flatMap((face) => face.map((v, i) =>
    [positions[v], positions[face[(i + 1) % 4]]]));
  const off = (point) => Math.min(...sides.map(([a, b]) => distance(point, a, b)));
  assert.ok(Math.max(...points.map(off)) < 0.05, `${Math.max(...points.map(off))}`);
});

/** The distance of a point from a side. */
function distance(point, a, b) {
  const along3 = b.map((x, k) => x - a[k]), own = point.map((x, k) => x - a[k]);
  const dot = (p, q) => p.reduce((sum, x, k) => sum + x * q[k], 0);
  const share = Math.min(1, Math.max(0, dot(own, along3) / dot(along3, along3)));
  return Math.hypot(...own.map((x, k) => x - share * along3[k]));
}

test('the command has them in a file', async () => {
  await page.click('.command > summary');
  assert.match(await page.textContent('.command code >> nth=0'),
    / --quads .*--guides guides\.obj$/);
  const { name, bytes } = await saved(page, '#guides-note button');
  assert.equal(name, 'guides.obj');
  assert.match(String(bytes), /^o loop 1\nv [\s\S]*\nl 1 2 .* \d+\n$/);
});

test('a direction, mirrored; undone from the pencil; erased with the rubber', async () => {
  await page.check('#pencil-direction');
  await page.check('#pencil-mirror');
  await draw(...along);
  await drawn(3);
  const [, one, other] = await strokes();
  assert.deepEqual(one.points.map(([x, y, z]) => [-x, y, z].map((v) => v.toFixed(3))),
    other.points.map((point) => point.map((v) => v.toFixed(3))));
  await page.click('#pencil-undo');
  await drawn(1);
  await page.uncheck('#pencil-mirror');
  await draw(...along);
  await drawn(2);
  assert.match(await page.textContent('#guides'), /2/);
  await page.check('#pencil-erase');
  await draw([0.5, 0.58], [0.5, 0.7]);
  await drawn(1);
  assert.equal((await strokes())[0].kind, 'loop');
});

test('the keyboard draws, too: point by point, from the middle', async () => {
  await page.check('#pencil-direction');
  await page.click('[data-do=fit]');
  await page.focus('#canvas');
  // From the side the tube is in the middle; from above there is the hole.
  for (const key of ['ArrowDown', 'ArrowDown', 'Enter', 'ArrowRight', 'ArrowRight', 'Enter',
    'ArrowRight', 'ArrowRight', 'Enter']) await page.keyboard.press(key);
  await page.click('#pencil-finish');
  await drawn(2);
  const [, { kind, points }] = await strokes();
  assert.equal(kind, 'direction');
  assert.equal(points.length, 3);
  await page.focus('#canvas');
  await page.keyboard.press('Control+z');
  await drawn(1);
});

test('one finger draws, two fingers turn the model and draw nothing', async () => {
  const cdp = await page.context().newCDPSession(page);
  const box = await page.locator('#canvas').boundingBox();
  const fingers = (type, points) => cdp.send('Input.dispatchTouchEvent', { type,
    touchPoints: points.map((x, id) =>
      ({ x: box.x + x * box.width / 2, y: box.y + 0.63 * box.height, id })) });
  const drag = async (from) => {
    await fingers('touchStart', from);
    for (let i = 1; i <= 4; ++i) await fingers('touchMove', from.map((x) => x + 0.03 * i));
    await fingers('touchEnd', []);
  };
  for (const [count, from] of [[2, [0.44]], [2, [0.3, 0.6]], [3, [0.44]]]) {
    await page.click('[data-do=fit]');
    await lookFromAbove();
    await drag(from);
    await drawn(count);
  }
  assert.equal((await strokes()).length, 3, 'strokes are made in order: there is no other');
  await page.focus('#canvas');
  for (const count of [2, 1]) {
    await page.keyboard.press('Control+z');
    await drawn(count);
  }
  await cdp.detach();
});

test('out of sight for other purposes, kept with the model, and cleared', async () => {
  await page.click('#purpose-asset');
  await verdict(page);
  assert.equal(await page.isVisible('#pencil'), false);
  assert.equal(await page.locator('#guides-note').count(), 0);
  await drop(page, { 'ring.obj': objText(torus(40, 20)) });
  await opened(page, 'ring.obj');
  await page.click('#purpose-quads');
  await verdict(page);
  assert.match(await page.textContent('#guides'), /1/);
  await page.focus('#canvas');
  await page.keyboard.press('g');
  await page.click('#pencil-clear');
  await drawn(0);
  assert.equal(await page.locator('#guides-note').count(), 0);
  await page.click('#pencil-done');
  assert.equal(await page.isVisible('#pencil'), false);
  await drop(page, { 'other.obj': objText(torus(30, 20)) });
  await opened(page, 'other.obj');
  assert.deepEqual(await strokes(), []);
  assert.deepEqual(complaints, []);
});
