// SPDX-License-Identifier: MIT
// What a second compiler and a linter say about the C++ of the core: four minutes of a core, which
// `npm run lint` spends and `npm test` does not.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { clangTidy, complaintsOf, gcc } from '../support/cpp_checks.js';
import { agreeingVersion } from '../support/llvm.js';
import { filesUnder } from '../support/tree.js';

test('C++ passes clang-tidy', async (t) => {
  if (!agreeingVersion(t, 'clang-tidy')) return;
  // But for a library's implementation, which is not ours.
  const files = filesUnder('src', /(?<!tinygltf)\.cpp$/);
  assert.equal(await complaintsOf(clangTidy, files), '');
});

test('C++ compiles with g++ without a warning', async () => {
  // What is built with it: unit tests and fuzzers are clang++'s, which has warned of them by then.
  assert.equal(await complaintsOf(gcc, filesUnder('src', /\.cpp$/)), '');
});
