// SPDX-License-Identifier: MIT
// The targets of `npm run fuzz`, without libFuzzer and sanitizers: what it would begin with, and
// changed copies. npm run fuzz goes on from there for as long as it is told.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { makeCorpora, writeInputs } from '../fuzz/corpora.js';
import { root } from '../support/tree.js';

const program = join(root, 'build/test/fuzz_replay');
const folder = mkdtempSync(join(tmpdir(), 'remesher-fuzz-'));
after(() => rmSync(folder, { recursive: true }));

const replay = (...words) => spawnSync(program, words.map(String),
  { encoding: 'utf8', timeout: 120_000, stdio: ['ignore', 'pipe', 'pipe'] });

/** Changed copies of each input: what a second or two are enough for. */
const copies = { glb: 10, gltf: 20, obj: 50, off: 30, ply: 20, stl: 30, msh: 30, vtu: 30, '3mf': 30,
  builder: 200, remesh: 1, repair: 0 };

test('a target that there is not is refused', () => {
  assert.equal(replay('none', 1, join(folder, 'kept')).status, 2);
});

for (const [name, { inputs }] of Object.entries(await makeCorpora())) {
  test(`${name}: nothing breaks`, () => {
    const paths = writeInputs(join(folder, name), inputs);
    const { status, stdout, stderr } =
      replay(name, copies[name], join(folder, 'kept'), ...paths);
    assert.equal(status, 0, stderr);
    assert.equal(stdout, `${inputs.length * (1 + copies[name])} inputs\n`);
  });
}
