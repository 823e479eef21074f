// SPDX-License-Identifier: MIT
// Settings that the browser keeps: whatever is kept under their names, the page opens and works,
// and what does not fit is forgotten.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { settled, visit } from '../../support/browser_page.js';
import { damaged, names } from '../../support/settings.js';

const { page, complaints } = await visit(
  { hash: '#model=gear&vertices=100', unseen: true, viewport: { width: 800, height: 480 } });

/** Keeps texts under the names of settings, comes again, and returns what is kept then. */
async function comeAgain(texts) {
  await page.evaluate((all) => {
    for (const [name, text] of all) localStorage.setItem(`remesher.${name}`, text);
  }, texts);
  await page.reload();
  await settled(page);
  await page.click('[data-do=settings]');
  await page.click('#settings-close');
  return page.evaluate((all) => all.map(([name]) =>
    [name, localStorage.getItem(`remesher.${name}`)]), texts);
}

for (const text of damaged) {
  test(`the page opens whatever is kept: ${JSON.stringify(text.slice(0, 12))}`, async () => {
    const kept = await comeAgain(names.map((name) => [name, text]));
    assert.deepEqual(kept.filter(([, now]) => now === text).map(([name]) => name), []);
    assert.equal(await page.textContent('#result-count'), '100');
    assert.equal(await page.isVisible('#error'), false);
    assert.equal(await page.getAttribute('html', 'lang'), 'en');
    assert.equal(await page.locator('#samples optgroup').count(), 1, 'samples only');
    assert.deepEqual(complaints, []);
  });
}

test('dabs that are none are forgotten, also those of the model that opens', async () => {
  const { length } = await (await page.request.get(new URL('samples/gear.obj', page.url()).href))
    .body();
  const text = JSON.stringify({ key: `gear.obj ${length}`, dabs: [{ point: 'here' }] });
  assert.deepEqual(await comeAgain([['paint', text]]), [['paint', null]]);
  assert.equal(await page.textContent('#result-count'), '100');
  assert.deepEqual(complaints, []);
});

test('values that fit are there again', async () => {
  const fit = [['language', 'de'], ['recent', '["mine.obj"]'], ['keep-files', 'on'],
    ['single-keys', 'off']];
  assert.deepEqual(await comeAgain(fit), fit);
  assert.equal(await page.getAttribute('html', 'lang'), 'de');
  assert.equal(await page.isChecked('#keep-files'), true);
  assert.equal(await page.isChecked('#single-keys'), false);
  assert.match(await page.textContent('#samples'), /mine\.obj/);
});
