// SPDX-License-Identifier: MIT
// Surfaces like those that people bring, by dice: turned bodies, machine parts, unions, bodies that
// touch or lie in each other, plates with holes, scans with specks, cards, soups. Plain lists.
import { looseTriangles, tJunctions } from '../support/broken_shapes.js';
import { engraved, gear, plate, sheetMetal, thread } from '../support/machine_parts.js';
import { joined, moved, shapes, welded } from './made_shapes.js';

/** @typedef {import('./made_shapes.js').Shape} Shape */
/** @typedef {import('./dice.js').Dice} Dice */

const rows = (/** @type {ArrayLike<number>} */ values) =>
  Array.from({ length: values.length / 3 }, (_, i) => [0, 1, 2].map((k) => values[3 * i + k]));

/** Plain lists of a mesh of arrays. @returns {Shape} */
export const listsOf = ({ positions, indices }) =>
  ({ positions: rows(positions), triangles: rows(indices) });

const scaled = ({ positions, triangles }, factors) =>
  ({ positions: positions.map((p) => p.map((x, k) => x * factors[k])), triangles });

/** A closed profile of [radius, height], turned around z; a radius of 0 is a pole.
 * @param {number[][]} profile counterclockwise, from pole to pole @param {number} steps */
export function turnedBody(profile, steps) {
  const point = (i, j) => {
    const [radius, height] = profile[j];
    const turn = (2 * Math.PI * (i % steps)) / steps;
    return radius === 0 ? [0, 0, height]
      : [radius * Math.cos(turn), radius * Math.sin(turn), height];
  };
  const positions = [], triangles = [];
  const at = (i, j) => i * profile.length + j;
  for (let i = 0; i <= steps; i += 1) {
    for (let j = 0; j < profile.length; j += 1) positions.push(point(i, j));
    for (let j = 0; i < steps && j + 1 < profile.length; j += 1) {
      triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)],
        [at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  }
  return welded({ positions, triangles });
}

/** A square with a round hole, flat or bent. @param {number} steps around, a multiple of 4 */
export function holedSheet(steps, across, bend = 0) {
  const positions = [], triangles = [];
  const at = (i, j) => (i % steps) * (across + 1) + j;
  for (let i = 0; i < steps; i += 1) {
    const turn = (2 * Math.PI * i) / steps;
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    const reach = 1 / Math.max(Math.abs(c), Math.abs(s));
    for (let j = 0; j <= across; j += 1) {
      const radius = 0.4 + (reach - 0.4) * (j / across);
      positions.push([radius * c, radius * s, bend * (radius * c) ** 2]);
      if (j === across) continue;
      triangles.push([at(i, j), at(i, j + 1), at(i + 1, j + 1)],
        [at(i, j), at(i + 1, j + 1), at(i + 1, j)]);
    }
  }
  return { positions, triangles };
}

const uvBall = (columns, rings) => turnedBody(Array.from({ length: rings + 1 }, (_, j) => {
  const turn = Math.PI * (j / rings);
  return [j % rings === 0 ? 0 : Math.sin(turn), -Math.cos(turn)];
}), columns);

const cup = (steps, wall) => turnedBody([[0, 0], [1, 0], [1, 2], [1 - wall, 2], [1 - wall, wall],
  [0, wall]], steps);

const spool = (steps) => turnedBody([[0, 0], [1, 0], [1, 0.2], [0.4, 0.4], [0.4, 1.6], [1, 1.8],
  [1, 2], [0, 2]], steps);

const cone = (steps) => turnedBody([[0, 0], [1, 0], [0, 3]], steps);

/** A sound closed body. @param {Dice} dice @returns {{ name: string, shape: Shape }} */
export function soundBody(dice) {
  const bodies = {
    box: () => shapes.box(dice.whole(1, 6)),
    slab: () => scaled(shapes.box(dice.whole(1, 4)), [4, 2, dice.number(0.05, 0.5)]),
    ball: () => shapes.ball(dice.whole(2, 8)),
    'ball of rings': () => uvBall(4 * dice.whole(2, 8), dice.whole(4, 16)),
    ring: () => shapes.ring(dice.whole(3, 8)),
    cup: () => cup(4 * dice.whole(2, 12), dice.number(0.05, 0.4)),
    spool: () => spool(4 * dice.whole(2, 10)),
    cone: () => cone(dice.whole(5, 24)),
    gear: () => listsOf(gear({ teeth: dice.whole(6, 14) })),
    plate: () => listsOf(plate()),
    engraved: () => listsOf(engraved()),
    'sheet metal': () => listsOf(sheetMetal()),
    thread: () => listsOf(thread({ turns: dice.whole(2, 4), steps: dice.whole(16, 32) })),
  };
  const name = dice.pick(Object.keys(bodies));
  return { name, shape: bodies[name]() };
}

/** The same body with its largest extent 1, its middle at a place. */
function fitted({ positions, triangles }, size, place) {
  const bound = (pick) => [0, 1, 2].map((k) =>
    positions.reduce((value, p) => pick(value, p[k]), positions[0][k]));
  const [low, high] = [bound(Math.min), bound(Math.max)];
  const factor = size / Math.max(...high.map((x, k) => x - low[k]));
  return { positions: positions.map((p) => p.map((x, k) =>
    (x - (low[k] + high[k]) / 2) * factor + place[k])), triangles };
}

