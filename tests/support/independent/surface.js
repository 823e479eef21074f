// SPDX-License-Identifier: MIT
// Figures of surfaces that were read without the engine. Equal positions are one vertex, to the
// last bit; what a report says is compared with these.
import { BoxTree } from './box_tree.js';
import { projectionOf, trianglesMeet } from './meeting.js';

/**
 * @typedef {object} Surface
 * @property {Float64Array} positions three numbers a place, all different
 * @property {Uint32Array} triangles three places each
 * @property {number} quads faces of four corners
 */

const keyOf = (x, y, z) => `${x + 0},${y + 0},${z + 0}`;

/** One surface of several parts, equal positions joined.
 * @param {{ positions: Float64Array, triangles: Uint32Array, quads: number }[]} parts
 * @returns {Surface} */
export function surfaceOf(parts) {
  const numbers = new Map();
  const positions = [];
  const numberOf = (x, y, z) => {
    const key = keyOf(x, y, z);
    if (!numbers.has(key)) {
      numbers.set(key, numbers.size);
      positions.push(x, y, z);
    }
    return numbers.get(key);
  };
  const triangles = parts.flatMap((part) => {
    const places = new Map();
    return Array.from(part.triangles, (v) => {
      if (!places.has(v)) places.set(v, numberOf(...part.positions.subarray(3 * v, 3 * v + 3)));
      return places.get(v);
    });
  });
  return { positions: Float64Array.from(positions), triangles: Uint32Array.from(triangles),
    quads: parts.reduce((sum, { quads }) => sum + quads, 0) };
}

/** @param {Surface} surface @param {number} v */
export const placeOf = ({ positions }, v) => positions.subarray(3 * v, 3 * v + 3);

/** Nine numbers for each triangle. @param {Surface} surface */
export function cornersOf({ positions, triangles }) {
  const corners = new Float64Array(3 * triangles.length);
  triangles.forEach((v, i) => corners.set(positions.subarray(3 * v, 3 * v + 3), 3 * i));
  return corners;
}

/** Whether a triangle has equal corners: reports count it as degenerate, and none of its edges.
 * @param {Surface} surface @param {number} t */
const isLine = ({ triangles }, t) => triangles[3 * t] === triangles[3 * t + 1]
  || triangles[3 * t + 1] === triangles[3 * t + 2] || triangles[3 * t + 2] === triangles[3 * t];

/** The triangles at each edge. @param {Surface} surface
 * @returns {Map<number, number[]>} by smaller · 2^26 + larger vertex */
export function edgesOf(surface) {
  const { triangles } = surface;
  const edges = new Map();
  triangles.forEach((from, i) => {
    if (isLine(surface, Math.floor(i / 3))) return;
    const to = triangles[i % 3 === 2 ? i - 2 : i + 1];
    const key = Math.min(from, to) * 2 ** 26 + Math.max(from, to);
    const list = edges.get(key);
    if (list) list.push(Math.floor(i / 3));
    else edges.set(key, [Math.floor(i / 3)]);
  });
  return edges;
}

/** The two ends of an edge's key. @param {number} key */
export const endsOf = (key) => [Math.floor(key / 2 ** 26), key % 2 ** 26];

class Sets {
  constructor(count) {
    this.above = Uint32Array.from({ length: count }, (_, i) => i);
  }

  find(i) {
    let root = i;
    while (this.above[root] !== root) root = this.above[root];
    for (let k = i; k !== root;) {
      const next = this.above[k];
      this.above[k] = root;
      k = next;
    }
    return root;
  }

  unite(i, k) {
    this.above[this.find(i)] = this.find(k);
  }
}

/** The pieces that chains of common edges join: for each the list of its triangles.
 * @param {Surface} surface @param {Map<number, number[]>} [edges] @returns {number[][]} */
export function piecesOf(surface, edges = edgesOf(surface)) {
  const count = surface.triangles.length / 3;
  const sets = new Sets(count);
  for (const list of edges.values()) list.slice(1).forEach((t) => sets.unite(t, list[0]));
  const pieces = new Map();
  for (let t = 0; t < count; t += 1) {
    if (isLine(surface, t)) continue;
    const root = sets.find(t);
    if (!pieces.has(root)) pieces.set(root, []);
    pieces.get(root).push(t);
  }
  return [...pieces.values()];
}

const difference = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const crossOf = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
  u[0] * v[1] - u[1] * v[0]];
const degrees = 180 / Math.PI;

/** Angles in degrees, and twice the area. @param {Float64Array[]} corners */
export function anglesOf([a, b, c]) {
  const twice = Math.hypot(...crossOf(difference(b, a), difference(c, a)));
  const at = (p, q, r) => {
    const [u, v] = [difference(q, p), difference(r, p)];
    return degrees * Math.atan2(twice, u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
  };
  return { angles: [at(a, b, c), at(b, c, a), at(c, a, b)], twice };
}

/** The corners' places of triangle t. @param {Surface} surface @param {number} t */
export const trianglePlaces = (surface, t) =>
  [0, 1, 2].map((k) => placeOf(surface, surface.triangles[3 * t + k]));

/** @param {Surface} surface */
export function angleFigures(surface) {
  const count = surface.triangles.length / 3;
  let [least, largest, sum, area] = [180, 0, 0, 0];
  for (let t = 0; t < count; t += 1) {
    const { angles, twice } = anglesOf(trianglePlaces(surface, t));
    const smallest = Math.min(...angles);
    least = Math.min(least, smallest);
    largest = Math.max(largest, ...angles);
    sum += smallest;
    area += twice / 2;
  }
  return { least: count > 0 ? least : 0, mean: count > 0 ? sum / count : 0, largest, area };
}

/** The volume that some triangles enclose, about a point near them so that far bodies lose no
 * digits. @param {Surface} surface @param {number[]} own triangles */
export function volumeOf(surface, own) {
  if (own.length === 0) return 0;
  const origin = Array.from(placeOf(surface, surface.triangles[3 * own[0]]));
  let sum = 0;
  for (const t of own) {
    const [a, b, c] = trianglePlaces(surface, t).map((p) => difference(p, origin));
    const n = crossOf(b, c);
    sum += a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
  }
  return sum / 6;
}

/** @param {Surface} surface the diagonal of its bounding box */
export function diagonalOf({ positions }) {
  const low = [Infinity, Infinity, Infinity], high = low.map((x) => -x);
  positions.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3], value);
    high[i % 3] = Math.max(high[i % 3], value);
  });
  return positions.length > 0 ? Math.hypot(...high.map((x, k) => x - low[k])) : 0;
}

