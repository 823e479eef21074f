// SPDX-License-Identifier: MIT
// Algorithm 1: the edge between two triangles flips if the corner opposite lies within the circle
// through the three others.
import { cross, draggable } from './plane.js';
import { Stage } from './stage.js';

/** @typedef {import('./stage.js').Point} Point */

/** The circle through three points. @param {Point} a @param {Point} b @param {Point} c */
export function circleThrough(a, b, c) {
  const [bx, by, cx, cy] = [b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]];
  const [bb, cc, d] = [bx * bx + by * by, cx * cx + cy * cy, 2 * (bx * cy - by * cx)];
  const [x, y] = [(cy * bb - by * cc) / d, (bx * cc - cx * bb) / d];
  return { middle: /** @type {Point} */ ([a[0] + x, a[1] + y]), radius: Math.hypot(x, y) };
}

/** Whether the quadrilateral is to be cut from its second to its fourth corner, not from its first
 * to its third. @param {Point[]} corners counterclockwise */
export function flips([a, b, c, d]) {
  const { middle, radius } = circleThrough(a, b, c);
  return Math.hypot(d[0] - middle[0], d[1] - middle[1]) < radius;
}

/** @param {HTMLElement} figure */
export function delaunayFlipScene(figure) {
  /** @type {Point[]} */
  const corners = [[-0.9, -0.1], [0, -0.75], [0.95, 0.1], [0.1, 0.6]];
  const view = () => stage.view(0, 1, 1.2);
  const stage = new Stage(figure, 2, ({ context, canvas }) => {
    context.clearRect(0, 0, canvas.width, canvas.height);
    const [a, b, c, d] = corners, isFlipped = flips(corners);
    for (const triangle of isFlipped ? [[a, b, d], [b, c, d]] : [[a, b, c], [a, c, d]])
      view().polygon(triangle, 'face');
    const { middle, radius } = isFlipped ? circleThrough(a, b, d) : circleThrough(a, b, c);
    view().circle(middle, radius, 'other');
    for (const corner of corners) view().dot(corner, 'point');
  });
  draggable(stage, corners, view, (at, which) => {
    const moved = corners.with(which, at);
    return moved.every((p, i) => cross(p, moved[(i + 1) % 4], moved[(i + 2) % 4]) > 0.05);
  });
}