const inside = ({ positions, triangles }) =>
  ({ positions, triangles: triangles.map(([a, b, c]) => [a, c, b]) });

const somewhere = (dice, far) => [0, 1, 2].map(() => dice.number(-far, far));

/** Bodies that overlap. @param {Dice} dice */
function union(dice) {
  const count = dice.whole(2, 4);
  return joined(...Array.from({ length: count }, () =>
    fitted(soundBody(dice).shape, dice.number(0.5, 1), somewhere(dice, 0.4))));
}

function apart(dice) {
  return joined(...Array.from({ length: dice.whole(2, 6) }, (_, i) =>
    fitted(soundBody(dice).shape, dice.number(0.02, 1), [1.2 * i, 0, 0])));
}

/** A body in the cavity of another, or only the cavity. @param {Dice} dice */
function hollow(dice, isFilled) {
  const n = dice.whole(2, 4);
  const around = (size) => fitted(dice.chance(0.5) ? shapes.box(n) : shapes.ball(2 * n), size,
    [0, 0, 0]);
  const shells = [around(2), inside(around(1))];
  return joined(...shells, ...(isFilled ? [fitted(soundBody(dice).shape, 0.3, [0, 0, 0])] : []));
}

/** Boxes that share an edge, a corner or a part of a side.
 * @param {Dice} dice @param {number[]} by */
const touching = (dice, by) => {
  const n = dice.whole(1, 3);
  return welded(joined(shapes.box(n), moved(shapes.box(n), by)));
};

/** A ball that is open on one side, with specks beside it. @param {Dice} dice */
function scan(dice) {
  const ball = shapes.ball(2 * dice.whole(2, 4));
  const open = dice.number(0.3, 0.95);
  const kept = ball.triangles.filter((t) => t.every((v) => ball.positions[v][2] < open));
  const specks = Array.from({ length: dice.whole(0, 12) }, () =>
    fitted(shapes.tetrahedron(), 0.02, somewhere(dice, 1.3)));
  return joined({ positions: ball.positions, triangles: kept }, ...specks);
}

/** Rectangles that cross, like leaves. @param {Dice} dice */
function cards(dice) {
  return joined(...Array.from({ length: dice.whole(4, 24) }, () => {
    const turn = dice.number(0, Math.PI);
    const card = scaled(shapes['flat sheet'](1), [1, 0.3, 1]);
    const place = somewhere(dice, 0.5);
    return { triangles: card.triangles, positions: card.positions.map(([x, y]) =>
      [place[0] + x * Math.cos(turn), place[1] + x * Math.sin(turn), place[2] + y]) };
  }));
}

/** Faults that repair is for. @param {Dice} dice @returns {{ name: string, shape: Shape }} */
export function faultyBody(dice) {
  const kinds = {
    'overlapping bodies': () => union(dice),
    'bodies apart': () => apart(dice),
    'a cavity': () => hollow(dice, false),
    'a body in a cavity': () => hollow(dice, true),
    'a body in a body': () => joined(shapes.box(3), fitted(shapes.ball(3), 0.4, [0.5, 0.5, 0.5])),
    'a common edge': () => touching(dice, [1, 1, 0]),
    'a common corner': () => touching(dice, [1, 1, 1]),
    'a common side': () => touching(dice, [0, 0, 1]),
    'a scan': () => scan(dice),
    cards: () => cards(dice),
    soup: () => listsOf(looseTriangles(Math.round(4 + 396 * dice.number() ** 3))),
    'sides that do not match': () => listsOf(tJunctions()),
    'inside out': () => inside(soundBody(dice).shape),
    'a sound body': () => soundBody(dice).shape,
  };
  const name = dice.pick(Object.keys(kinds));
  return { name, shape: kinds[name]() };
}

/** Open surfaces without other faults. @param {Dice} dice */
export function openSheet(dice) {
  const kinds = {
    'sheet with a hole': () => holedSheet(8 * dice.whole(2, 8), dice.whole(1, 8)),
    'bent sheet with a hole': () => holedSheet(8 * dice.whole(2, 8), dice.whole(2, 8), 0.3),
    sheet: () => shapes.sheet(dice.whole(2, 6)),
    pipe: () => shapes.pipe(dice.whole(2, 6)),
    'half a ball': () => {
      const { positions, triangles } = shapes.ball(2 * dice.whole(2, 5));
      return { positions, triangles: triangles.filter((t) =>
        t.every((v) => positions[v][2] <= 1e-9)) };
    },
  };
  const name = dice.pick(Object.keys(kinds));
  return { name, shape: kinds[name]() };
}

/** A turn and a scale that leave no side along an axis. @param {Shape} shape @param {Dice} dice */
export function askew({ positions, triangles }, dice) {
  const [a, b] = [dice.number(0, 6), dice.number(0, 6)];
  const size = 10 ** dice.number(-2, 2);
  const [ca, sa, cb, sb] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b)];
  return { triangles, positions: positions.map(([x, y, z]) => {
    const [u, v] = [ca * x - sa * y, sa * x + ca * y];
    return [u, cb * v - sb * z, sb * v + cb * z].map((value) => size * value);
  }) };
}
