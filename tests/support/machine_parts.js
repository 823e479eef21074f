// SPDX-License-Identifier: MIT
// Machine parts as CAD systems export them, made by formula: long thin triangles on what is flat,
// strips of facets along what is round, walls thinner than the part by far.
import { ShapeUtils, Vector2 } from 'three';

/** @typedef {[number, number]} Point in the plane */
/** @typedef {{ positions: Float64Array, indices: Uint32Array }} Mesh */

/** Of places, each of three numbers, and corners. @returns {Mesh} */
const meshOf = (places, corners) => ({ positions: Float64Array.from(places.flat()),
  indices: Uint32Array.from(corners.flat()) });

/** Points along an arc, both ends among them; angles in turns. @returns {Point[]} */
function arc([x, y], radius, [from, to], segments) {
  return Array.from({ length: segments + 1 }, (_, k) => {
    const turn = 2 * Math.PI * (from + ((to - from) * k) / segments);
    return [x + radius * Math.cos(turn), y + radius * Math.sin(turn)];
  });
}

/** A circle, counterclockwise. */
const circle = (centre, radius, segments) => arc(centre, radius, [0, 1], segments).slice(0, -1);

/** A rectangle about the origin whose corners are round. @returns {Point[]} */
function roundRectangle(width, height, radius, segments) {
  const [x, y] = [width / 2 - radius, height / 2 - radius];
  return [[x, y], [-x, y], [-x, -y], [x, -y]].flatMap((corner, k) =>
    arc(corner, radius, [k / 4, (k + 1) / 4], segments));
}

/** Corners of the triangles between an outline and its holes, all counterclockwise; points are
 * counted through all of them. */
function triangulated(outline, holes) {
  const vectors = (points) => points.map(([x, y]) => new Vector2(x, y));
  return ShapeUtils.triangulateShape(vectors(outline), holes.map((hole) => vectors(hole)));
}

/** A strip of walls from a closed row of vertices to the one above it, of as many. */
function strip(below, above, count) {
  return Array.from({ length: count }, (_, k) => {
    const next = (k + 1) % count;
    return [below + k, below + next, above + next, below + k, above + next, above + k];
  });
}

/** Outlines, each at its height, from the lowest to the highest, as the wall of a body that holes
 * go through.
 * @param {{ outline: Point[], height: number }[]} rows of as many points
 * @param {Point[][]} holes */
function lofted(rows, holes) {
  const [lowest, highest] = [rows[0], rows.at(-1)];
  const count = lowest.outline.length;
  const places = rows.flatMap(({ outline, height }) => outline.map(([x, y]) => [x, y, height]));
  const corners = rows.slice(1).flatMap((_, k) => strip(k * count, (k + 1) * count, count));
  const firsts = [];
  for (const hole of holes) {
    firsts.push(places.length);
    for (const { height } of [lowest, highest]) {
      places.push(...hole.map(([x, y]) => [x, y, height]));
    }
    corners.push(...strip(firsts.at(-1) + hole.length, firsts.at(-1), hole.length));
  }
  const cap = ({ outline }, rim, side) => {
    const names = [...outline.map((_, k) => rim + k),
      ...holes.flatMap((hole, h) => hole.map((_, k) => firsts[h] + side * hole.length + k))];
    return triangulated(outline, holes).map((triangle) => triangle.map((v) => names[v]));
  };
  const floor = cap(lowest, 0, 0).map((triangle) => [...triangle].reverse());
  return meshOf(places, [...corners, ...floor, ...cap(highest, (rows.length - 1) * count, 1)]);
}

/** A body of one outline all the way up. */
const extruded = (outline, holes, height) =>
  lofted([{ outline, height: 0 }, { outline, height }], holes);

const boltHoles = [[-40, -18], [40, -18], [-40, 18], [40, 18]];

/** A plate with four holes for bolts and a large one; its upright edges are round. */
export const plate = () => extruded(roundRectangle(100, 60, 10, 8),
  [...boltHoles.map((centre) => circle(centre, 4, 24)), circle([0, 0], 18, 64)], 6);

/** The same whose bottom runs tangentially into a fillet. */
export function filletedPlate() {
  const [radius, steps] = [5, 6];
  const rows = Array.from({ length: steps + 1 }, (_, k) => {
    const turn = (Math.PI / 2) * (k / steps);
    const inwards = radius * (1 - Math.sin(turn));
    return { outline: roundRectangle(100 - 2 * inwards, 60 - 2 * inwards, 10 - inwards, 8),
      height: radius * (1 - Math.cos(turn)) };
  });
  return lofted([...rows, { outline: rows.at(-1).outline, height: 10 }],
    boltHoles.map((centre) => circle(centre, 3, 24)));
}

/** A wheel of teeth whose flanks are arcs, around a bore. */
export function gear({ teeth = 18 } = {}) {
  const outline = Array.from({ length: teeth }, (_, k) => {
    const at = (radius, turn) => [radius * Math.cos(turn), radius * Math.sin(turn)];
    const flank = (sign) => Array.from({ length: 5 }, (__, i) => {
      const rise = (sign < 0 ? i : 4 - i) / 4;
      return at(20 + 4 * rise, (2 * Math.PI * (k + sign * (0.28 - 0.14 * rise ** 2))) / teeth);
    });
    return [...flank(-1), ...flank(1)];
  }).flat();
  return extruded(outline, [circle([0, 0], 7, 40)], 8);
}

