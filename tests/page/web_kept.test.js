// SPDX-License-Identifier: MIT
// Settings that the browser keeps: whatever is kept under their names, the page opens and works,
// and what does not fit is forgotten.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Setting } from '../../web/base/memory.js';
import { areDabs } from '../../web/model/density.js';
import { settled, visit } from '../support/browser_page.js';
import { filesUnder, readText } from '../support/tree.js';

const sources = filesUnder('web', /\.js$/).map((file) => [file, readText(file)]);

/** The names of all settings. */
const names = sources.flatMap(([, text]) =>
  Array.from(text.matchAll(/(?:new Setting|switchSetting)\('([\w-]+)'/g), ([, name]) => name));

const damaged = ['', 'x{', 'null', '[]', '{}', '[null]', '{"key":"x"}', '"de"', '1e999', 'true',
  '__proto__', 'constructor', '\0', `"${'x'.repeat(2 ** 19)}"`, `[${'0,'.repeat(2 ** 18)}0]`];

test('all settings are read in one place', () => {
  assert.deepEqual(sources.filter(([, text]) => /localStorage|sessionStorage/.test(text))
    .map(([file]) => file), ['web/base/memory.js']);
  assert.deepEqual([...names].sort(), ['expert', 'keep-files', 'language', 'paint', 'recent',
    'single-keys', 'units', 'welcome']);
});

test('a value is there again; one that does not fit is forgotten', () => {
  const kept = new Map();
  globalThis.localStorage = { getItem: (key) => kept.get(key) ?? null,
    setItem: (key, text) => kept.set(key, text), removeItem: (key) => kept.delete(key) };
  try {
    const setting = new Setting('size', (text) => {
      if (text === 'throw') throw new Error(text);
      return Number(text) > 0 ? Number(text) : undefined;
    });
    assert.equal(setting.recall(), undefined);
    setting.remember('3');
    assert.equal(setting.recall(), 3);
    for (const text of [...damaged.filter((other) => !(Number(other) > 0)), 'throw', '-1']) {
      kept.set('remesher.size', text);
      assert.equal(setting.recall(), undefined, text.slice(0, 20));
      assert.equal(kept.size, 0, text.slice(0, 20));
    }
    setting.remember('9'.repeat(2 ** 22));
    assert.equal(kept.size, 0, 'too long');
  } finally {
    delete globalThis.localStorage;
  }
});

test('dabs are told from other lists', () => {
  const dab = { point: [1, 2, 3], radius: 0.5, strength: -1 };
  assert.ok(areDabs([]) && areDabs([dab, dab]));
  for (const wrong of [null, {}, 'dabs', [null], [{}], [{ ...dab, point: [1, 2] }],
    [dab, { ...dab, point: [1, 2, '3'] }], [{ ...dab, radius: 0 }], [{ ...dab, strength: null }],
    [{ ...dab, radius: Infinity }]]) {
    assert.equal(areDabs(wrong), false, JSON.stringify(wrong));
  }
});

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
