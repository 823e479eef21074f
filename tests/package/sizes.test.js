// SPDX-License-Identifier: MIT
// Whole runs of both schemes: the edges are as long as they are asked to be, where they are asked.
// What the sizes are made of has unit tests; here, where code is optimised, a law is asked of as
// many counts as it takes to hold by more than luck.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remesh } from 'remesher';

import { sheetOf, signetRing, torus } from '../support/shapes.js';

const schemes = /** @type {const} */ (['best', 'rounds']);
const run = (mesh, options) => remesh(mesh, { ...options, worker: false });

/** The corners of every triangle. */
function* cornersOf({ positions, indices }) {
  const point = (v) => positions.subarray(3 * v, 3 * v + 3);
  for (let i = 0; i < indices.length; i += 3) yield [0, 1, 2].map((k) => point(indices[i + k]));
}

/** x⁶ + y⁶ + z⁶ = 1: a cube of flat sides whose edges and corners are rounded. */
function pillow(cells) {
  const [positions, indices] = [[], []];
  for (let side = 0; side < 6; side += 1) {
    const sheet = sheetOf(cells, (i, k) => {
      const [u, v] = [2 * i / cells - 1, 2 * k / cells - 1];
      const around = side < 3 ? [1, u, v] : [-1, v, u];
      const [x, y, z] = [0, 1, 2].map((axis) => around[(axis + side) % 3]);
      const reach = (x ** 6 + y ** 6 + z ** 6) ** (1 / 6);
      return [x / reach, y / reach, z / reach];
    });
    const first = positions.length / 3;
    positions.push(...sheet.positions);
    indices.push(...sheet.indices.map((v) => first + v));
  }
  return { positions: new Float64Array(positions), indices: new Uint32Array(indices) };
}

/** A sheet of side 2, full of bumps as steep as 45°. */
const bumps = () => sheetOf(64, (i, k) => {
  const [x, y] = [i / 32 - 1, k / 32 - 1];
  return [x, y, 0.05 * Math.sin(20 * x) * Math.cos(20 * y)];
});

/** `much` right of x = border, 1 left of it. */
const densityOf = ({ positions }, border, much) =>
  Float32Array.from({ length: positions.length / 3 }, (_, v) =>
    (positions[3 * v] > border ? much : 1));

/** How many times as dense vertices are right of x = border as left of it, beyond a way on which
 * the edges grow. */
function densityRatio(mesh, border, way) {
  const [vertices, covered] = [[0, 0], [0, 0]];
  for (const [a, b, c] of cornersOf(mesh)) {
    const x = (a[0] + b[0] + c[0]) / 3;
    if (x > border - way && x < border) continue;
    const side = x < border ? 0 : 1;
    const [p, q] = [b, c].map((corner) => corner.map((value, k) => value - a[k]));
    vertices[side] += 0.5;  // of a closed mesh, about: it has twice as many triangles
    covered[side] += Math.hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
      p[0] * q[1] - p[1] * q[0]) / 2;
  }
  return vertices[1] / covered[1] / (vertices[0] / covered[0]);
}

