// SPDX-License-Identifier: MIT
// What the page keeps in the browser is read in one place, and what does not fit is forgotten;
// tests/integration/page/web_kept.test.js opens the page with each damaged value.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Setting } from '../../web/base/memory.js';
import { areDabs } from '../../web/model/density.js';
import { damaged, names, sources } from '../support/settings.js';

test('all settings are read in one place', () => {
  assert.deepEqual(sources.filter(([, text]) => /localStorage|sessionStorage/.test(text))
    .map(([file]) => file), ['web/base/memory.js']);
  assert.deepEqual([...names].sort(), ['expert', 'guides', 'keep-files', 'language', 'paint',
    'recent', 'single-keys', 'units', 'welcome']);
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
