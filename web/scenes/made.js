// SPDX-License-Identifier: MIT
// The models of the guides' figures, by formula, as their jobs meet them: a scan with too many
// triangles, bodies that overlap and have holes, a part of needles, a generator's loose pieces.

/** @typedef {[number, number, number]} Vector */
/** @typedef {{ positions: Float32Array, indices: Uint32Array }} Mesh */

/** A surface over a grid that closes in both directions, or in one with poles.
 * @param {number} around @param {number} across
 * @param {(u: number, v: number) => Vector} place u, v: from 0 to 1 @returns {Mesh} */
function grid(around, across, place) {
  const positions = [], indices = [];
  for (let i = 0; i < around; ++i)
    for (let j = 0; j < across; ++j) positions.push(...place(i / around, (j + 0.5) / across));
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j + 1 < across; ++j) {
      const k = (i + 1) % around;
      const [a, b, c, d] = [i * across + j, k * across + j, k * across + j + 1, i * across + j + 1];
      indices.push(a, b, c, a, c, d);
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

/** Meshes as one. @param {Mesh[]} meshes @returns {Mesh} */
function joined(meshes) {
  const positions = [], indices = [];
  for (const mesh of meshes) {
    const first = positions.length / 3;
    positions.push(...mesh.positions);
    indices.push(...mesh.indices.map((v) => first + v));
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

/** A ball of fine triangles. isOpen: its pole on one side is cut off.
 * @param {Vector} middle @param {number} radius
 * @param {{ isOpen?: boolean, rough?: number, count?: number }} [how] */
function ball(middle, radius, { isOpen = false, rough = 0, count = 48 } = {}) {
  const rows = count / 2;
  const mesh = grid(count, isOpen ? Math.round(rows * 0.8) : rows, (u, v) => {
    const [turn, fall] = [2 * Math.PI * u, Math.PI * v * (isOpen ? 0.8 : 1)];
    const bump = 1 + rough * (Math.sin(5 * turn) * Math.sin(4 * fall) + Math.cos(3 * fall));
    return [middle[0] + radius * bump * Math.sin(fall) * Math.cos(turn),
      middle[1] - radius * bump * Math.sin(fall) * Math.sin(turn),
      middle[2] + radius * bump * Math.cos(fall)];
  });
  return closedAtPoles(mesh, count, isOpen);
}

/** Closes the first ring of a ball, and the last one unless it is open.
 * @param {Mesh} mesh @param {number} around @param {boolean} isOpen */
function closedAtPoles({ positions, indices }, around, isOpen) {
  const places = [...positions], triangles = [...indices];
  const across = positions.length / 3 / around;
  for (const row of isOpen ? [0] : [0, across - 1]) {
    const pole = places.length / 3;
    const mean = [0, 1, 2].map((k) => Array.from({ length: around }, (_, i) =>
      positions[3 * (i * across + row) + k]).reduce((sum, x) => sum + x) / around);
    places.push(...mean);
    for (let i = 0; i < around; ++i) {
      const [a, b] = [i * across + row, (i + 1) % around * across + row];
      triangles.push(...(row ? [a, b, pole] : [b, a, pole]));
    }
  }
  return { positions: Float32Array.from(places), indices: Uint32Array.from(triangles) };
}

/** A scan: a rough body with far more triangles than its shape needs. */
export const scan = () => ball([0, 0, 0], 0.85, { rough: 0.07, count: 120 });

/** Bodies that overlap, and one of them open. */
export const overlapping = () => joined([ball([-0.35, 0, 0], 0.62, { isOpen: true }),
  ball([0.42, 0.1, 0], 0.5)]);

/** What generators make: a body, another inside it, and loose pieces around. */
export const generated = () => joined([ball([0, 0, 0], 0.8, { rough: 0.09, count: 96 }),
  ball([0, 0, 0], 0.4, { count: 32 }),
  ball([1.05, 0.5, 0], 0.022, { count: 8 }), ball([-1, 0.7, 0.3], 0.018, { count: 8 }),
  ball([0.9, -0.8, 0.2], 0.015, { count: 8 }), ball([-0.9, -0.7, 0], 0.02, { count: 8 })]);

/** Corners of the part's outline, and those of its bore. */
const corners = [[-1, -0.6], [1, -0.6], [1, -0.1], [0.35, 0.6], [-1, 0.6]];
const bore = { middle: [-0.25, 0], radius: 0.32, sides: 40 };

/** The direction of a point from the middle of the bore. @param {number[]} p */
const turnOf = ([x, y]) => Math.atan2(y - bore.middle[1], x - bore.middle[0]);

/** A plate with a bore, in the needles of a program for construction: every corner of the bore is
 * joined with a corner of the outline. @returns {Mesh} */
export function plate() {
  const hole = Array.from({ length: bore.sides }, (_, i) => {
    const turn = 2 * Math.PI * i / bore.sides - Math.PI + 0.01;
    return [bore.middle[0] + bore.radius * Math.cos(turn),
      bore.middle[1] + bore.radius * Math.sin(turn)];
  });
  const outline = [...corners].sort((p, q) => turnOf(p) - turnOf(q));
  const flat = [...hole, ...outline], height = 0.22;
  const positions = [-height, height].flatMap((z) => flat.flatMap(([x, y]) => [x, y, z]));
  /** @type {number[]} */
  const top = [];
  let [i, j] = [0, 0];
  const last = turnOf(outline[outline.length - 1]) - 2 * Math.PI;
  const turns = [last, ...outline.map(turnOf)];
  while (i < hole.length || j < outline.length) {  // halfway between two corners the next one comes
    const isHole = j === outline.length
      || (i < hole.length && turnOf(hole[i]) < (turns[j] + turns[j + 1]) / 2);
    const inner = i % hole.length, outer = hole.length + (j + outline.length - 1) % outline.length;
    top.push(...(isHole ? [(inner + hole.length - 1) % hole.length, outer, inner]
      : [(i + hole.length - 1) % hole.length, outer, hole.length + j]));
    if (isHole) i += 1;
    else j += 1;
  }
  const count = flat.length;
  const indices = [...top.map((v) => count + v), ...mirrored(top),
    ...wall(0, hole.length, count).reverse(), ...wall(hole.length, outline.length, count)];
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

/** @param {number[]} triangles */
const mirrored = (triangles) => [...triangles].reverse();

/** The wall over a ring of vertices. @param {number} first @param {number} length
 * @param {number} up from a vertex to the one above */
function wall(first, length, up) {
  const indices = [];
  for (let k = 0; k < length; ++k) {
    const [a, b] = [first + k, first + (k + 1) % length];
    indices.push(a, b, b + up, a, b + up, a + up);
  }
  return indices;
}
