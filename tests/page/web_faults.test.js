// SPDX-License-Identifier: MIT
// Faults of the model that is open: those of the model before are gone, and if faults are not
// looked for, the page says so and offers it.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { nestedBoxes } from '../support/broken_shapes.js';
import { cancelAtOnce, drop, opened, settled, visit } from '../support/browser_page.js';
import { stl, torus } from '../support/shapes.js';

const { page, complaints } = await visit(
  { hash: '#model=gear&vertices=300', unseen: true, viewport: { width: 800, height: 480 } });

/** Opens boxes inside boxes, whose faults are found. */
async function openBoxes() {
  await drop(page, { 'boxes.stl': stl(nestedBoxes(3)) });
  await opened(page, 'boxes.stl');
  await page.waitForSelector('#landmark-innerShells');
}

test('no fault of the model before is shown under the name of the next one', async () => {
  await openBoxes();
  await page.evaluate(() => {
    globalThis.stale = [];
    const name = document.getElementById('model-name');
    const look = () => {
      if (name.textContent !== 'ring.stl') return;
      globalThis.stale.push(document.getElementById('landmarks').textContent);
    };
    new MutationObserver(look).observe(document.querySelector('.model'),
      { childList: true, characterData: true, attributes: true, subtree: true });
  });
  await drop(page, { 'ring.stl': stl(torus()) });
  await opened(page, 'ring.stl');
  await page.waitForTimeout(300);
  const stale = await page.evaluate(() => globalThis.stale);
  assert.ok(stale.length > 0);
  assert.deepEqual(stale.filter((text) => text.includes('inner')), []);
  assert.equal(await page.isVisible('#landmarks'), false);
  assert.equal(await page.isVisible('#fault-note'), false);
});

test('a file that cannot be read leaves the model and its faults', async () => {
  await openBoxes();
  await drop(page, { 'broken.glb': 'no model' });
  await page.waitForSelector('#error:visible');
  await settled(page);
  assert.ok(await page.isVisible('#landmark-innerShells'));
});

test('where a purpose is chosen while a model opens, faults are looked for, too', async () => {
  await page.evaluate(() => {
    const observer = new MutationObserver(() => {
      const door = document.getElementById('purpose-asset');
      const name = document.getElementById('model-name').textContent;
      if (name !== 'chosen.stl') return;
      globalThis.doors = [...globalThis.doors ?? [], door.disabled];
      if (door.disabled) return;
      observer.disconnect();
      door.click();
    });
    for (const id of ['model-name', 'model-size']) {
      observer.observe(document.getElementById(id), { childList: true });
    }
  });
  await drop(page, { 'chosen.stl': stl(nestedBoxes(2)) });
  await opened(page, 'chosen.stl');
  await page.waitForSelector('#landmark-innerShells');
  assert.equal(await page.evaluate(() => globalThis.doors[0]), true, 'none while it is unknown');
});

test('where the opening is cancelled, faults are looked for on request', async () => {
  await cancelAtOnce(page);
  await drop(page, { 'shells.stl': stl(nestedBoxes(2)) });
  await opened(page, 'shells.stl');
  await page.waitForSelector('#fault-note:not([hidden])');
  assert.match(await page.textContent('#fault-note'), /not looked for.* cancelled/);
  await page.click('#seek-faults');
  await page.waitForSelector('#landmark-innerShells');
  assert.equal(await page.isVisible('#fault-note'), false);
  assert.deepEqual(complaints, []);
});
