// SPDX-License-Identifier: MIT
// The README is short, and its figures are those of runs; tests/integration/readme.test.js runs its
// programs and commands, and follows its links.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { figuresOfReadme } from '../support/readme_figures.js';
import { readText } from '../support/tree.js';

const text = readText('README.md');

test('it is short, and every block of code is six lines at most', () => {
  const words = text.split(/\s+/).filter(Boolean).length;
  assert.ok(words >= 600 && words <= 800, `${words} words`);
  for (const [, block] of text.matchAll(/```\w+\n([^]*?)```/g)) {
    const lines = block.trim().split('\n').filter((line) => line && !/^<\/?script/.test(line));
    assert.ok(lines.length <= 6, block);
  }
});

test('its figures are those of runs, and of the papers that it leads to', async () => {
  for (const figure of await figuresOfReadme()) {
    assert.ok(text.replace(/\s+/g, ' ').includes(figure), figure);
  }
  const quoted = { 'docs/textures.md': ['0.90'], 'docs/quality.md': ['0.150'],
    'docs/guides/quads.md': ['3,010', '28'],
    'docs/javascript.md': ['329 kB', '15 kB', '873 kB', '18 kB'],
    'docs/sizes.md': ['0.6', '0.4', '1.9'] };
  for (const [paper, figures] of Object.entries(quoted)) {
    for (const figure of figures) {
      assert.ok(text.includes(figure) && readText(paper).includes(figure), `${paper}: ${figure}`);
    }
  }
  assert.ok(text.includes(`${329 + 15} kB for arrays`));
});
