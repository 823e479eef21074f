// SPDX-License-Identifier: MIT
// Files as people bring them to repair, by formula: bodies that overlap, generated bodies with
// folds and leaks, scans with openings, cards and cloth.
import { cracked, looseTriangles, moebiusStrip, nestedBoxes, tJunctions, thinHouse }
  from './broken_shapes.js';
import { sheetOf, torus } from './shapes.js';

/** @typedef {{ positions: Float64Array, indices: Uint32Array }} Mesh */

/** Numbers from 0 to 1, the same each time. @param {number} seed */
function chance(seed) {
  let state = seed;
  return () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
}

/** @returns {Mesh} */
const joined = (...parts) => {
  const positions = parts.flatMap((part) => Array.from(part.positions));
  let first = 0;
  const indices = parts.flatMap((part) => {
    const own = Array.from(part.indices, (v) => v + first);
    first += part.positions.length / 3;
    return own;
  });
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
};

/** Each place by a function of it. @returns {Mesh} */
const bent = ({ positions, indices }, placeOf) => ({ indices: Uint32Array.from(indices),
  positions: Float64Array.from(Array.from({ length: positions.length / 3 }, (_, v) =>
    placeOf([...positions.subarray(3 * v, 3 * v + 3)], v)).flat()) });

const moved = (mesh, by, scale = [1, 1, 1]) =>
  bent(mesh, (p) => p.map((value, k) => scale[k] * value + by[k]));

/** About the axes z and x. */
const turned = (mesh, angle, tilt = 0) => bent(mesh, ([x, y, z]) => {
  const [c, s, d, t] = [Math.cos(angle), Math.sin(angle), Math.cos(tilt), Math.sin(tilt)];
  const across = s * x + c * y;
  return [c * x - s * y, d * across - t * z, t * across + d * z];
});

const insideOut = ({ positions, indices }) => ({ positions,
  indices: indices.map((_, i, all) => all[i - (i % 3) + [0, 2, 1][i % 3]]) });

const without = ({ positions, indices }, isGone) => ({ positions,
  indices: indices.filter((_, i) => !isGone(Math.floor(i / 3))) });

/** Triangles of corners of their own, each moved by up to `noise`. */
function loose({ positions, indices }, noise) {
  const next = chance(5);
  return { indices: Uint32Array.from(indices, (_, i) => i),
    positions: Float64Array.from(Array.from(indices, (v) =>
      [...positions.subarray(3 * v, 3 * v + 3)].map((x) => x + noise * (next() - 0.5))).flat()) };
}

/** Octants that each have corners of their own, moved by up to `noise`. */
function inOctants({ positions, indices }, noise) {
  const next = chance(7);
  const numbers = new Map();
  const places = [];
  const octantOf = (t) => [0, 1, 2].map((k) => [0, 1, 2].reduce((sum, i) =>
    sum + positions[3 * indices[3 * t + i] + k], 0) > 0).join();
  const own = Array.from(indices, (v, i) => {
    const key = `${octantOf(Math.floor(i / 3))} ${v}`;
    if (!numbers.has(key)) {
      numbers.set(key, numbers.size);
      places.push(...[...positions.subarray(3 * v, 3 * v + 3)]
        .map((x) => x + noise * (next() - 0.5)));
    }
    return numbers.get(key);
  });
  return { positions: Float64Array.from(places), indices: Uint32Array.from(own) };
}

/** All corners moved by up to `noise`. */
function noisy(mesh, noise) {
  const next = chance(13);
  return bent(mesh, (p) => p.map((x) => x + noise * (next() - 0.5)));
}

/** A box from a corner to the opposite one, each side of `cells` times `cells` squares. */
export function box(low, high, cells = 1) {
  const numbers = new Map();
  const positions = [], indices = [];
  const at = (p) => {
    const key = p.join();
    if (!numbers.has(key)) {
      numbers.set(key, numbers.size);
      positions.push(...p.map((x, k) => low[k] + (x / cells) * (high[k] - low[k])));
    }
    return numbers.get(key);
  };
  const addSquare = ([axis, end], i, k) => {
    const place = (u, v) => {
      const p = [0, 0, 0];
      p[axis] = end;
      p[(axis + 1) % 3] = u;
      p[(axis + 2) % 3] = v;
      return at(p);
    };
    const [a, b, c, d] = [place(i, k), place(i + 1, k), place(i + 1, k + 1), place(i, k + 1)];
    indices.push(...(end === 0 ? [a, c, b, a, d, c] : [a, b, c, a, c, d]));
  };
  for (const side of [0, 1, 2].flatMap((axis) => [[axis, 0], [axis, cells]])) {
    for (let square = 0; square < cells * cells; square += 1) {
      addSquare(side, Math.floor(square / cells), square % cells);
    }
  }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}

