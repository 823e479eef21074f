// SPDX-License-Identifier: MIT
// Small surfaces by formula: smooth and sharp, open and closed, flat, and non-manifold. They are
// plain lists, which can be changed before they become arrays.

/** @typedef {{ positions: number[][], triangles: number[][] }} Shape */

/** (columns + 1) × (rows + 1) points, two triangles a cell. @returns {Shape} */
function sheetOf(columns, rows, point) {
  const positions = [];
  const triangles = [];
  const at = (i, j) => i * (rows + 1) + j;
  for (let i = 0; i <= columns; i += 1) {
    for (let j = 0; j <= rows; j += 1) {
      positions.push(point(i, j));
      if (i === columns || j === rows) continue;
      triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)],
        [at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  }
  return { positions, triangles };
}

/** Welds vertices at equal positions. @param {Shape} shape @returns {Shape} */
export function welded({ positions, triangles }) {
  const numbers = new Map();
  const kept = [];
  const renumbered = positions.map((p) => {
    const key = p.map((x) => Math.round(x * 1e9) + 0).join();
    if (!numbers.has(key)) numbers.set(key, kept.push(p) - 1);
    return numbers.get(key);
  });
  return {
    positions: kept,
    triangles: triangles.map((t) => t.map((v) => renumbered[v]))
      .filter(([a, b, c]) => a !== b && b !== c && c !== a),
  };
}

export function joined(...shapes) {
  const positions = shapes.flatMap((shape) => shape.positions);
  let first = 0;
  const triangles = shapes.flatMap((shape) => {
    const offset = first;
    first += shape.positions.length;
    return shape.triangles.map((t) => t.map((v) => v + offset));
  });
  return { positions, triangles };
}

export const moved = ({ positions, triangles }, by) =>
  ({ positions: positions.map((p) => p.map((x, k) => x + by[k])), triangles });

const turned = ({ positions, triangles }) =>
  ({ positions, triangles: triangles.map(([a, b, c]) => [a, c, b]) });

const circle = (k, n) => [Math.cos((2 * Math.PI * k) / n), Math.sin((2 * Math.PI * k) / n)];

const tetrahedron = () => ({
  positions: [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]],
  triangles: [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]],
});

function box(n) {
  const side = (axis, level) => sheetOf(n, n, (i, j) => {
    const place = [];
    place[axis] = level;
    place[(axis + 1) % 3] = (level ? i : n - i) / n;
    place[(axis + 2) % 3] = j / n;
    return place;
  });
  return welded(joined(...[0, 1, 2].flatMap((axis) => [side(axis, 0), side(axis, 1)])));
}

function ball(n) {
  const { positions, triangles } = box(n);
  const onSphere = (p) => {
    const q = p.map((x) => 2 * x - 1);
    const length = Math.hypot(...q);
    return q.map((x) => x / length);
  };
  return { positions: positions.map(onSphere), triangles };
}

const ring = (columns, rows, tube = 0.8) => welded(sheetOf(columns, rows, (i, j) => {
  const [[x, y], [out, up]] = [circle(i, columns), circle(j, rows)];
  return [(2 + tube * out) * x, (2 + tube * out) * y, tube * up];
}));

const sheet = (n, height = 0.1) => sheetOf(n, n, (i, j) =>
  [i / n, j / n, height * Math.sin((4 * i) / n) * Math.cos((3 * j) / n)]);

const pipe = (columns, rows) => welded(sheetOf(columns, rows, (i, j) =>
  [...circle(i, columns), (2 * j) / rows]));

const moebius = (n) => welded(sheetOf(n, 2, (i, j) => {
  const [[x, y], [half, tilt]] = [circle(i % n, n), circle(i % n, 2 * n)];
  const across = (i === n ? -1 : 1) * 0.4 * (j - 1);
  return [(2 + across * half) * x, (2 + across * half) * y, across * tilt];
}));

const fan = (n, step) => ({
  positions: [[0, 0, 0], ...Array.from({ length: n + 1 }, (_, k) => [1, step * k, 0])],
  triangles: Array.from({ length: n }, (_, k) => [0, k + 1, k + 2]),
});

const bowTie = () => ({
  positions: [[0, 0, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0], [-1, -1, 0]],
  triangles: [[0, 1, 2], [0, 3, 4]],
});

const book = (pages) => ({
  positions: [[0, 0, 0], [0, 0, 1],
    ...Array.from({ length: pages }, (_, k) => [...circle(k, pages), 0.5])],
  triangles: Array.from({ length: pages }, (_, k) => [0, 1, k + 2]),
});

/** Makes each shape from its approximate number of cells along a side. */
export const shapes = {
  tetrahedron,
  box: (n) => box(n),
  ball: (n) => ball(n),
  ring: (n) => ring(3 * n, 2 * n),
  'thin ring': (n) => ring(4 * n, 3, 0.05),
  sheet: (n) => sheet(2 * n),
  'flat sheet': (n) => sheet(2 * n, 0),
  pipe: (n) => pipe(4 * n, n),
  moebius: (n) => moebius(4 * n),
  fan: (n) => fan(4 * n, 0.1),
  'sliver fan': (n) => fan(4 * n, 1e-3),
  'bow tie': bowTie,
  book: (n) => book(2 + n),
  'two balls': (n) => joined(ball(n), moved(ball(1 + (n >> 1)), [3, 0, 0])),
  'two boxes that touch along an edge': (n) => welded(joined(box(n), moved(box(n), [1, 1, 0]))),
  'a sheet twice, back to back': (n) => joined(sheet(n), turned(sheet(n))),
  'a shell in a shell': (n) => joined(ball(n), turned(moved(
    { ...ball(n), positions: ball(n).positions.map((p) => p.map((x) => 0.9 * x)) }, [0, 0, 0]))),
};
