// SPDX-License-Identifier: MIT

// The option that was probably meant by a name that is not known.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { nearest } from '../../dist/base/nearest.js';

const flags = ['--vertices', '--faces', '--ratio', '--edge-length', '--repair', '--output',
  '--root', '--cage', '--units', '--lod-files'];

test('letters that were left out, doubled or exchanged', () => {
  for (const [given, meant] of [['--vertexes', '--vertices'], ['--reapir', '--repair'],
    ['--outptu', '--output'], ['--rato', '--ratio'], ['--facess', '--faces']]) {
    assert.equal(nearest(given, flags), meant);
  }
});

test('the beginning of a name', () => {
  assert.equal(nearest('--edge', flags), '--edge-length');
  assert.equal(nearest('--fa', ['--units', '--fast']), undefined, 'two letters are no word');
});

test('words of other tools, as flags and as keys', () => {
  for (const given of ['--polycount', '--target-faces', '--tris']) {
    assert.equal(nearest(given, flags), '--faces');
  }
  assert.equal(nearest('targetFaces', ['vertices', 'faces']), 'faces');
  assert.equal(nearest('tolerance', ['vertices', 'maxError']), 'maxError');
  assert.equal(nearest('--watertight', flags), '--repair');
});

test('a word that is like no name has no nearest', () => {
  for (const given of ['--smooth', '--decorate', '--zzzzzzzz', `--${'vertices'.repeat(50)}`]) {
    assert.equal(nearest(given, flags), undefined);
  }
});