/** A ball whose radius depends on the direction. */
export function ball({ columns = 32, rows = 16,
  radiusAt = /** @type {(p: number[]) => number} */ (() => 1) } = {}) {
  const positions = [0, 0, 1];
  for (let k = 1; k < rows; k += 1) {
    for (let i = 0; i < columns; i += 1) {
      const [a, b] = [(2 * Math.PI * i) / columns, (Math.PI * k) / rows];
      positions.push(Math.sin(b) * Math.cos(a), Math.sin(b) * Math.sin(a), Math.cos(b));
    }
  }
  positions.push(0, 0, -1);
  const at = (i, k) => 1 + (k - 1) * columns + (i % columns), last = positions.length / 3 - 1;
  const indices = [];
  for (let i = 0; i < columns; i += 1) {
    indices.push(0, at(i, 1), at(i + 1, 1));
    for (let k = 1; k + 1 < rows; k += 1) {
      indices.push(at(i, k), at(i, k + 1), at(i + 1, k + 1));
      indices.push(at(i, k), at(i + 1, k + 1), at(i + 1, k));
    }
    indices.push(at(i, rows - 1), last, at(i + 1, rows - 1));
  }
  const mesh = { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
  return bent(mesh, (p) => p.map((x) => x * radiusAt(p)));
}

/** A closed cylinder about z. */
export function rod(radius, [low, high], segments) {
  const positions = [];
  for (const z of [low, high]) {
    for (let i = 0; i < segments; i += 1) {
      const turn = (2 * Math.PI * i) / segments;
      positions.push(radius * Math.cos(turn), radius * Math.sin(turn), z);
    }
  }
  positions.push(0, 0, low, 0, 0, high);
  const indices = [], n = segments;
  for (let i = 0; i < n; i += 1) {
    const k = (i + 1) % n;
    indices.push(i, k, n + k, i, n + k, n + i, 2 * n, k, i, 2 * n + 1, n + i, n + k);
  }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}

const bumpy = (columns, rows, depth = 0.12) => ball({ columns, rows, radiusAt: ([x, y, z]) =>
  1 + depth * Math.sin(5 * x + 1) * Math.cos(4 * y) + depth * Math.sin(7 * z + 2 * x) });

/** Forty bodies of three kinds, some inside each other's walls; every other one can be turned. */
function assembly(isTurned) {
  const next = chance(11);
  return joined(...Array.from({ length: 40 }, (_, i) => {
    const body = [() => box([-1, -1, -1], [1, 1, 1], 2), () => rod(0.7, [-1.5, 1.5], 24),
      () => torus({ columns: 16, rows: 8, radius: 1, tube: 0.35 })][i % 3]();
    const placed = moved(turned(body, 6 * next(), 3 * next()),
      [9 * next(), 9 * next(), 3 * next()]);
    return isTurned && i % 2 === 1 ? insideOut(placed) : placed;
  }));
}

/** A figure of 21 limbs that overlap at their ends. */
const figure = () => joined(...Array.from({ length: 21 }, (_, i) => {
  const limb = ball({ columns: 32, rows: 15 });
  const [a, b] = [0.9 * i, 0.35 * i];
  return turned(moved(limb, [0, 0, 0.9 * (i % 5)], [0.35, 0.3, 0.7]), a, b);
}));

/** A body of which some vertices are pushed through the other side of a thin fold. */
function folded(columns, rows, count, depth) {
  const next = chance(3);
  const mesh = bumpy(columns, rows);
  const total = mesh.positions.length / 3;
  const pushed = new Set(Array.from({ length: count }, () => Math.floor(next() * total)));
  return bent(mesh, (p, v) => (pushed.has(v)
    ? [p[0] + depth * (next() - 0.5), p[1] + depth * (next() - 0.5), p[2] + depth * (next() - 0.5)]
    : p));
}

/** A wall with an outer and an inner side, and leaks from one to the other. */
function doubleShell(leaks) {
  const next = chance(9);
  const outer = bumpy(96, 48);
  const inner = insideOut(moved(outer, [0, 0, 0], [0.96, 0.96, 0.96]));
  const gone = new Set(Array.from({ length: leaks }, () =>
    Math.floor(next() * outer.indices.length / 3)));
  return joined(without(outer, (t) => gone.has(t)), without(inner, (t) => gone.has(t)));
}

/** Squares that stand at random around a trunk. */
function foliage(count = 80) {
  const next = chance(21);
  const card = { positions: Float64Array.from([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]),
    indices: Uint32Array.from([0, 1, 2, 0, 2, 3]) };
  return joined(rod(0.1, [0, 2], 16), ...Array.from({ length: count }, () => {
    const leaf = turned(moved(card, [0, 0, 0], [0.2, 0.2, 1]), 6 * next(), 3 * next());
    return moved(leaf, [1.4 * (next() - 0.5), 1.4 * (next() - 0.5), 1.5 + next()]);
  }));
}

const heights = (cells, depth) => sheetOf(cells, (i, k) => {
  const [x, y] = [(6 * i) / cells, (6 * k) / cells];
  return [x, y, depth * Math.sin(1.7 * x) * Math.cos(1.3 * y)];
});

/** A cup: a wall with a bottom, both of a thickness, whose rim is closed. */
function cup() {
  const profile = [[0, 0], [0.8, 0], [1, 1.6], [0.9, 1.6], [0.7, 0.12], [0, 0.12]];
  const segments = 32;
  const positions = profile.flatMap(([r, z]) => Array.from({ length: segments }, (_, i) =>
    [r * Math.cos((2 * Math.PI * i) / segments), r * Math.sin((2 * Math.PI * i) / segments), z])
    .flat());
  const indices = [];
  for (let k = 0; k + 1 < profile.length; k += 1) {
    for (let i = 0; i < segments; i += 1) {
      const [a, b] = [k * segments + i, k * segments + (i + 1) % segments];
      indices.push(a, b, b + segments, a, b + segments, a + segments);
    }
  }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}

/** Every triangle turned over or not, at random. */
function randomlyTurned(mesh) {
  const next = chance(2);
  const flips = Array.from({ length: mesh.indices.length / 3 }, () => next() < 0.5);
  return { positions: mesh.positions, indices: mesh.indices.map((_, i, all) =>
    (flips[Math.floor(i / 3)] ? all[i - (i % 3) + [0, 2, 1][i % 3]] : all[i])) };
}

const plateWithBoss = () => joined(box([-4, -3, 0], [4, 3, 1], 6), rod(1.2, [1, 3], 48),
  moved(rod(0.3, [-0.5, 1.5], 24), [3, 2, 0]));

const grid = (count, spacing, body) => joined(...Array.from({ length: count * count }, (_, i) =>
  moved(body, [spacing * (i % count), spacing * Math.floor(i / count), 0])));

/** The families: `of` makes the mesh, `most` is how many triangles repair may write, `keeps` the
 * least share of the given triangles that stay bit for bit, where that is known.
 * @type {Record<string, { of: () => any, most?: number, keeps?: number, isOpen?: boolean }>} */
export const brokenFiles = {
  'two boxes': { of: () => joined(box([0, 0, 0], [2, 2, 2]), box([1, 1, 1], [3, 3, 3])), most: 60 },
  'plate with boss': { of: plateWithBoss, most: 850 },
  'figure of 21 bodies': { of: figure, most: 20000 },
  'ball on a stand': { of: () => joined(ball({ columns: 96, rows: 48 }),
    rod(0.5, [-1.6, -0.9], 64), box([-1, -1, -1.8], [1, 1, -1.5], 4)), most: 11000 },
  'assembly of 40': { of: () => assembly(false), most: 8000 },
  'assembly, half inside out': { of: () => assembly(true), most: 8000 },
  'generated, few folds': { of: () => folded(200, 100, 12, 0.3), most: 41700, keeps: 0.95 },
  'generated, fewer triangles': { of: () => folded(96, 48, 4, 0.5), most: 9700, keeps: 0.95 },
  'generated, many folds': { of: () => folded(140, 70, 400, 0.15) },
  'corners 1e-6 apart': { of: () => loose(box([0, 0, 0], [1, 1, 1]), 1e-6), most: 12 },
  'ball, corners 1e-6 apart': { of: () => loose(bumpy(48, 24), 1e-6), most: 2300 },
  'T-junctions': { of: () => tJunctions(), most: 500 },
  'T-junctions 1e-3 apart': { of: () => noisy(tJunctions(), 1e-3), most: 520, keeps: 0.7 },
  'ball, octants 1e-3 apart': { of: () => inOctants(bumpy(96, 48), 1e-3), most: 9200, keeps: 0.7 },
  'torus, corners 2e-3 apart': { of: () => cracked({ columns: 96, rows: 48 }), most: 9216 },
  'noisy, folds at corners': { of: () => noisy(bumpy(96, 48), 0.03), most: 11000, keeps: 0.9 },
  'double shell, leaks': { of: () => doubleShell(30) },
  'double shell, closed': { of: () => doubleShell(0), keeps: 1 },
  'torn ball': { of: () => without(bumpy(96, 48), (t) => t % 61 === 0), keeps: 0.99 },
  'ball with a large hole': { of: () => without(bumpy(64, 32), (t) => t % 62 < 18 && t < 1200) },
  'scan open below': { of: () => without(bumpy(64, 32), (t) => t % 62 > 48) },
  'boxes with a common face': { of: () => joined(box([0, 0, 0], [1, 1, 1], 3),
    box([1, 0, 0], [2, 1, 1], 3)) },
  'boxes with a common edge': { of: () => joined(box([0, 0, 0], [1, 1, 1], 2),
    box([1, 1, 0], [2, 2, 1], 2)) },
  'boxes in a row, flush': { of: () => joined(...[0, 1, 2, 3].map((i) =>
    box([i, 0, 0], [i + 1.25, 1, 1 + (i % 2)], 1))) },
  'same box twice': { of: () => joined(box([0, 0, 0], [1, 1, 1], 2),
    box([0, 0, 0], [1, 1, 1], 2)) },
  'nested boxes': { of: () => nestedBoxes() },
  'thin house': { of: () => thinHouse() },
  'bed of 100 rings': { of: () => grid(10, 4, torus({ columns: 16, rows: 8, radius: 1,
    tube: 0.5 })), keeps: 1 },
  'bed of 100, one torn': { of: () => joined(grid(10, 4, torus({ columns: 16, rows: 8, radius: 1,
    tube: 0.5 })), moved(without(torus({ columns: 16, rows: 8, radius: 1, tube: 0.5 }),
    (t) => t % 7 === 0), [50, 0, 0])), keeps: 0.99 },
  'bodies beside a soup': { of: () => joined(grid(5, 4, torus({ columns: 24, rows: 12, radius: 1,
    tube: 0.5 })), moved(looseTriangles(300, 0.4), [30, 0, 0], [3, 3, 3])), keeps: 0.9,
    isOpen: true },
  'bodies and a Möbius strip': { of: () => joined(grid(4, 4, ball()), moved(moebiusStrip(),
    [30, 0, 0])), keeps: 0.9, isOpen: true },
  'terrain': { of: () => heights(60, 0.8), isOpen: true, keeps: 1 },
  'terrain with houses': { of: () => joined(heights(40, 0.3), ...[[1, 1], [3, 2], [4, 4.5]]
    .map(([x, y]) => box([x, y, -0.5], [x + 0.6, y + 0.6, 0.9]))), isOpen: true },
  'cloth over a ball': { of: () => joined(ball(), sheetOf(30, (i, k) => {
    const [x, y] = [4 * (i / 30) - 2, 4 * (k / 30) - 2];
    const far = x * x + y * y;
    return [x, y, far < 1 ? Math.sqrt(1.1 - far) : 0.32 - 0.2 * (far - 1)];
  })), isOpen: true },
  'foliage': { of: () => foliage(), isOpen: true },
  'cup': { of: cup },
  'randomly turned': { of: () => randomlyTurned(bumpy(64, 32)), most: 3970 },
  'vase with one wall': { of: () => without(bumpy(64, 32), (t) => t % 62 < 9) },
  'soup': { of: () => looseTriangles(400, 0.3) },
  'Möbius strip': { of: () => moebiusStrip(), isOpen: true },
  'shaft in a bore': { of: () => joined(rod(1, [0, 4], 48), rod(0.4, [-1, 5], 48),
    box([-1.5, -1.5, 1], [1.5, 1.5, 2], 4)) },
  'ring through itself': { of: () => turned(torus({ columns: 48, rows: 24, radius: 0.6,
    tube: 0.9 }), 0.3, 0.2) },
  'T-junctions beside a ring': { of: () => joined(tJunctions(), moved(torus(), [9, 0, 0])) },
};
