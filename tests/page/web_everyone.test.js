// SPDX-License-Identifier: MIT
// The page for everyone: no barriers in any state, all by keyboard, on a phone, other colours, no
// motion; tests/integration/page/web_layout.test.js has other languages and widths.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { barriers } from '../support/barriers.js';
import { drop, settled, visit } from '../support/browser_page.js';
import { objText, torus } from '../support/shape_files.js';

const { page, complaints } = await visit(
  { hash: '#model=gear&vertices=500', unseen: true, viewport: { width: 900, height: 560 } });

const ring = objText(torus(16, 8));

/** What brings the page into each state, one after the other, and out of it again. */
const states = [
  ['a result', () => page.waitForSelector('#distances:not([hidden])')],
  ['options and snippets open', async () => {
    await page.click('.more > summary');
    await page.click('.command > summary');
  }],
  ['distances', () => page.click('[data-shading=distance]')],
  ['painting', () => page.click('#paint'), () => page.click('#brush-done')],
  ['several results', async () => {
    await page.click('#preset-even');
    await page.waitForSelector('.history-entry');
    await settled(page);
    assert.match(await page.textContent('#progress-phase'), /^[A-Z]/);
  }],
  ['settings', () => page.click('[data-do=settings]'), () => page.click('#settings-close')],
  ['the chooser', async () => {
    await drop(page, { 'one.obj': ring, 'two.obj': ring });
    await page.waitForSelector('#chooser[open]');
  }, async () => {
    await page.click('#chooser-close');
    await settled(page);
  }],
  ['an error', async () => {
    await drop(page, { 'notes.txt': 'hello' });
    await page.waitForSelector('#error:visible');
    await settled(page);
  }],
];

for (const [name, enter, leave] of states) {
  test(`axe finds no barriers: ${name}`, async () => {
    await enter();
    assert.deepEqual(await barriers(page), []);
    await leave?.();
  });
}

test('? lists every key there is, and letters can be turned off', async () => {
  await page.focus('#canvas');
  await page.keyboard.press('?');
  await page.waitForSelector('#settings[open]');
  const keys = await page.locator('#key-list dt').allTextContents();
  for (const key of ['O', 'W', 'F', 'E', 'I', 'P', 'C', '1', '?', 'CtrlZ', 'CtrlShiftZ']) {
    assert.ok(keys.includes(key), `${key} among ${keys.join(' ')}`);
  }
  await page.uncheck('#single-keys');
  await page.keyboard.press('Escape');
  const pressed = () => page.getAttribute('#wireframe', 'aria-pressed');
  const first = await pressed();
  await page.focus('#canvas');
  await page.keyboard.press('w');
  assert.equal(await pressed(), first);
  assert.equal(await page.getAttribute('#wireframe', 'aria-keyshortcuts'), null);
  await page.click('[data-do=settings]');
  await page.check('#single-keys');
  await page.keyboard.press('Escape');
  await page.focus('#canvas');
  await page.keyboard.press('w');
  assert.notEqual(await pressed(), first);
});

test('the tab key reaches every control, in the order in which they are seen', async () => {
  await page.focus('#samples');
  const reached = new Set(['samples']);
  for (let i = 0; i < 120; ++i) {
    await page.keyboard.press('Tab');
    const id = await page.evaluate(() => {
      const node = document.activeElement;
      return node === document.body ? '' : node.id || node.dataset.do || node.textContent;
    });
    if (!id) break;
    reached.add(id);
  }
  for (const id of ['samples', 'open', 'settings', 'canvas', 'divider', 'compare.side', 'fit',
    'target', 'target-slider', 'purpose-print', 'preset-even', 'download', 'option-scheme',
    'visit-largest', 'baseline']) {
    assert.ok(reached.has(id), `${id} among ${[...reached].join(', ')}`);
  }
});

test('on a phone a finger finds every control', async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  await settled(page);
  // In one look: a draft that begins between two looks changes which controls are seen.
  const small = await page.locator(
    ':is(button, select, summary, input:not([type=checkbox], [type=radio], #divider))')
    .evaluateAll((controls) => controls.filter((control) => control.checkVisibility({
      checkVisibilityCSS: true,
    })).map((control) => {
      const { width, height } = control.getBoundingClientRect();
      return { name: control.id || control.textContent, width, height };
    }).filter(({ width, height }) => width > 0 && (width < 44 || height < 44)));
  assert.deepEqual(small, []);
  const labels = await page.locator('label:has(input[type=checkbox]):visible')
    .evaluateAll((nodes) => nodes.map((node) => node.getBoundingClientRect().height));
  assert.ok(labels.length > 0 && Math.min(...labels) >= 44, labels.join(' '));
  await page.setViewportSize({ width: 900, height: 560 });
});

/** Where an element is in the window. */
const box = (selector) => page.locator(selector).evaluate((element) => {
  const { left, right, top, bottom } = element.getBoundingClientRect();
  return { left, right, top, bottom };
});

test('a run is in view, and can be cancelled, however short the window', async () => {
  for (const [width, height] of [[1024, 420], [390, 560]]) {
    await page.setViewportSize({ width, height });
    await page.fill('#target', '20000');
    await page.press('#target', 'Enter');
    await page.waitForSelector('#progress:not([hidden])');
    await page.evaluate(() => scrollTo(0, 0));
    const { top, bottom } = await box('#cancel');
    await page.locator('#cancel').dispatchEvent('click');
    await settled(page);
    assert.ok(top >= 0 && bottom <= height, `${top} to ${bottom} of ${height}`);
  }
  await page.setViewportSize({ width: 900, height: 560 });
});

test('colours of the visitor’s own, dark ones, and no motion', async () => {
  await page.emulateMedia({ forcedColors: 'active' });
  assert.deepEqual(await barriers(page), []);
  const outline = await page.evaluate(() =>
    getComputedStyle(document.querySelector('[data-shading][aria-pressed=true]')).outlineStyle);
  assert.equal(outline, 'solid');
  await page.emulateMedia({ forcedColors: 'none', colorScheme: 'dark', reducedMotion: 'reduce' });
  assert.deepEqual(await barriers(page), []);
  assert.equal(await page.evaluate(() =>
    getComputedStyle(document.querySelector('button.primary')).transitionDuration), '0s');
  assert.deepEqual(complaints, []);
});
