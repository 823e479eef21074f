// SPDX-License-Identifier: MIT
// The same input gives the same bytes: again, after other work, in another process, in code
// that is optimised earlier.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { remesh } from 'remesher';

import { root } from '../support/tree.js';
import { sheet, torus } from '../support/shapes.js';

const shapes = { torus, sheet };
const runs = Object.keys(shapes).flatMap((shape) =>
  ['best', 'rounds'].map((scheme) => ({ shape, scheme })));

async function digest({ shape, scheme }) {
  const { mesh } = await remesh(shapes[shape](), { scheme, vertices: 1500 });
  return createHash('sha256').update(mesh.positions).update(mesh.indices).digest('hex');
}

// Called as a program: one run's digest.
const self = fileURLToPath(import.meta.url);
const [, , shape, scheme] = process.argv;
if (shape) {
  process.stdout.write(await digest({ shape, scheme }));
} else {
  for (const run of runs) {
    test(`${run.scheme} on a ${run.shape}`, async () => {
      const first = await digest(run);
      await remesh(shapes.torus({ columns: 20, rows: 10 }), { vertices: 77 });
      assert.equal(await digest(run), first, 'again, after other work');
      const other = execFileSync(process.execPath,
        ['--wasm-tiering-budget=1', self, run.shape, run.scheme],
        { cwd: root, encoding: 'utf8', env: { ...process.env, NODE_OPTIONS: '' } });
      assert.equal(other, first, 'in another process, optimised at once');
    });
  }
}
