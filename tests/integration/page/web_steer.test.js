// SPDX-License-Identifier: MIT
// Trying on the page: drafts follow a slider, purposes set options, steps are undone, results so
// far are shown again and compared.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';

import { drop, opened, reportRow, settled, visit } from '../../support/browser_page.js';
import { plate } from '../../support/machine_parts.js';
import { objText, torus } from '../../support/shape_files.js';
import { offText } from '../../support/shapes.js';

const { page, complaints } = await visit({ hash: '#model=gear&vertices=500',
  viewport: { width: 800, height: 480 }, unseen: true, prepare: noteStates });

before(async () => {
  await drop(page, { 'ring.obj': objText(torus(24, 12)) });
  await opened(page, 'ring.obj');
});

/** Notes in the page what it was doing, one after the other. */
function noteStates() {
  globalThis.states = [];
  addEventListener('DOMContentLoaded', () => {
    new MutationObserver(() => globalThis.states.push(document.body.dataset.state))
      .observe(document.body, { attributes: true, attributeFilter: ['data-state'] });
  });
}

const result = async () => (await reportRow(page, 'Vertices'))[1];
const value = (selector) => page.inputValue(selector);

/** Waits for a result of the best quality, and until nothing goes on. */
async function best(vertices) {
  await page.waitForFunction((wanted) => document.body.dataset.state === 'idle'
    && document.querySelector('.takeaway')
    && document.getElementById('result-count').textContent === wanted, vertices);
}

test('a draft follows the slider, and the best comes when it rests', async () => {
  await page.evaluate(() => { globalThis.states = []; });
  await page.focus('#target-slider');
  await page.keyboard.press('End');
  const most = await value('#target');
  assert.equal(most, '2900');  // ten times 288, in two digits
  await best('2,900');
  const states = await page.evaluate(() => globalThis.states);
  assert.equal(states[0], 'drafting');
  assert.ok(states.includes('busy'), states.join());
  assert.equal(await result(), '2,900');
});

test('nothing follows when that is not wanted', async () => {
  await page.uncheck('#live');
  await page.evaluate(() => { globalThis.states = []; });
  await page.fill('#target', '400');
  await page.dispatchEvent('#target', 'change');
  await page.waitForTimeout(700);
  assert.deepEqual(await page.evaluate(() => globalThis.states), []);
  await page.check('#live');
  await page.click('form button[type=submit]');
  await best('400');
});

test('a purpose sets options for all to see', async () => {
  await page.click('#purpose-print');
  assert.equal(await page.isVisible('#amount'), false, 'repair has no number');
  await settled(page);
  await page.click('#work-remesh');
  assert.equal(await value('#amount'), '0.01');  // of a torus whose diagonal is 8.1
  assert.equal(await value('#option-maxError'), '0.1238');
  assert.equal(await value('#option-adaptivity'), '0.7');
  assert.equal(await value('#target'), '');
  assert.equal(await page.textContent('#asked'),
    'Printable · Adaptivity 0.7 · Max error 0.1238 · Repair auto');
  assert.equal(await page.locator('.field.set').count(), 3);
  await page.waitForFunction(() => location.hash.includes('maxError=0.1238'));
  await settled(page);
});

test('steps are undone and done again, by button and by key', async () => {
  await page.click('#undo');
  assert.equal(await page.textContent('#asked'), 'Repair only');
  await page.click('#undo');
  assert.equal(await page.textContent('#asked'), '');
  assert.equal(await value('#option-maxError'), '');
  await page.focus('#canvas');
  await page.keyboard.press('Control+Shift+Z');
  await page.keyboard.press('Control+Shift+Z');
  assert.equal(await value('#option-maxError'), '0.1238');
  assert.equal(await page.getAttribute('#purpose-print', 'aria-pressed'), 'true');
  assert.equal(await page.isDisabled('#redo'), true);
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('Control+z');
  assert.equal(await value('#target'), '2900');
  await settled(page);
  await best('2,900');
});

test('results so far are shown again, and any two compared', async () => {
  const entries = page.locator('.history-entry');
  const count = await entries.count();
  assert.ok(count >= 4, `${count} results`);
  const second = entries.filter({ hasText: '400 vertices' }).last();
  await second.click();
  await settled(page);
  assert.equal(await page.textContent('#result-count'), '400');
  assert.equal(await value('#target'), '400');
  await page.selectOption('#baseline', '2');
  await settled(page);
  assert.match(await page.textContent('.tag-left'), /Result 2\s+2,900/);
  await page.selectOption('#baseline', '');
  await settled(page);
  assert.match(await page.textContent('.tag-left'), /Original\s+288/);
});

