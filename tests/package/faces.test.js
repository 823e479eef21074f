// SPDX-License-Identifier: MIT
// A budget in triangles, or in quads.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remesh, remeshScene } from 'remesher';
import { checkOptions } from 'remesher/options';

import { sheet, torus } from '../support/shapes.js';

const ring = torus({ columns: 24, rows: 12 });
const draft = { quality: 'draft' };
const trianglesOf = ({ output, lods = [] }) => [output, ...lods.map((level) => level.output)]
  .map(({ triangles }) => triangles);

test('a closed surface has exactly so many triangles, or one less where the number is odd',
  async () => {
    for (const prefer of ['even', 'shape']) {
      for (const faces of [300, 301]) {
        const { report, mesh } = await remesh(ring, { faces, prefer, ...draft });
        assert.deepEqual(trianglesOf(report), [300], prefer);
        assert.equal(mesh.indices.length, 900);
      }
    }
  });

test('an open surface comes as near as its boundary lets it, and not beyond', async () => {
  for (const faces of [200, 333]) {
    const { report } = await remesh(sheet(16), { faces, ...draft });
    const { triangles } = report.output;
    assert.ok(triangles <= faces && triangles >= 0.985 * faces, `${triangles} of ${faces}`);
    assert.deepEqual(report.warnings, []);
  }
});

test('quads are counted as quads', async () => {
  const { report } = await remesh(torus(), { faces: 300, quads: true, ...draft });
  const { count } = report.output.quads;
  assert.ok(count <= 300 && count >= 288, `${count} quads`);
  assert.deepEqual(report.warnings, []);
});

test('meshes share a budget, and levels take shares of it', async () => {
  const parts = [{ mesh: ring }, { mesh: torus({ columns: 24, rows: 12, radius: 6, tube: 1 }) }];
  const { report } = await remeshScene(parts, { faces: 800, lods: [0.5, 0.25], ...draft });
  assert.deepEqual(trianglesOf(report), [800, 400, 200]);
});

test('a budget that no surface like this can keep is said', async () => {
  const { report } = await remesh(ring, { faces: 8, ...draft });
  assert.ok(report.output.triangles > 8);
  assert.ok(report.warnings.some(({ code }) => code === 'TOO_FEW_FACES'));
});

test('a budget is a target like others: two contradict each other', () => {
  assert.throws(() => checkOptions({ faces: 100, vertices: 50 }), { code: 'INVALID_OPTION' });
  assert.throws(() => checkOptions({ faces: 0 }), { code: 'INVALID_OPTION' });
});