/** Outlines of letters, one cell of 1 × 1 each. */
const letters = [
  [[0.1, 0.1], [0.8, 0.1], [0.8, 0.3], [0.3, 0.3], [0.3, 0.9], [0.1, 0.9]],
  [[0.35, 0.1], [0.55, 0.1], [0.55, 0.7], [0.85, 0.7], [0.85, 0.9], [0.05, 0.9], [0.05, 0.7],
    [0.35, 0.7]],
  [[0.1, 0.1], [0.8, 0.1], [0.8, 0.25], [0.3, 0.25], [0.3, 0.4], [0.7, 0.4], [0.7, 0.58],
    [0.3, 0.58], [0.3, 0.75], [0.8, 0.75], [0.8, 0.9], [0.1, 0.9]],
];

/** A box with letters in its top, as deep as 0.2 % of its diagonal. Each begins a little higher
 * than the one before: the triangulation leaves out what touches between points of one line. */
export function engraved() {
  const outline = [[-40, -20], [40, -20], [40, 20], [-40, 20]];
  const height = 20;
  const depth = 0.002 * Math.hypot(80, 40, height);
  const holes = letters.map((letter, k) =>
    letter.map(([x, y]) => [24 * (x + k - 1.5), 24 * (y - 0.5) + k]));
  const places = [0, height].flatMap((z) => outline.map(([x, y]) => [x, y, z]));
  const corners = [...strip(0, 4, 4), [2, 1, 0, 3, 2, 0]];
  const names = [4, 5, 6, 7];
  for (const hole of holes) {
    const first = places.length;
    for (const z of [height - depth, height]) places.push(...hole.map(([x, y]) => [x, y, z]));
    corners.push(...strip(first + hole.length, first, hole.length),
      ...triangulated(hole, []).map((triangle) => triangle.map((v) => first + v)));
    names.push(...hole.map((_, k) => first + hole.length + k));
  }
  corners.push(...triangulated(outline, holes).map((triangle) => triangle.map((v) => names[v])));
  return meshOf(places, corners);
}

/** A bracket of sheet metal, bent twice. */
export function sheetMetal() {
  const [thickness, bend, segments] = [1.2, 3, 8];
  const along = (offset) => [[-50, offset], ...arc([-3, bend], bend - offset, [-0.25, 0],
    segments), ...arc([2 * bend - 3, 30], bend + offset, [0.5, 0.25], segments), [40, 33 + offset]];
  return extruded([...along(0), ...along(thickness).reverse()], [], 40);
}

/** What closes the ends of a thread: from its first and its last turn to discs.
 * @param {number} steps around @param {(i: number, j: number) => number} at
 * @param {{ rise: number, last: number, rings: [number, number] }} of rows: those of one turn, the
 *   last, and the first vertices of the discs' rims, whose centres come after both */
function threadEnds(steps, at, { rise, last, rings: [low, high] }) {
  const corners = [];
  for (let k = 0; k + 1 < steps; k += 1) {
    corners.push([low + k, low + k + 1, at(k + 1, 0)], [low + k, at(k + 1, 0), at(k, 0)],
      [at(k, last), at(k + 1, last), high + k + 1], [at(k, last), high + k + 1, high + k]);
  }
  const [first, end] = [at(steps - 1, 0), at(0, last)];
  corners.push([first, low + steps - 1, low], [first, low, at(0, 0)],
    [end, high, high + steps - 1], [end, high + steps - 1, at(steps - 1, last)]);
  for (let j = 0; j < rise; j += 1) {
    corners.push([first, at(0, j), at(0, j + 1)],
      [end, at(steps - 1, last - j), at(steps - 1, last - j - 1)]);
  }
  const centre = high + steps;
  for (let k = 0; k < steps; k += 1) {
    const next = (k + 1) % steps;
    corners.push([centre, low + next, low + k], [centre + 1, high + k, high + next]);
  }
  return corners;
}

/** A bolt without its head: a thread that begins and ends flush. */
export function thread({ turns = 6, steps = 48 } = {}) {
  const [core, depth, pitch] = [5, 1.2, 2];
  const profile = [[0, 0], [0.2, 0], [0.5, 1], [0.7, 1]];
  const rise = profile.length;
  const last = rise * turns;
  const around = (k, radius, z) => {
    const turn = (2 * Math.PI * k) / steps;
    return [radius * Math.cos(turn), radius * Math.sin(turn), z];
  };
  const at = (i, j) => (i < steps ? i * (last + 1) + j : j + rise);
  const places = Array.from({ length: steps * (last + 1) }, (_, n) => {
    const [i, j] = [Math.floor(n / (last + 1)), n % (last + 1)];
    const [along, height] = profile[j % rise];
    const turn = i / steps + Math.floor(j / rise) + along;
    const share = Math.min(1, Math.max(0, Math.min(turn - 1, turns - turn)));
    return around(i, core + depth * share * height, pitch * turn);
  });
  const corners = [];
  for (let i = 0; i < steps; i += 1) {
    for (let j = 0; j < (i + 1 < steps ? last : last - rise); j += 1) {
      corners.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)],
        [at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  }
  const [bottom, top] = [-pitch, pitch * (turns + 2)];
  const rings = [places.length, places.length + steps];
  for (const z of [bottom, top]) {
    places.push(...circle([0, 0], core, steps).map((p) => [...p, z]));
  }
  places.push([0, 0, bottom], [0, 0, top]);
  return meshOf(places, [...corners, ...threadEnds(steps, at, { rise, last, rings })]);
}
