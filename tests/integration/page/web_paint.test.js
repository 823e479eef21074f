// SPDX-License-Identifier: MIT
// Density painted on the original: where more is painted, more vertices come; strokes are undone,
// mirrored, wiped, and there again when the model is.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { drop, opened, saved, settled, visit } from '../../support/browser_page.js';
import { objText, torus } from '../../support/shape_files.js';

const { page, complaints } = await visit(
  { hash: '#model=bunny&vertices=800', unseen: true, viewport: { width: 800, height: 480 } });

/** What the browser keeps of the strokes. */
const dabs = () => page.evaluate(() =>
  JSON.parse(localStorage.getItem('remesher.paint') ?? '{}').dabs ?? []);

/** Waits until there are so many dabs, and the best result with them. */
async function painted(count) {
  await page.waitForFunction((wanted) =>
    (JSON.parse(localStorage.getItem('remesher.paint') ?? '{}').dabs ?? []).length === wanted,
  count);
  await page.waitForFunction(() => document.body.dataset.state === 'idle'
    && document.querySelector('.takeaway'));
}

/** How many vertices of the result lie in the inner half of a dab. */
async function verticesWithin({ point, radius }) {
  const { bytes } = await saved(page, '.takeaway button:text-is("OFF")');
  await settled(page);
  const [, counts, ...lines] = String(bytes).split('\n');
  const points = lines.slice(0, Number(counts.split(' ')[0]))
    .map((line) => line.split(' ').map(Number));
  return points.filter((p) => Math.hypot(...p.map((x, i) => x - point[i])) < radius / 2).length;
}

const results = () => page.locator('.history-entry').count();

test('a stroke brings more vertices where it is, and as many as before in all', async () => {
  await page.focus('#canvas');
  await page.keyboard.press('p');
  assert.equal(await page.getAttribute('#paint', 'aria-pressed'), 'true');
  await page.locator('#brush-strength').fill('2');
  await page.locator('#brush-size').fill('0.15');
  await page.focus('#canvas');
  await page.keyboard.press('Enter');
  await painted(1);
  await page.waitForFunction(() => document.querySelectorAll('.history-entry').length === 2);
  const [dab] = await dabs();
  const more = await verticesWithin(dab);
  // A link cannot hold it, nor can a line to type: that is said where they are.
  assert.match(await page.textContent('#no-density'), /density .* none of these/);
  assert.equal(await page.textContent('#result-count'), '800');
  await page.focus('#canvas');
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => document.querySelectorAll('.history-entry').length === 3);
  await settled(page);
  assert.deepEqual(await dabs(), []);
  assert.equal(await page.locator('#no-density').count(), 0);
  const even = await verticesWithin(dab);
  assert.ok(more > 1.5 * even, `${more} where there were ${even}`);
});

test('the mouse paints on the original and turns nothing', async () => {
  const box = await page.locator('#canvas').boundingBox();
  const [x, y] = [box.x + 0.25 * box.width, box.y + 0.5 * box.height];
  const known = await results();
  await page.check('#brush-mirror');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.waitForTimeout(150);
  await page.mouse.up();
  await painted(2);  // the dab and its mirror image
  const [one, other] = await dabs();
  assert.equal(one.point[1], other.point[1]);
  assert.notEqual(one.point[0], other.point[0]);
  await page.waitForFunction((count) =>
    document.querySelectorAll('.history-entry').length > count, known);
  await settled(page);
});

test('what was painted is there again with the model, until it is cleared', async () => {
  await page.reload();
  await settled(page);
  assert.equal((await dabs()).length, 2);
  await page.click('#paint');
  await page.click('#brush-clear');
  await painted(0);
  await page.click('#brush-done');
  assert.equal(await page.isVisible('#brush'), false);
  assert.equal(await page.getAttribute('[data-shading=plain]', 'aria-pressed'), 'true');
});

test('far from the origin, too, vertices come where it is painted', async () => {
  const ring = torus(40, 24);
  const counts = [];
  let dab;
  for (const shift of [[0, 0, 0], [431234.5, 5412345.75, 312.25]]) {
    const positions = ring.positions.map((p) => p.map((x, i) => x / 32 + shift[i]));
    await drop(page, { [`at ${shift[0]}.obj`]: objText({ ...ring, positions }) });
    await opened(page, `at ${shift[0]}.obj`);
    await page.click('#paint');
    await page.locator('#brush-strength').fill('2');
    await page.locator('#brush-size').fill('0.15');
    await page.uncheck('#brush-mirror');
    await page.focus('#canvas');
    await page.keyboard.press('Enter');
    await painted(1);
    dab ??= (await dabs())[0];
    counts.push(await verticesWithin({ ...dab, point: dab.point.map((x, i) => x + shift[i]) }));
    await page.click('#brush-clear');
    await painted(0);
    counts.push(await verticesWithin({ ...dab, point: dab.point.map((x, i) => x + shift[i]) }));
    await page.click('#brush-done');
  }
  const [dense, even, farDense, farEven] = counts;
  assert.ok(dense > 1.5 * even && farDense > 1.5 * farEven, `${counts}`);
  assert.deepEqual(complaints, []);
});
