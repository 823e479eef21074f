// SPDX-License-Identifier: MIT
// Broken surfaces by formula, like those of real models: double scans, cracks, walls that meet.
import { sheetOf, torus } from './shapes.js';

/** Pseudo-random numbers from 0 to 1, the same each time. */
function chance() {
  let state = 1;
  return () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
}

/** Joins meshes to one mesh.
 * @param {Array<{ positions: ArrayLike<number>, indices: ArrayLike<number> }>} parts */
export function together(parts) {
  const positions = [];
  const indices = [];
  for (const part of parts) {
    const first = positions.length / 3;
    for (const value of Array.from(part.positions)) positions.push(value);
    for (const v of Array.from(part.indices)) indices.push(v + first);
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

const moved = ({ positions, indices }, by, scale = 1) =>
  ({ positions: positions.map((value, i) => scale * value + by[i % 3]), indices });

const corners = [[-1, -1, -1], [1, -1, -1], [-1, 1, -1], [1, 1, -1], [-1, -1, 1], [1, -1, 1],
  [-1, 1, 1], [1, 1, 1]];
const sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/** A box around a point, turned about z and then x. */
function box([x, y, z], size, turn = 0) {
  const [c, s, d, t] = [Math.cos(turn), Math.sin(turn), Math.cos(0.7 * turn), Math.sin(0.7 * turn)];
  const positions = corners.flatMap((corner) => {
    const [a, b, e] = corner.map((value, i) => 0.5 * value * size[i]);
    const across = s * a + c * b;
    return [x + c * a - s * b, y + d * across - t * e, z + t * across + d * e];
  });
  const indices = sides.flatMap(([p, q, r, u]) => [p, q, r, p, r, u]);
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

/** Oblique boxes that intersect each other. */
export const askewBoxes = () => together([
  box([0, 0, 0], [1, 1, 1], 0.3),
  box([0.5, 0.4, 0.6], [1, 0.5, 1.2], 0.9),
  box([-0.2, 0.5, 0.1], [2, 0.2, 0.2], -0.5),
]);

/** A box that stands in the top of a larger one. */
export const overlappingBoxes = () => together([
  box([0, 0, 0], [1, 1, 1]), box([0, 0, 0.5], [0.5, 0.5, 0.5])]);

/** Boxes, each inside the next larger one. */
export const nestedBoxes = (count = 5) => together(Array.from({ length: count }, (_, i) =>
  box([0.01 * i, 0, 0], [1 - 0.15 * i, 1 - 0.15 * i, 1 - 0.15 * i])));

/** Walls, a floor and a roof, each a thin box that intersects others. */
export const thinHouse = (wall = 0.02) => together([
  box([0, 0, 0], [2, 1.5, wall]),
  box([-1, 0, 0.5], [wall, 1.5, 1]), box([1, 0, 0.5], [wall, 1.5, 1]),
  box([0, -0.75, 0.5], [2, wall, 1]), box([0, 0.75, 0.5], [2, wall, 1]),
  box([0.2, 0, 0.5], [wall, 1.5, 1]),
  box([0, 0, 1], [2.2, 1.7, wall]),
]);

/** Many rings far from each other. */
export const manyBodies = (count = 20) => together(Array.from({ length: count }, (_, i) =>
  moved(torus({ columns: 24, rows: 12 }), [7 * (i % 5), 7 * Math.floor(i / 5), i % 3], 0.8)));

/** Two noisy scans of a surface, with different parts missing. */
export function doubledScan({ columns = 48, rows = 24, noise = 0.004 } = {}) {
  const next = chance();
  const scan = (/** @type {number} */ first) => {
    const { positions, indices } = torus({ columns, rows });
    return { positions: positions.map((value) => value + noise * (next() - 0.5)),
      indices: indices.filter((_, i) => Math.floor(i / 18) % 29 !== first) };
  };
  return together([scan(0), scan(7)]);
}

/** A torus in which no two triangles have a common corner: each corner is moved at random. */
export function cracked({ columns = 48, rows = 24, jitter = 0.002 } = {}) {
  const next = chance();
  const { positions, indices } = torus({ columns, rows });
  const loose = Array.from(indices, (v) => Array.from(positions.subarray(3 * v, 3 * v + 3),
    (value) => value + jitter * (next() - 0.5))).flat();
  return { positions: new Float32Array(loose), indices: indices.map((_, i) => i) };
}

/** A cube whose sides have different numbers of cells, so that their vertices along the cube's
 * edges do not match. */
export const tJunctions = () => together(sides.map(([p, q, , u], side) => {
  const cells = side + 3;
  return sheetOf(cells, (i, k) => corners[p].map((value, axis) => value
    + (i / cells) * (corners[q][axis] - value) + (k / cells) * (corners[u][axis] - value)));
}));

/** A Möbius strip. */
export function moebiusStrip(columns = 60, rows = 6) {
  const positions = [];
  const indices = [];
  for (let i = 0; i < columns; i += 1) {
    for (let k = 0; k <= rows; k += 1) {
      const [turn, across] = [(2 * Math.PI * i) / columns, k / rows - 0.5];
      const reach = 1 + across * Math.cos(turn / 2);
      positions.push(reach * Math.cos(turn), reach * Math.sin(turn), across * Math.sin(turn / 2));
      if (k === rows) continue;
      const at = (a, b) => (i + a < columns ? (i + a) * (rows + 1) + k + b : rows - k - b);
      indices.push(at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1));
    }
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

/** Random triangles in a cube of side 1. */
export function looseTriangles(count = 40, size = 0.6) {
  const next = chance();
  const positions = Array.from({ length: count }, () => {
    const middle = [next(), next(), next()];
    return [0, 1, 2].flatMap(() => middle.map((value) => value + size * (next() - 0.5)));
  }).flat();
  return { positions: new Float32Array(positions),
    indices: Uint32Array.from({ length: 3 * count }, (_, i) => i) };
}
