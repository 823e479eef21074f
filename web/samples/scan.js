// SPDX-License-Identifier: MIT
// A scanned relief by formula: an open surface with a ragged border and a hole, whose points are as
// uneven as a scanner's, with a little noise.

const columns = 84;
const side = 2;

/** A pseudo-random number between 0 and 1, fixed by i and j. @param {number} i @param {number} j */
function chance(i, j) {
  const value = Math.sin(12.9898 * i + 78.233 * j) * 43758.5453;
  return value - Math.floor(value);
}

/** @param {number} x @param {number} y */
function relief(x, y) {
  const r = Math.hypot(x, y);
  const rings = 0.09 * Math.cos(9 * r) * Math.exp(-r * r);
  const petals = 0.12 * Math.cos(5 * Math.atan2(y, x)) * r * r * Math.exp(-2.5 * r * r);
  return 0.5 * Math.exp(-1.6 * r * r) + rings + petals;
}

/** Whether the scanner saw the place. @param {number} x @param {number} y */
function isSeen(x, y) {
  const turn = Math.atan2(y, x);
  const border = 0.86 + 0.06 * Math.sin(3 * turn) + 0.03 * Math.sin(11 * turn);
  return Math.hypot(x, y) < border && Math.hypot(x - 0.34, y - 0.2) > 0.09;
}

/** A grid point, randomly moved. @param {number} i @param {number} j */
function pointAt(i, j) {
  const spread = 0.62 * side / columns;
  const x = side * (i / columns - 0.5) + spread * (chance(i, j) - 0.5);
  const y = side * (j / columns - 0.5) + spread * (chance(j, i + 500) - 0.5);
  return [x, y, relief(x, y) + 0.0035 * (chance(i + 900, j) - 0.5)];
}

/** @returns {import('./gear.js').PolygonMesh} */
export function scan() {
  /** @type {Map<string, number>} */
  const numbers = new Map();
  /** @type {number[][]} */
  const positions = [];
  const number = (/** @type {number} */ i, /** @type {number} */ j) => {
    const key = `${i} ${j}`;
    if (!numbers.has(key)) numbers.set(key, positions.push(pointAt(i, j)) - 1);
    return numbers.get(key) ?? 0;
  };
  const cells = [];
  for (let i = 0; i < columns; ++i) {
    for (let j = 0; j < columns; ++j) {
      const [x, y] = pointAt(i, j);
      if (!isSeen(x, y)) continue;
      const [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
      cells.push([a, b, c], [a, c, d]);
    }
  }
  return { positions, cells };
}
