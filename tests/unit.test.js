// SPDX-License-Identifier: MIT
// The C++ unit tests, built natively with sanitizers: each of their cases is a case here.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';

import { root } from './support/tree.js';

const unescaped = (text) => text.replace(/&(quot|lt|gt|apos|amp);/g,
  (_, name) => ({ quot: '"', lt: '<', gt: '>', apos: "'", amp: '&' })[name]);

/** Name and verdict of every case in doctest's XML. */
function casesIn(xml) {
  return [...xml.matchAll(/<TestCase name="([^"]*)"[^>]*>(.*?)<\/TestCase>/gs)].map(
    ([, name, body]) => ({
      name: unescaped(name),
      passed: /test_case_success="true"/.test(body),
      body: unescaped(body.replace(/^\s*<(Info|OverallResults).*$/gm, '').trim()),
    }));
}

test('C++', async (context) => {
  const { stdout, stderr, status } = spawnSync(join(root, 'build/test/unit_tests'), ['-r=xml'],
    { cwd: root, encoding: 'utf8', maxBuffer: 2 ** 28 });
  const cases = casesIn(stdout);
  for (const { name, passed, body } of cases) {
    await context.test(name, () => assert.ok(passed, body));
  }
  assert.ok(cases.length > 0, 'there are cases');
  assert.equal(status, 0, `the runner ended early:\n${stderr}`);
});
