// SPDX-License-Identifier: MIT
// How much of the sharp edges of a broken surface its repaired surface still has: only edges that
// are seen from outside count, for those within other bodies have to go.
import { BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';

const sharp = Math.cos(40 * Math.PI / 180);
/** Shares of the diagonal: from one sample of an edge to the next; how near an edge of the result
 * must be; how far beside an edge, and off the surface, an eye is. */
const [apart, near, beside] = [0.003, 0.0015, 0.0002];
const directions = Array.from({ length: 32 }, (_, i) => {
  const z = 1 - (2 * i + 1) / 32;
  const turn = i * Math.PI * (3 - Math.sqrt(5));  // the golden angle
  return new Vector3(Math.cos(turn), Math.sin(turn), 0).multiplyScalar(Math.sqrt(1 - z * z))
    .setZ(z);
});

/** The triangles as corners, those at one place the same number. */
function welded({ positions, indices }) {
  const numbers = new Map();
  const points = [];
  const numberOf = (/** @type {number} */ v) => {
    const place = positions.subarray(3 * v, 3 * v + 3);
    const name = place.join();
    if (!numbers.has(name)) numbers.set(name, points.push(new Vector3(...place)) - 1);
    return numbers.get(name);
  };
  const triangles = Array.from({ length: indices.length / 3 }, (_, t) =>
    Array.from(indices.subarray(3 * t, 3 * t + 3), numberOf));
  return { points, triangles: triangles.filter((t) => new Set(t).size === 3) };
}

function normalOf(points, [a, b, c]) {
  const side = points[c].clone().sub(points[a]);
  return points[b].clone().sub(points[a]).cross(side).normalize();
}

/** Edges of two triangles more than 40° apart: their ends, and the triangles. */
function sharpEdges({ points, triangles }) {
  const around = new Map();
  for (const t of triangles) {
    for (let k = 0; k < 3; k += 1) {
      const ends = [t[k], t[(k + 1) % 3]].sort((a, b) => a - b);
      const name = ends.join();
      if (!around.has(name)) around.set(name, { ends: ends.map((v) => points[v]), beside: [] });
      around.get(name).beside.push(t);
    }
  }
  return [...around.values()].filter(({ beside: [one, two, ...more] }) => two && more.length === 0
    && normalOf(points, one).dot(normalOf(points, two)) < sharp);
}

/** Points along an edge, at most `step` apart, each with the length that it stands for. */
function samplesOf([from, to], step) {
  const length = from.distanceTo(to);
  const count = Math.max(1, Math.ceil(length / step));
  return Array.from({ length: count }, (_, i) =>
    ({ at: from.clone().lerp(to, (i + 0.5) / count), length: length / count }));
}

/** Tells whether a point is seen from outside, in any of the directions. @returns {any} */
function outlook({ points, triangles }) {
  const geometry = new BufferGeometry().setIndex(triangles.flat());
  geometry.setAttribute('position',
    new BufferAttribute(new Float64Array(points.flatMap((p) => p.toArray())), 3));
  const tree = new MeshBVH(geometry);
  const isOpen = (at, direction) => !tree.raycastFirst(new Ray(at, direction), DoubleSide);
  return (at) => directions.some((direction) => isOpen(at, direction));
}

/** Per triangle at an edge, the steps from the edge to two eyes beside it, one on either side. */
function stepsToEyes({ ends: [from, to], beside: both }, points, step) {
  const along = to.clone().sub(from).normalize();
  return both.map((t) => {
    const normal = normalOf(points, t);
    const tip = points[t.find((v) => points[v] !== from && points[v] !== to)].clone().sub(from);
    const inward = tip.addScaledVector(along, -tip.dot(along)).setLength(step);
    return [1, -1].map((side) => inward.clone().addScaledVector(normal, side * step / 2));
  });
}

/** Finds out whether any of the points is nearer than `reach`. */
function neighbourhood(points, reach) {
  const cells = new Map();
  const cellOf = (p) => p.toArray().map((x) => Math.floor(x / reach));
  for (const p of points) {
    const name = cellOf(p).join();
    cells.set(name, [...(cells.get(name) ?? []), p]);
  }
  const steps = [-1, 0, 1];
  return (at) => {
    const [x, y, z] = cellOf(at);
    return steps.some((i) => steps.some((k) => steps.some((l) =>
      cells.get([x + i, y + k, z + l].join())?.some((p) => p.distanceTo(at) < reach))));
  };
}

/** The samples of the seen sharp edges, and the diagonal. @param {any} mesh */
export function seenSharpEdges(mesh) {
  const surface = welded(mesh);
  const box = surface.points.reduce(([low, high], p) => [low.min(p), high.max(p)],
    [surface.points[0].clone(), surface.points[0].clone()]);
  const diagonal = box[0].distanceTo(box[1]);
  const isOpen = outlook(surface);
  const samples = sharpEdges(surface).flatMap((edge) => {
    const eyes = stepsToEyes(edge, surface.points, beside * diagonal);
    return samplesOf(edge.ends, apart * diagonal).filter(({ at }) =>
      eyes.every((pair) => pair.some((step) => isOpen(at.clone().add(step)))));
  });
  return { samples, diagonal };
}

/** The percentage of the seen sharp edges that the result has. */
export function percentFound({ samples, diagonal }, result) {
  const step = near * diagonal / 5;
  const isNear = neighbourhood(sharpEdges(welded(result)).flatMap(({ ends }) =>
    samplesOf(ends, step).map(({ at }) => at)), near * diagonal);
  const lengthOf = (some) => some.reduce((sum, { length }) => sum + length, 0);
  return 100 * lengthOf(samples.filter(({ at }) => isNear(at))) / lengthOf(samples);
}