test('Enter asks once, and what is cancelled does not begin again', async () => {
  const rest = () => page.waitForTimeout(700);  // longer than a slider has to rest
  const entries = await page.locator('.history-entry').count();
  await page.fill('#target', '450');
  await page.press('#target', 'Enter');
  await rest();
  await best('450');
  assert.equal(await page.locator('.history-entry').count(), entries + 1);
  await page.fill('#target', '100000');
  await page.press('#target', 'Enter');
  await page.click('#cancel');
  await settled(page);
  await page.evaluate(() => { globalThis.states = []; });
  await rest();
  assert.deepEqual(await page.evaluate(() => globalThis.states), []);
});

test('a new model begins anew', async () => {
  await drop(page, { 'other.obj': objText(torus(16, 8)) });
  await opened(page, 'other.obj');
  assert.equal(await page.isDisabled('#undo'), true);
  assert.equal(await page.locator('.history-entry').count(), 0);
  assert.deepEqual(complaints, []);
});

test('a model too coarse for isotropic triangles opens with enough vertices', async () => {
  await page.locator('button', { hasText: 'Back to the defaults' }).dispatchEvent('click');
  await page.selectOption('.target select', 'vertices');
  await drop(page, { 'plate.off': offText(plate()) });
  await opened(page, 'plate.off');
  const enough = (await result()).replace(',', '');
  assert.ok(Number(enough) > 392 && Number(enough) <= 4 * 392, enough);
  assert.match(await page.textContent('#target-hint'),
    /^Exactly: [\d.]+ times the original’s 392, for isotropic triangles need them/);
  assert.equal(await page.isDisabled('#undo'), true);
  assert.equal(await page.locator('.history-entry').count(), 0);
  assert.match(await page.evaluate(() => location.hash), new RegExp(`vertices=${enough}`));
  await page.fill('#target', '392');
  await page.dispatchEvent('#target', 'change');
  await best('392');
  assert.match(await page.textContent('#target-hint'), /as many as the original has/);
  await page.click('#undo');
  await best(Number(enough).toLocaleString('en'));
  assert.match(await page.textContent('#target-hint'), /for isotropic triangles need them/);
});

test('where shape was lost is said, and shown', async () => {
  assert.equal(await page.locator('#shape-lost').count(), 0);
  await page.selectOption('#option-prefer', 'even', { force: true });
  await page.fill('#target', '120');
  await page.dispatchEvent('#target', 'change');
  await best('120');
  assert.match(await page.textContent('#shape-lost'),
    /^Shape was lost: at its farthest the result is [\d.]+ % of the diagonal/);
  await page.waitForSelector('#visit-largest');
  await page.click('#shape-lost button');
  await page.waitForSelector('[data-shading=distance][aria-pressed=true]');
  assert.deepEqual(complaints, []);
});

test('the field shows on a draft of quads while a slider moves, and goes with it', async () => {
  await drop(page, { 'ring.obj': objText(torus(24, 12)) });
  await opened(page, 'ring.obj');
  await page.click('#purpose-quads');
  await settled(page);
  await page.evaluate(() => {
    globalThis.drawn = [];
    const canvas = document.getElementById('canvas');
    new MutationObserver(() => globalThis.drawn.push([Number(canvas.dataset.calls),
      document.getElementById('right-name').textContent]))
      .observe(canvas, { attributes: true, attributeFilter: ['data-calls'] });
  });
  await page.focus('#amount-slider');
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => document.getElementById('right-name').textContent === 'Draft');
  await page.waitForFunction(() => document.body.dataset.state === 'idle'
    && document.getElementById('right-name').textContent === 'Result');
  const drawn = await page.evaluate(() => globalThis.drawn);
  const most = Math.max(...drawn.filter(([, name]) => name === 'Draft').map(([calls]) => calls));
  const last = Number(await page.getAttribute('#canvas', 'data-calls'));
  assert.equal(most, last + 1, JSON.stringify(drawn));
  assert.deepEqual(complaints, []);
});

test('options of a purpose stay with neither the next purpose nor the next model', async () => {
  await page.fill('#target', '150');
  await page.dispatchEvent('#target', 'change');
  await settled(page);
  await page.locator('button', { hasText: 'Back to the defaults' }).dispatchEvent('click');
  await page.fill('#target', '150');
  await page.dispatchEvent('#target', 'change');
  await page.click('#purpose-asset');
  assert.equal(await value('#option-prefer'), 'shape');
  await page.click('#preset-even');
  assert.deepEqual([await value('.target select'), await value('#target')], ['vertices', '150']);
  assert.equal(await page.textContent('#asked'), 'Adaptivity 0');
  for (const purpose of ['asset', 'print', 'quads']) {
    await page.click(`#purpose-${purpose}`);
    await settled(page);
    await drop(page, { [`after ${purpose}.obj`]: objText(torus(24, 12)) });
    await opened(page, `after ${purpose}.obj`);
    assert.equal(await page.textContent('#asked'), '');
    assert.equal(await page.locator('.door[aria-pressed=true]').count(), 0);
    assert.deepEqual([await value('.target select'), await value('#target')],
      ['vertices', '288']);
    assert.match(await page.evaluate(() => location.hash), /^#vertices=288$/);
  }
});
