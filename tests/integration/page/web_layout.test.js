// SPDX-License-Identifier: MIT
// The page in other languages and in windows of other widths: nothing is cut off or covered.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { barriers, beside } from '../../support/barriers.js';
import { drop, opened, settled, visit } from '../../support/browser_page.js';

const { page, complaints } = await visit(
  { hash: '#model=gear&vertices=500', unseen: true, viewport: { width: 900, height: 560 } });

test('other languages: all in them, no barriers, no sideways scrolling', async () => {
  // A sheet with a triangle turned over, asked for more than it can: a border, a fault, an error.
  await drop(page, { 'sheet.obj': ['v 0 0 0', 'v 1 0 0', 'v 1 1 0', 'v 0 1 0', 'v 2 0 0',
    'f 1 2 3', 'f 1 3 4', 'f 2 3 5', ''].join('\n') });
  await opened(page, 'sheet.obj');
  for (const [language, word, chip, fault] of [
    ['de', 'Neu vernetzen', /offene Kanten/, 'umgedreht'],
    ['fr', 'Remailler', /arêtes de bord/, 'retournés']]) {
    await page.click('[data-do=settings]');
    await page.selectOption('#language', language);
    await page.click('#settings-close');
    await page.waitForSelector(`form button:text-is("${word}")`);
    assert.equal(await page.getAttribute('html', 'lang'), language);
    assert.match(await page.textContent('#landmark-boundary'), chip);
    // What the core says is said in the language, and stays below in its own words.
    const said = page.locator('#result .notice', { hasText: fault });
    assert.match(await said.locator('[lang=en]').textContent(), /turned over/);
    assert.deepEqual(await barriers(page), []);
  }
  await page.click('[data-do=settings]');
  await page.selectOption('#language', 'en');
  await page.click('#settings-close');
});

test('360 pixels are wide enough, from right to left, too', async () => {
  for (const direction of ['ltr', 'rtl']) {
    await page.evaluate((dir) => { document.documentElement.dir = dir; }, direction);
    for (const width of [360, 900]) {
      await page.setViewportSize({ width, height: 640 });
      await page.waitForTimeout(100);
      assert.ok(await beside(page) <= 0, `${direction} at ${width}`);
      const heights = await page.locator('.field label').evaluateAll((labels) =>
        labels.map((label) => label.clientHeight));
      assert.ok(heights.length > 8 && Math.max(...heights) < 70, `labels ${heights.join(' ')}`);
    }
  }
  await page.evaluate(() => { document.documentElement.dir = 'ltr'; });
});

/** The lists whose longest choice is cut off. */
const cutLists = () => page.locator('.field select:visible').evaluateAll((lists) =>
  lists.filter((list) => {
    const copy = list.cloneNode(true);
    copy.style.cssText = 'position: absolute; width: max-content; min-width: 0; max-width: none';
    list.parentElement.append(copy);
    const isCut = copy.offsetWidth > list.offsetWidth + 1;
    copy.remove();
    return isCut;
  }).map(({ id }) => id));

test('no choice of a list is cut off, in any language, on a phone or a wide screen', async () => {
  await page.selectOption('#option-repair', 'auto');
  for (const language of ['de', 'fr', 'en']) {
    await page.click('[data-do=settings]');
    await page.selectOption('#language', language);
    await page.click('#settings-close');
    await page.selectOption('#option-repair', 'auto');
    for (const width of [390, 1200]) {
      await page.setViewportSize({ width, height: 640 });
      assert.deepEqual(await cutLists(), [], `${language} at ${width}`);
    }
  }
  await page.selectOption('#option-repair', '');
  await settled(page);
});

/** Where an element is in the window. */
const box = (selector) => page.locator(selector).evaluate((element) => {
  const { left, right, top, bottom } = element.getBoundingClientRect();
  return { left, right, top, bottom };
});

test('what explains the picture covers no tools, on how many lines they ever stand', async () => {
  await page.click('[data-shading=distance]');
  await page.waitForSelector('#legend:not([hidden])');
  for (const width of [1300, 1024, 800, 390]) {
    await page.setViewportSize({ width, height: 768 });
    assert.ok((await box('#legend')).bottom <= (await box('.toolbar')).top, `at ${width}`);
  }
  assert.deepEqual(complaints, []);
});
