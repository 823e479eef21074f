// SPDX-License-Identifier: MIT
// The law "never worse": a repair loses no volume and no body, opens nothing, and returns a sound
// file bit for bit; remeshing keeps every boundary loop where it was. Judged by written bytes, read
// without the engine. Returns the broken laws in words.
import { Dice } from '../../fuzz/dice.js';
import { closedPieces, isSound, pointsIn, treeOf, windingAt } from '../independent/bodies.js';
import { BoxTree } from '../independent/box_tree.js';
import { borderOf, chordLength, diagonalOf, loopsOf, orderedLoop, placeOf }
  from '../independent/surface.js';
import { warningOf } from './said.js';
import { differences } from './same.js';

const mostBodies = 40;
const pointsPerBody = 40;

/** Warnings that say that a body is gone. */
const losses = ['SCRAPS_REMOVED', 'SHELLS_REMOVED', 'BODIES_REMOVED', 'SEEN_PARTS_LOST',
  'SHEETS_DROPPED'];

/** Share of the diagonal within which a mesh is the same. */
const sameRounding = 1e-9;

/** Share of a body's points that may be missing: those beside its surface. */
const missing = 0.05;

function lawsOfBodies(before, after, report) {
  const pieces = closedPieces(before);
  if (pieces.length === 0 || after.triangles.length === 0) return [];
  const matter = treeOf(before, pieces.flat());
  const made = treeOf(after, Array.from({ length: after.triangles.length / 3 }, (_, t) => t));
  const dice = new Dice(1);
  const broken = [];
  for (const own of pieces.slice(0, mostBodies)) {
    const points = pointsIn({ tree: treeOf(before, own), matter }, dice, pointsPerBody);
    if (points.length < pointsPerBody / 2) continue;
    const lost = points.filter((p) => windingAt(made, p) === 0).length / points.length;
    const isSaid = lost > 0.9 && warningOf(report, ...losses);
    if (lost > missing && !isSaid) {
      broken.push(`${Math.round(100 * lost)} % of the volume of a body of ${own.length} triangles `
        + `near (${[...placeOf(before, before.triangles[3 * own[0]])].join(', ')}) is lost`);
    }
  }
  return broken;
}

/** Distance from the boundary at which a vertex of a boundary may lie, as a share of the diagonal;
 * three times as much with fewer vertices than before. */
const chord = 1e-3;

function lawsOfPlaces(before, open, after, border) {
  const most = (after.positions.length < before.positions.length ? 3 : 1) * chord;
  const segments = new BoxTree(Float64Array.from(open.flatMap(([a, b]) =>
    [a, b, b].flatMap((v) => [...placeOf(before, v)]))));
  const diagonal = diagonalOf(before);
  const vertices = new Set(border.flat());
  const away = [...vertices].map((v) => ({ v, far: segments.distance(placeOf(after, v)) }))
    .filter(({ far }) => far > most * diagonal).sort((a, b) => b.far - a.far);
  if (away.length === 0) return [];
  const [{ v, far }] = away;
  return [`${away.length} of ${vertices.size} vertices of boundaries are off them, by up to `
    + `${(100 * far / diagonal).toFixed(3)} % of the diagonal near (${
      [...placeOf(after, v)].join(', ')})`];
}

/** Share of a loop's length that may be lost or added beyond its chords. */
const lengthRounding = 0.005;

/** The least length of a loop of so many edges: as much shorter again as even chords are. */
function leastLength(surface, { edges, length }, count) {
  const places = orderedLoop(edges).map((v) => placeOf(surface, v));
  return 2 * chordLength(places, count) - (1 + lengthRounding) * length;
}

function lawsOfLengths(before, loopsBefore, loops) {
  if (loopsBefore.length !== loops.length) {
    return [`${loopsBefore.length} boundary loops before, ${loops.length} written`];
  }
  const inOrder = (list) => [...list].sort((a, b) => b.length - a.length);
  const [was, is] = [inOrder(loopsBefore), inOrder(loops)];
  return is.flatMap(({ length, edges }, i) => {
    if (length <= (1 + lengthRounding) * was[i].length
      && length >= leastLength(before, was[i], edges.length)) return [];
    return [`a boundary loop of ${was[i].length} is ${length} long, of ${edges.length} edges`];
  });
}

/** @param {any} before @param {any} written figures @param {any} report */
function lawsOfBoundaries(before, written, report) {
  const { open } = borderOf(before.surface);
  // Where the engine joins what rounding kept apart, its boundary is another.
  if (open.length === 0 || before.nonManifoldEdges > 0
    || report.input.boundaryEdges !== before.boundaryEdges) return [];
  const border = borderOf(written.surface).open;
  if (border.length === 0) return ['all boundary loops are closed'];
  // Places off the boundary are counted where the report speaks of them.
  const isSaid = warningOf(report, 'QUADS_OFF_BORDER');
  return [...(isSaid ? [] : lawsOfPlaces(before.surface, open, written.surface, border)),
    ...lawsOfLengths(before.surface, loopsOf(before.surface, open),
      loopsOf(written.surface, border))];
}

/**
 * @param {any} before @param {any} written figures of both files
 * @param {{ report: any, isRepair?: boolean, sameBytes?: boolean }} run isRepair: nothing but a
 *   repair into the same format; sameBytes: both files are equal
 */
export function lawsOfHarm(before, written, { report, isRepair = false, sameBytes = false }) {
  if (report.repair && !isRepair) return [];
  if (!isRepair) return lawsOfBoundaries(before, written, report);
  const broken = lawsOfBodies(before.surface, written.surface, report);
  if (written.boundaryEdges > before.boundaryEdges) {
    broken.push(`${before.boundaryEdges} open edges before, ${written.boundaryEdges} written`);
  }
  if (!sameBytes && isSound(before)) {
    const isSame = differences(before.surface, written.surface, sameRounding).length === 0;
    broken.push(isSame ? 'nothing was wrong, and the same mesh is written in other bytes'
      : `nothing was wrong, and the mesh is another: ${before.triangles} triangles before, `
        + `${written.triangles} written`);
  }
  return broken;
}
