// SPDX-License-Identifier: MIT
// Whether two surfaces are the same up to rounding: the same places, and the same triangles between
// them, whatever their order.
import { diagonalOf, placeOf } from '../independent/surface.js';

/** @typedef {import('../independent/surface.js').Surface} Surface */

/** Places by cells of a grid, to find those near another. */
class Grid {
  constructor(surface, size) {
    this.surface = surface;
    this.size = size;
    this.cells = new Map();
    for (let v = 0; v < surface.positions.length / 3; v += 1) {
      const key = this.#cell(placeOf(surface, v)).join();
      this.cells.set(key, [...this.cells.get(key) ?? [], v]);
    }
  }

  #cell(p) {
    return Array.from(p, (x) => Math.floor(x / this.size));
  }

  /** The nearest place within the size of a cell; −1: none. */
  nearest(p) {
    const [x, y, z] = this.#cell(p);
    let best = { v: -1, far: this.size };
    for (let i = 0; i < 27; i += 1) {
      const key = [x + (i % 3) - 1, y + (Math.floor(i / 3) % 3) - 1, z + Math.floor(i / 9) - 1];
      for (const v of this.cells.get(key.join()) ?? []) {
        const q = placeOf(this.surface, v);
        const far = Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        if (far <= best.far) best = { v, far };
      }
    }
    return best.v;
  }
}

/** The distance to the nearest place, however far. */
function nearestOf({ positions }, p) {
  let best = Infinity;
  for (let i = 0; i < positions.length; i += 3) {
    best = Math.min(best, Math.hypot(positions[i] - p[0], positions[i + 1] - p[1],
      positions[i + 2] - p[2]));
  }
  return best;
}

/** A triangle's corners, its smallest first, in its turn. */
function turned([a, b, c]) {
  if (a <= b && a <= c) return [a, b, c];
  return b <= c ? [b, c, a] : [c, a, b];
}

const keysOf = ({ triangles }, numbers = (v) => v) => {
  const keys = new Map();
  for (let i = 0; i < triangles.length; i += 3) {
    const key = turned([...triangles.subarray(i, i + 3)].map(numbers)).join();
    keys.set(key, (keys.get(key) ?? 0) + 1);
  }
  return keys;
};

/**
 * The differences in words; none: the same.
 * @param {Surface} one @param {Surface} other @param {number} rounding share of the diagonal
 */
export function differences(one, other, rounding) {
  const grid = new Grid(one, rounding * diagonalOf(one));
  const count = one.positions.length / 3;
  if (other.positions.length / 3 !== count || one.triangles.length !== other.triangles.length) {
    return [`${count} vertices and ${one.triangles.length / 3} triangles; ${
      other.positions.length / 3} and ${other.triangles.length / 3}`];
  }
  const numbers = Array.from({ length: count }, (_, v) => grid.nearest(placeOf(other, v)));
  const missing = numbers.flatMap((v, i) => (v < 0 ? [i] : []));
  if (missing.length > 0) {
    const far = Math.max(...missing.map((v) => nearestOf(one, placeOf(other, v))));
    return [`${missing.length} of ${count} vertices are elsewhere, by up to ${
      (100 * far / diagonalOf(one)).toPrecision(3)} % of the diagonal`];
  }
  const keys = keysOf(one);
  const others = [...keysOf(other, (v) => numbers[v])]
    .filter(([key, times]) => keys.get(key) !== times).length;
  return others > 0 ? [`${others} of ${one.triangles.length / 3} triangles differ`] : [];
}