function meanEdge(mesh) {
  let sum = 0;
  for (const [a, b, c] of cornersOf(mesh)) {
    for (const [p, q] of [[a, b], [b, c], [c, a]]) {
      sum += Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
  }
  return sum / mesh.indices.length;
}

for (const scheme of schemes) {
  test(`a density of 9 to 1 gives vertices in the ratio 9 to 1 (${scheme})`, async () => {
    const body = torus({ columns: 72, rows: 36, tube: 1 });
    const density = densityOf(body, 1.5, 9);
    let ratio = 0;
    // By the seed of annealing one number gives 7.8 to 10.4, four together 8.5 to 9.3.
    for (const vertices of [2000, 2200, 2400, 2600]) {
      const { mesh, report } = await run(body, { scheme, vertices, density, adaptivity: 0 });
      // Gradation lets edges of 0.13 grow to 0.39 at a slope of 0.24, over a way of 1.1.
      ratio += densityRatio(mesh, 1.5, 1.1) / 4;
      assert.ok(report.output.minAngle.mean >= 52, `${report.output.minAngle.mean}°`);
    }
    assert.ok(ratio > 0.9 * 9 && ratio < 1.1 * 9, `${ratio}`);
  });

  test(`edges are as long as asked for on average, even or graded (${scheme})`, async () => {
    const body = pillow(20);
    for (const adaptivity of [0, 1]) {
      for (const much of [1, 9]) {
        const density = densityOf(body, 0, much);
        const { mesh } = await run(body, { scheme, adaptivity, density, edgeLength: 0.3 });
        const mean = meanEdge(mesh);
        assert.ok(Math.abs(mean / 0.3 - 1) < 0.05, `${mean}, ${adaptivity}, ${much}`);
      }
    }
  });

  test(`sizes that follow curvature lower the error at the same count (${scheme})`, async () => {
    const body = pillow(32);
    // By the seed of annealing one number gains 1.28 to 1.58 times, six together 1.38 to 1.55.
    // Nothing is annealed in rounds, which take three times as long: each gains 1.36 to 1.51.
    const isAnnealed = scheme === 'best';
    const numbers = isAnnealed ? [1950, 2000, 2050, 2100, 2150, 2200] : [2000, 2100];
    let [before, after] = [0, 0];
    for (const vertices of numbers) {
      const even = await run(body, { scheme, vertices, adaptivity: 0 });
      const graded = await run(body, { scheme, vertices, adaptivity: 1 });
      before += even.report.fidelity.rms;
      after += graded.report.fidelity.rms;
      assert.ok(graded.report.output.minAngle.mean >= 52);
    }
    assert.ok(after < before / 1.3, `${before / after} times`);
  });
}

test('the report’s criteria keep no density from bumps smaller than triangles', async () => {
  const body = bumps();
  const { mesh } = await run(body, { scheme: 'rounds', vertices: 2400, adaptivity: 0,
    density: densityOf(body, 0, 9) });
  // Edges of 0.045 grow to 0.135 over a way of 0.4.
  const ratio = densityRatio(mesh, 0, 0.4);
  assert.ok(ratio > 0.9 * 9 && ratio < 1.1 * 9, `${ratio}`);
});

test('sizes that follow curvature lower the largest distance, too', async () => {
  const mesh = signetRing();
  const found = { rms: 0, hausdorff: 0 }, plain = { rms: 0, hausdorff: 0 };
  // The largest distance of one number gains 0.998 to 2.7 times by luck, 1.66 on average; that of
  // six is less than 1.5 one time of ten.
  const numbers = Array.from({ length: 12 }, (_, i) => 3000 + 25 * i);
  for (const vertices of numbers) {
    const even = await run(mesh, { vertices, adaptivity: 0 });
    const adapted = await run(mesh, { vertices, adaptivity: 1 });
    assert.ok(adapted.report.output.minAngle.mean >= 52);
    for (const key of ['rms', 'hausdorff']) {
      found[key] += adapted.report.fidelity[key];
      plain[key] += even.report.fidelity[key];
    }
  }
  assert.ok(plain.hausdorff / numbers.length < 0.2, 'even triangles lose no part');
  assert.ok(found.rms < plain.rms / 1.1, `${found.rms} against ${plain.rms}`);
  assert.ok(found.hausdorff < plain.hausdorff / 1.5, `${found.hausdorff}, ${plain.hausdorff}`);
});

test('a thin part keeps both its sides, whatever the number', async () => {
  // Its tube, at the thinnest 1.3 % of the diagonal in radius, is six or seven edges around.
  for (let vertices = 4395; vertices < 4520; vertices += 17) {
    const { report } = await run(signetRing(), { vertices, adaptivity: 0 });
    assert.ok(report.fidelity.hausdorff < 1.3 / 2, `${vertices}: ${report.fidelity.hausdorff} %`);
  }
});

test('edges of a body without a density are as long as asked for on average', async () => {
  const mean = meanEdge((await run(torus(), { edgeLength: 0.1 })).mesh);
  assert.ok(Math.abs(mean / 0.1 - 1) < 0.05, `${mean}`);
});
