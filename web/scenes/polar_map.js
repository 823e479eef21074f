// SPDX-License-Identifier: MIT
// The geodesic polar map: the triangles around a vertex, laid in the plane with their edges at the
// vertex as long as they are and their angles in proportion, so that these close up.
import { Solid } from './solid.js';
import { Stage } from './stage.js';

/** @typedef {import('./solid.js').Vector} Vector */
/** @typedef {import('./stage.js').Point} Point */

const away = (/** @type {Vector} */ a, /** @type {Vector} */ b) =>
  /** @type {Vector} */ (b.map((x, k) => x - a[k]));
const dot = (/** @type {Vector} */ a, /** @type {Vector} */ b) =>
  a.reduce((sum, x, k) => sum + x * b[k], 0);

/** Where the ring goes. @param {Vector} middle @param {Vector[]} ring in order around it */
export function polarMap(middle, ring) {
  const spokes = ring.map((p) => away(middle, p));
  const lengths = spokes.map((s) => Math.sqrt(dot(s, s)));
  const angles = spokes.map((s, i) => {
    const k = (i + 1) % spokes.length;
    return Math.acos(dot(s, spokes[k]) / lengths[i] / lengths[k]);
  });
  const total = angles.reduce((sum, angle) => sum + angle, 0);
  let angle = 0;
  return lengths.map((length, i) => {
    const at = /** @type {Point} */ ([length * Math.cos(angle), length * Math.sin(angle)]);
    angle += 2 * Math.PI * angles[i] / total;
    return at;
  });
}

/** @param {HTMLElement} figure */
export async function polarMapScene(figure) {
  const solid = await Solid.made({ vertices: 260, adaptivity: 0 });
  let chosen = solid.vertexAt([0.6, 0.2]);
  /** @type {Point | undefined} */
  let last;
  const stage = new Stage(figure, 2, ({ canvas }) => {
    const [left, right] = [stage.view(0, 2, 1.3), stage.view(1, 2, 0.32)];
    stage.context.clearRect(0, 0, canvas.width, canvas.height);
    solid.draw(left, (triangle) => triangle.includes(chosen));
    const flat = polarMap(solid.points[chosen], solid.ring(chosen).map((v) => solid.points[v]));
    flat.forEach((p, i) => right.polygon([[0, 0], p, flat[(i + 1) % flat.length]], 'chosen'));
    right.dot([0, 0], 'point');
  });
  stage.follow((at, isDown, began) => {
    if (isDown && last && !began)
      solid.drag([at[0] - last[0], at[1] - last[1]], stage.canvas.width / 2);
    last = at;
    if (!isDown) chosen = solid.vertexAt(stage.view(0, 2, 1.3).point(at));
  });
}
