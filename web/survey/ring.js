// SPDX-License-Identifier: MIT
// The loop in which a plane cuts a surface: a stroke across an arm is drawn on its front only, and
// the loop goes on behind.
import { Vector3 } from 'three';

/** @typedef {import('../triangles/soup.js').Soup} Soup */
/** @typedef {import('./surface.js').Point} Point */
/** @typedef {{ point: Point, ends: [string, string] }} Crossing of a triangle, by its edges */

/** Names vertices by their places, since seams and STL have several at one.
 * @param {Float32Array} positions @param {number} v */
const nameOf = (positions, v) =>
  `${positions[3 * v]} ${positions[3 * v + 1]} ${positions[3 * v + 2]}`;

/** The edges that the plane crosses: their points, and what lies beside each in a triangle.
 * @param {Soup} soup @param {(v: number) => number} heightOf above the plane */
function crossings({ positions, indices }, heightOf) {
  /** @type {Map<string, { point: Vector3, next: string[] }>} */
  const found = new Map();
  const heights = Float64Array.from({ length: positions.length / 3 }, (_, v) => heightOf(v));
  const cut = (/** @type {number} */ a, /** @type {number} */ b) => {
    const name = [nameOf(positions, a), nameOf(positions, b)].sort().join('|');
    if (!found.has(name)) {
      const [start, end] = [a, b].map((v) => new Vector3().fromArray(positions, 3 * v));
      found.set(name, { next: [],
        point: start.lerp(end, heights[a] / (heights[a] - heights[b])) });
    }
    return name;
  };
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = indices.subarray(i, i + 3);
    const sides = /** @type {[number, number][]} */ ([[a, b], [b, c], [c, a]])
      .filter(([s, t]) => (heights[s] < 0) !== (heights[t] < 0));
    if (sides.length !== 2) continue;
    const [one, other] = sides.map(([s, t]) => cut(s, t));
    found.get(one)?.next.push(other);
    found.get(other)?.next.push(one);
  }
  return found;
}

/** @param {Soup} soup
 * @param {{ through: Point, normal: Point }} plane through: a point of the ring
 * @returns {Point[] | null} null where the cut does not close */
export function ringOf(soup, { through, normal }) {
  const place = new Vector3(...through), up = new Vector3(...normal), point = new Vector3();
  const found = crossings(soup, (v) => up.dot(point.fromArray(soup.positions, 3 * v).sub(place)));
  let first = '', least = Infinity;
  for (const [name, { point: at }] of found) {
    const distance = at.distanceTo(place);
    if (distance < least) [first, least] = [name, distance];
  }
  const start = found.get(first);
  if (!start) return null;
  const ring = [start.point.toArray()];
  let [last, current] = [first, start.next[0]];
  while (current !== undefined && current !== first && ring.length <= found.size) {
    const { point: at, next } = found.get(current) ?? start;
    ring.push(at.toArray());
    [last, current] = [current, next[0] === last ? next[1] : next[0]];
  }
  return current === first && ring.length > 2 ? ring : null;
}
