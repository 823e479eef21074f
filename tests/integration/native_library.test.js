// SPDX-License-Identifier: MIT
// The core as a native library: installed, found by a stranger's CMake, and run.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { readText, root } from '../support/tree.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-native-'));
after(() => rmSync(folder, { recursive: true }));
const run = (/** @type {string} */ program, ...words) =>
  execFileSync(program, words, { cwd: root, encoding: 'utf8', timeout: 300_000 });

test('a program of ten lines finds the installed library and remeshes with it', () => {
  const [, compiler] = /** @type {RegExpMatchArray} */ (
    readText('build/test/CMakeCache.txt').match(/^CMAKE_CXX_COMPILER:\w+=(.*)$/m));
  const [library, build] = [join(folder, 'library'), join(folder, 'build')];
  run('cmake', '--install', 'build/test', '--prefix', library);
  run('cmake', '-G', 'Ninja', '-S', 'tests/support/native_program', '-B', build,
    `-DCMAKE_PREFIX_PATH=${library}`, `-DCMAKE_CXX_COMPILER=${compiler}`);
  run('ninja', '-C', build);
  // Euler: a closed surface of genus 0 has twice as many triangles as vertices, less four.
  assert.equal(run(join(build, 'native_program')), '100 vertices, 196 triangles\n');
});

test('the headers that are installed are those that remesher.h includes', () => {
  const included = new Set(['remesher.h']);
  for (const header of included)
    for (const [, name] of readText(`src/${header}`).matchAll(/^#include "(.*)"$/gm))
      included.add(name);
  const installed = join(folder, 'library/include/remesher');
  const found = readdirSync(installed, { recursive: true }).map(String)
    .filter((name) => name.endsWith('.h'));
  assert.deepEqual(found.sort(), [...included].sort());
});
