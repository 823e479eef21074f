// SPDX-License-Identifier: MIT
// Lines that the visitor draws on the model, and that quads follow. Their points are on the
// original, relative to the stage's origin.

/** @typedef {[number, number, number]} Point */
/** direction: quads lie along it; loop: a closed line that becomes sides of quads.
 * @typedef {{ kind: 'direction' | 'loop', points: Point[] }} Stroke */

const kinds = ['direction', 'loop'];

/** @param {any} point */
const isPoint = (point) => Array.isArray(point) && point.length === 3
  && point.every(Number.isFinite);

/** @param {any} stroke @returns {stroke is Stroke} */
const isStroke = (stroke) => kinds.includes(stroke?.kind) && Array.isArray(stroke.points)
  && stroke.points.length >= (stroke.kind === 'loop' ? 3 : 2) && stroke.points.every(isPoint);

/** Whether a value is a list of strokes. @param {unknown} value @returns {value is Stroke[]} */
export const areStrokes = (value) => Array.isArray(value) && value.every(isStroke);

/** @param {Point} a @param {Point} b */
const between = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

/** @param {Point[]} points */
export const lengthOf = (points) =>
  points.slice(1).reduce((sum, point, i) => sum + between(points[i], point), 0);

/** Whether a line ends near where it begins, by its length: whoever draws so means it closed.
 * @param {Point[]} points */
export function isRound(points) {
  return points.length > 3
    && between(points[0], points[points.length - 1]) < lengthOf(points) / 5;
}

/** A line without points that are nearer than this to the one before; its ends stay.
 * @param {Point[]} points @param {number} least */
export function thinned(points, least) {
  /** @type {Point[]} */
  const kept = [];
  for (const point of points) {
    if (!kept.length || between(kept[kept.length - 1], point) >= least) kept.push(point);
  }
  if (kept.length > 1) kept[kept.length - 1] = points[points.length - 1];
  return kept;
}

/** A line's points, with the first again at the end of a loop. @param {Stroke} stroke */
const wholeOf = ({ kind, points }) => (kind === 'loop' ? [...points, points[0]] : points);

/** The distance of a point from a side. @param {Point} point @param {Point} a @param {Point} b */
function distanceTo(point, a, b) {
  const along = b.map((x, k) => x - a[k]), own = point.map((x, k) => x - a[k]);
  const squared = along.reduce((sum, x) => sum + x * x, 0);
  const share = squared ? own.reduce((sum, x, k) => sum + x * along[k], 0) / squared : 0;
  const at = Math.min(1, Math.max(0, share));
  return Math.hypot(...own.map((x, k) => x - at * along[k]));
}

/** The strokes that keep this distance from a point.
 * @param {Stroke[]} strokes @param {Point} point @param {number} reach */
export const without = (strokes, point, reach) => strokes.filter((stroke) => {
  const points = wholeOf(stroke);
  return points.slice(1).every((end, i) => distanceTo(point, points[i], end) > reach);
});

/** A stroke mirrored in the plane at x. @param {Stroke} stroke @param {number} x
 * @returns {Stroke} */
export const mirrored = ({ kind, points }, x) =>
  ({ kind, points: points.map(([px, py, pz]) => [2 * x - px, py, pz]) });

/** Pairs of points, six numbers each, of all strokes of a kind.
 * @param {Stroke[]} strokes @param {Stroke['kind']} kind */
export function segmentsOf(strokes, kind) {
  return Float32Array.from(strokes.filter((stroke) => stroke.kind === kind).flatMap((stroke) => {
    const points = wholeOf(stroke);
    return points.slice(1).flatMap((end, i) => [...points[i], ...end]);
  }));
}

/** Strokes as the engine takes them. @param {Stroke[]} strokes @param {Point} origin of the stage
 * @returns {import('remesher').Guide[]} */
export const guidesOf = (strokes, origin) => strokes.map((stroke) => ({ kind: stroke.kind,
  points: wholeOf(stroke).map((point) => point.map((x, k) => x + origin[k])) }));

/** Guides as an OBJ file, which the command line takes.
 * @param {readonly import('remesher').Guide[]} guides */
export function objOf(guides) {
  let before = 0;
  return guides.map(({ kind, points }, i) => {
    const places = /** @type {number[][]} */ (points);
    const numbers = places.map((_, k) => before + k + 1);
    before += places.length;
    return [`o ${kind} ${i + 1}`, ...places.map((place) => `v ${place.join(' ')}`),
      `l ${numbers.join(' ')}`, ''].join('\n');
  }).join('');
}
