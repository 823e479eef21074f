// SPDX-License-Identifier: MIT
// Points in the plane that one can drag.

/** @typedef {import('./stage.js').Point} Point */
/** @typedef {import('./stage.js').Stage} Stage */

/** Twice the area of a triangle; above 0 if its corners run counterclockwise.
 * @param {Point} a @param {Point} b @param {Point} c */
export const cross = (a, b, c) =>
  (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);

/** Lets the reader drag the nearest of the points. @param {Stage} stage @param {Point[]} points
 * @param {() => ReturnType<Stage['view']>} view
 * @param {(at: Point, which: number) => boolean} may */
export function draggable(stage, points, view, may) {
  let held = 0;
  stage.canvas.style.touchAction = 'none';
  stage.follow((pixels, isDown, began) => {
    const at = view().point(pixels);
    if (began) {
      const off = points.map((p) => Math.hypot(p[0] - at[0], p[1] - at[1]));
      held = off.indexOf(Math.min(...off));
    }
    if (isDown && may(at, held)) points[held] = at;
  });
}
