// SPDX-License-Identifier: MIT
// Whether two triangles have a common point beyond the vertices and edges they share, decided
// exactly. Corners are points with a number: equal numbers are equal places.
import { orient2, orient3 } from './exact.js';

/** @typedef {{ at: Float64Array[], ids: number[] }} Triangle */

const planes = [[1, 2], [2, 0], [0, 1]];

/** Two axes onto which a triangle projects with an area; none for a line.
 * @param {Float64Array[]} at */
export function projectionOf([a, b, c]) {
  const u = [0, 1, 2].map((k) => b[k] - a[k]);
  const v = [0, 1, 2].map((k) => c[k] - a[k]);
  const areas = planes.map(([x, y]) => Math.abs(u[x] * v[y] - u[y] * v[x]));
  const order = [0, 1, 2].sort((p, q) => areas[q] - areas[p]);
  return order.map((k) => planes[k]).find((axes) => orient2(a, b, c, axes) !== 0);
}

const between = (a, b, x) => (a <= x && x <= b) || (b <= x && x <= a);

function onSegment(p, a, b, axes) {
  return axes.every((k) => between(a[k], b[k], p[k]));
}

/** Closed segments in a plane. */
function segmentsMeet([p, q], [a, b], axes) {
  const [sp, sq] = [orient2(a, b, p, axes), orient2(a, b, q, axes)];
  const [sa, sb] = [orient2(p, q, a, axes), orient2(p, q, b, axes)];
  if (sp * sq < 0 && sa * sb < 0) return true;
  return (sp === 0 && onSegment(p, a, b, axes)) || (sq === 0 && onSegment(q, a, b, axes))
    || (sa === 0 && onSegment(a, p, q, axes)) || (sb === 0 && onSegment(b, p, q, axes));
}

/** A point and a closed triangle in a plane. */
function isInside(p, [a, b, c], axes) {
  const signs = [orient2(a, b, p, axes), orient2(b, c, p, axes), orient2(c, a, p, axes)];
  return !(signs.includes(1) && signs.includes(-1));
}

/** A closed segment and a closed triangle with an area. */
function segmentMeets([p, q], at) {
  const [a, b, c] = at;
  const [sp, sq] = [orient3(a, b, c, p), orient3(a, b, c, q)];
  if (sp * sq > 0) return false;
  if (sp === 0 && sq === 0) {
    const axes = projectionOf(at);
    return isInside(p, at, axes) || isInside(q, at, axes)
      || [[a, b], [b, c], [c, a]].some((side) => segmentsMeet([p, q], side, axes));
  }
  const signs = [orient3(p, q, a, b), orient3(p, q, b, c), orient3(p, q, c, a)];
  return !(signs.includes(1) && signs.includes(-1));
}

/** Common edge: they meet beyond it where they lie in one plane on the same side of it. */
function overlapAtEdge(one, other, shared) {
  const [p, q] = one.ids.flatMap((id, i) => (shared.includes(id) ? [one.at[i]] : []));
  const a = one.at[one.ids.findIndex((id) => !shared.includes(id))];
  const b = other.at[other.ids.findIndex((id) => !shared.includes(id))];
  const axes = projectionOf(one.at);
  if (orient2(p, q, a, axes) * orient2(p, q, b, axes) <= 0) return false;
  return orient3(p, q, a, b) === 0;
}

/** The side opposite a corner. */
const opposite = ({ at, ids }, id) => at.filter((_, i) => ids[i] !== id);

const sides = ({ at: [a, b, c] }) => [[a, b], [b, c], [c, a]];

/** Whether all points are strictly on one side of a triangle's plane. */
const isBeside = (points, [a, b, c]) => {
  const first = orient3(a, b, c, points[0]);
  return first !== 0 && points.slice(1).every((p) => orient3(a, b, c, p) === first);
};

/** Both triangles have an area. @param {Triangle} one @param {Triangle} other */
export function trianglesMeet(one, other) {
  const shared = one.ids.filter((id) => other.ids.includes(id));
  if (shared.length === 3) return true;
  if (shared.length === 2) return overlapAtEdge(one, other, shared);
  if (shared.length === 1) {
    const [far, near] = [opposite(other, shared[0]), opposite(one, shared[0])];
    if (isBeside(far, one.at) || isBeside(near, other.at)) return false;
    return segmentMeets(near, other.at) || segmentMeets(far, one.at);
  }
  if (isBeside(other.at, one.at) || isBeside(one.at, other.at)) return false;
  return sides(one).some((side) => segmentMeets(side, other.at))
    || sides(other).some((side) => segmentMeets(side, one.at));
}
