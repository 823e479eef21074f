// SPDX-License-Identifier: MIT
// Twenty models made by rule, and five sets of options, for holding engines together. The models
// are made once, in Node, and served as bytes: engines may differ in the last bit of a sine.
import { glbBytes, objText, torus as plainTorus } from '../support/shape_files.js';
import { offText, sheet, signetRing, torus } from '../support/shapes.js';

/** A grid of (m + 1) × (n + 1) points, or closed around in one or both directions, as OBJ. */
function grid(m, n, point, { closed = [false, false] } = {}) {
  const [columns, rows] = [closed[0] ? m : m + 1, closed[1] ? n : n + 1];
  const positions = [];
  const triangles = [];
  const at = (i, j) => (i % columns) * rows + (j % rows);
  for (let i = 0; i < columns; i += 1) {
    for (let j = 0; j < rows; j += 1) positions.push(point(i / m, j / n));
  }
  for (let i = 0; i < m; i += 1) {
    for (let j = 0; j < n; j += 1) {
      triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)],
        [at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  }
  return { positions, triangles };
}

const turn = 2 * Math.PI;
const around = (u, radius, height) =>
  [radius * Math.cos(turn * u), radius * Math.sin(turn * u), height];
const around1 = { closed: [true, false] };

const saddle = grid(20, 20, (u, v) => [u, v, (u - 0.5) ** 2 - (v - 0.5) ** 2]);
const waves = grid(30, 16, (u, v) => [2 * u, v, 0.1 * Math.sin(9 * u) * Math.cos(7 * v)]);
const tube = grid(24, 12, (u, v) => around(u, 1, 3 * v), around1);
const cone = grid(24, 12, (u, v) => around(u, 1.05 - v, 2 * v), around1);
const vase = grid(32, 20, (u, v) => around(u, 1 + 0.4 * Math.sin(6 * v), 2.5 * v), around1);
const globe = grid(28, 14, (u, v) =>
  around(u, Math.sin(Math.PI * (v * 0.9 + 0.05)), Math.cos(Math.PI * (v * 0.9 + 0.05))), around1);
const steps = grid(24, 12, (u, v) => [2 * u, v, Math.floor(4 * u) / 4]);
const roof = grid(20, 10, (u, v) => [2 * u, v, Math.abs(u - 0.5)]);
const star = grid(40, 10, (u, v) => around(u, 1 + 0.3 * Math.cos(5 * turn * u), 2 * v), around1);
const knot = grid(60, 10, (u, v) => {
  const [p, t] = [turn * u, turn * v];
  const reach = 2 + 0.7 * Math.cos(3 * p) + 0.3 * Math.cos(t);
  const height = 0.7 * Math.sin(3 * p) + 0.3 * Math.sin(t);
  return [reach * Math.cos(2 * p), reach * Math.sin(2 * p), height];
}, { closed: [true, true] });

/** Twice the same, apart from each other. */
const pair = ({ positions, triangles }) => ({
  positions: [...positions, ...positions.map(([x, y, z]) => [x + 9, y, z])],
  triangles: [...triangles, ...triangles.map((t) => t.map((v) => v + positions.length))],
});

/** By name: the bytes of a file. */
export const models = {
  'torus.off': offText(torus({ columns: 32, rows: 16 })),
  'thin-torus.off': offText(torus({ columns: 48, rows: 8, tube: 0.2 })),
  'fat-torus.off': offText(torus({ columns: 24, rows: 24, tube: 1.6 })),
  'ring.off': offText(signetRing()),
  'sheet.off': offText(sheet(18)),
  'small-sheet.off': offText(sheet(7)),
  'saddle.obj': objText(saddle),
  'waves.obj': objText(waves),
  'tube.obj': objText(tube),
  'cone.obj': objText(cone),
  'vase.obj': objText(vase),
  'globe.obj': objText(globe),
  'steps.obj': objText(steps),
  'roof.obj': objText(roof),
  'star.obj': objText(star),
  'knot.obj': objText(knot),
  'pair.obj': objText(pair(plainTorus(16, 8))),
  'plain.glb': glbBytes(plainTorus(24, 12)),
  'roof.glb': glbBytes(roof),
  'knot.glb': glbBytes(knot),
};

export const optionSets = [
  { ratio: 0.6 },
  { ratio: 1.2, adaptivity: 1 },
  { ratio: 0.8, scheme: 'rounds' },
  { ratio: 0.5, maxError: 2 },
  { ratio: 0.7, boundary: 'keep', featureAngle: 20, splitObtuse: true },
];

/** What is asked of an engine: every model with every set of options. */
export const jobs = Object.keys(models).flatMap((name) =>
  optionSets.map((options) => ({ name, options })));
