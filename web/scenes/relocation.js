// SPDX-License-Identifier: MIT
// Where a vertex goes within its neighbours: to the place where the areas around it are nearest to
// their shares, in the sense of least squares, or to the mean of the neighbours.
import { cross, draggable } from './plane.js';
import { Stage } from './stage.js';

/** @typedef {import('./stage.js').Point} Point */

/** The place where the areas of the triangles around it differ least from their mean: each area is
 * linear in the place, so two equations give it. @param {Point[]} ring counterclockwise
 * @returns {Point} */
export function evenAreas(ring) {
  const total = ring.reduce((sum, p, i) => sum + cross([0, 0], p, ring[(i + 1) % ring.length]), 0);
  let [xx, xy, yy, x, y] = [0, 0, 0, 0, 0];
  ring.forEach((p, i) => {
    const q = ring[(i + 1) % ring.length];
    // Twice the area at (s, t) is constant + a s + b t.
    const [a, b, constant] = [p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]];
    const missing = total / ring.length - constant;
    xx += a * a;
    xy += a * b;
    yy += b * b;
    x += a * missing;
    y += b * missing;
  });
  const determinant = xx * yy - xy * xy;
  return [(x * yy - y * xy) / determinant, (y * xx - x * xy) / determinant];
}

/** @param {Point[]} ring @returns {Point} */
export const meanOf = (ring) => {
  const mean = (/** @type {0 | 1} */ k) => ring.reduce((sum, p) => sum + p[k], 0) / ring.length;
  return [mean(0), mean(1)];
};

/** @param {HTMLElement} figure */
export function relocationScene(figure) {
  /** @type {Point[]} */
  const ring = [[0.9, 0], [0.75, 0.55], [0.3, 0.75], [-0.9, 0.4], [-0.6, -0.7], [0.7, -0.6]];
  const view = () => stage.view(0, 1, 1.1);
  const stage = new Stage(figure, 2, ({ context, canvas }) => {
    context.clearRect(0, 0, canvas.width, canvas.height);
    const middle = evenAreas(ring);
    ring.forEach((p, i) => view().polygon([middle, p, ring[(i + 1) % ring.length]], 'face'));
    view().dot(meanOf(ring), 'other');
    view().dot(middle, 'point');
    for (const p of ring) view().dot(p, 'line');
  });
  draggable(stage, ring, view, (at, which) => {
    const moved = ring.with(which, at);
    const middle = evenAreas(moved);
    return moved.every((p, i) => cross(middle, p, moved[(i + 1) % moved.length]) > 0.01);
  });
}