/** The triangles without an area, exactly: two equal corners, or all on a line.
 * @param {Surface} surface */
export function degenerateOf(surface) {
  const found = [];
  for (let t = 0; t < surface.triangles.length / 3; t += 1) {
    if (!projectionOf(trianglePlaces(surface, t))) found.push(t);
  }
  return found;
}

/**
 * The triangles that meet others beyond shared vertices and edges, exactly, with one that each
 * meets. Triangles without an area meet nothing.
 * @param {Surface} surface
 * @param {ArrayLike<number>} [groups] one per triangle: those of one group do not count
 * @returns {Map<number, number>}
 */
export function crossingsOf(surface, groups) {
  const lines = new Set(degenerateOf(surface));
  const named = Array.from({ length: surface.triangles.length / 3 }, (_, t) =>
    ({ ids: [...surface.triangles.subarray(3 * t, 3 * t + 3)], at: trianglePlaces(surface, t) }));
  const corners = cornersOf(surface);
  const found = new Map();
  new BoxTree(corners).visitPairs((s, t) => {
    if (groups && groups[s] === groups[t]) return;
    if (!boxesMeet(corners, s, t) || (found.has(s) && found.has(t))) return;
    if (lines.has(s) || lines.has(t) || !trianglesMeet(named[s], named[t])) return;
    if (!found.has(s)) found.set(s, t);
    if (!found.has(t)) found.set(t, s);
  });
  return found;
}

function boxesMeet(corners, s, t) {
  for (let k = 0; k < 3; k += 1) {
    const [i, j] = [9 * s + k, 9 * t + k];
    if (Math.max(corners[i], corners[i + 3], corners[i + 6])
      < Math.min(corners[j], corners[j + 3], corners[j + 6])
      || Math.max(corners[j], corners[j + 3], corners[j + 6])
      < Math.min(corners[i], corners[i + 3], corners[i + 6])) return false;
  }
  return true;
}

/** The open edges as pairs of places, and the number of edges of more than two triangles.
 * @param {Surface} surface @param {Map<number, number[]>} [edges] */
export function borderOf(surface, edges = edgesOf(surface)) {
  const open = [];
  let nonManifold = 0;
  for (const [key, { length }] of edges) {
    if (length === 1) open.push(endsOf(key));
    if (length > 2) nonManifold += 1;
  }
  return { open, nonManifold };
}

/** The places of a loop in their order around it. @param {number[][]} edges @returns {number[]} */
export function orderedLoop(edges) {
  const next = new Map();
  for (const [a, b] of edges) {
    next.set(a, [...next.get(a) ?? [], b]);
    next.set(b, [...next.get(b) ?? [], a]);
  }
  const order = [edges[0][0]];
  const seen = new Set(order);
  for (let v = order[0]; v !== undefined;) {
    v = next.get(v).find((w) => !seen.has(w));
    if (v === undefined) break;
    order.push(v);
    seen.add(v);
  }
  return order;
}

/** The length of a closed polygon with `count` corners, evenly along a loop of straight edges.
 * @param {ArrayLike<number>[]} places around the loop @param {number} count */
export function chordLength(places, count) {
  const far = (p, q) => Math.hypot(...difference(p, q));
  const ends = places.map((p, i) => far(p, places[(i + 1) % places.length]));
  const whole = ends.reduce((sum, length) => sum + length, 0);
  let [i, passed] = [0, 0];
  const corners = Array.from({ length: count }, (_, k) => {
    const along = whole * (k / count);
    while (i + 1 < ends.length && passed + ends[i] <= along) {
      passed += ends[i];
      i += 1;
    }
    const share = ends[i] > 0 ? Math.min(1, (along - passed) / ends[i]) : 0;
    const to = places[(i + 1) % places.length];
    return [0, 1, 2].map((x) => places[i][x] + share * (to[x] - places[i][x]));
  });
  return corners.reduce((sum, p, k) => sum + far(p, corners[(k + 1) % count]), 0);
}

/** Pieces of the boundary: open edges joined at their ends, each with its length.
 * @param {Surface} surface @param {number[][]} open */
export function loopsOf(surface, open) {
  const sets = new Sets(surface.positions.length / 3);
  for (const [a, b] of open) sets.unite(a, b);
  const loops = new Map();
  for (const edge of open) {
    const root = sets.find(edge[0]);
    const loop = loops.get(root) ?? { edges: [], length: 0 };
    loop.edges.push(edge);
    loop.length += Math.hypot(...difference(placeOf(surface, edge[0]), placeOf(surface, edge[1])));
    loops.set(root, loop);
  }
  return [...loops.values()];
}
