// SPDX-License-Identifier: MIT
// A disk patch: triangles around a vertex, as far as they form a disk, and their map to the unit
// disk. The boundary goes to the circle by its lengths; each inner vertex lies at the mean of its
// neighbours, so that no triangle folds over [Tutte 1963].
import { Solid } from './solid.js';
import { Stage } from './stage.js';

/** @typedef {import('./solid.js').Vector} Vector */
/** @typedef {import('./stage.js').Point} Point */

const sweeps = 400;

/** The boundary of triangles as one loop, or undefined. @param {Vector[]} triangles */
export function loopAround(triangles) {
  /** @type {Map<number, number>} */
  const next = new Map();
  for (const [a, b, c] of triangles) {
    for (const [from, to] of [[a, b], [b, c], [c, a]]) {
      const hasTwin = triangles.some((t) => t.some((v, k) => v === to && t[(k + 1) % 3] === from));
      if (hasTwin) continue;
      if (next.has(from)) return undefined;
      next.set(from, to);
    }
  }
  const loop = [next.keys().next().value ?? 0];
  for (let v = next.get(loop[0]); v !== undefined && v !== loop[0]; v = next.get(v)) loop.push(v);
  return loop.length === next.size ? loop : undefined;
}

/** Adds rings of triangles for as long as they form a disk.
 * @param {Solid} solid @param {number} middle @param {number} rings */
export function grownDisk(solid, middle, rings) {
  let patch = solid.triangles.filter((triangle) => triangle.includes(middle));
  for (let ring = 1; ring < rings; ++ring) {
    const inside = new Set(patch.flat());
    const grown = solid.triangles.filter((triangle) => triangle.some((v) => inside.has(v)));
    if (!loopAround(grown)) break;
    patch = grown;
  }
  return patch;
}

/** Where the vertices of a disk go in the unit disk.
 * @param {Solid} solid @param {Vector[]} patch */
export function flattened(solid, patch) {
  const loop = loopAround(patch) ?? [];
  const steps = loop.map((v, i) => {
    const [p, q] = [solid.points[v], solid.points[loop[(i + 1) % loop.length]]];
    return Math.hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  });
  const total = steps.reduce((sum, step) => sum + step, 0);
  /** @type {Map<number, Point>} */
  const places = new Map();
  let angle = 0;
  loop.forEach((v, i) => {
    places.set(v, [Math.cos(angle), Math.sin(angle)]);
    angle += 2 * Math.PI * steps[i] / total;
  });
  const inner = [...new Set(patch.flat())].filter((v) => !places.has(v));
  for (const v of inner) places.set(v, [0, 0]);
  const rings = new Map(inner.map((v) => [v, solid.ring(v)]));
  for (let sweep = 0; sweep < sweeps; ++sweep) {
    for (const [v, ring] of rings) {
      const mean = (/** @type {0 | 1} */ k) =>
        ring.reduce((sum, w) => sum + (places.get(w)?.[k] ?? 0), 0) / ring.length;
      places.set(v, [mean(0), mean(1)]);
    }
  }
  return places;
}

/** @param {HTMLElement} figure */
export async function diskPatchScene(figure) {
  const solid = await Solid.made({ vertices: 500, adaptivity: 0 });
  let middle = solid.vertexAt([0.7, -0.3]), rings = 4;
  /** @type {Point | undefined} */
  let last;
  const stage = new Stage(figure, 2, ({ canvas }) => {
    stage.context.clearRect(0, 0, canvas.width, canvas.height);
    const patch = grownDisk(solid, middle, rings), own = new Set(patch);
    const places = flattened(solid, patch);
    solid.draw(stage.view(0, 2, 1.3), (triangle) => own.has(triangle));
    const right = stage.view(1, 2, 1.1);
    for (const triangle of patch)
      right.polygon(triangle.map((v) => places.get(v) ?? [0, 0]), 'chosen');
  });
  stage.slider('Rings', { min: 1, max: 12, step: 1, value: rings }, (value) => {
    rings = value;
    stage.redraw();
  });
  stage.follow((at, isDown, began) => {
    if (isDown && last && !began)
      solid.drag([at[0] - last[0], at[1] - last[1]], stage.canvas.width / 2);
    last = at;
    if (!isDown) middle = solid.vertexAt(stage.view(0, 2, 1.3).point(at));
  });
}
