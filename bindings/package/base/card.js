// SPDX-License-Identifier: MIT
// The report card: a run of a file in a few figures, before and after, from its report.

/** @typedef {import('./messages.js').Card} Card */
/** @typedef {import('./messages.js').CardSide} CardSide */
/** @typedef {import('./messages.js').MeshReport} MeshReport */

/**
 * @param {MeshReport} mesh @param {number} bytes
 * @param {number | undefined} selfIntersections @returns {CardSide}
 */
function sideOf(mesh, bytes, selfIntersections) {
  const { triangles, vertices, components, boundaryEdges, nonManifoldEdges, quads } = mesh;
  return { bytes, triangles, ...(quads ? { quads: quads.count } : {}), vertices,
    pieces: components, closed: boundaryEdges === 0, openEdges: boundaryEdges, nonManifoldEdges,
    ...(selfIntersections === undefined ? {} : { selfIntersections }) };
}

/** Percent of the diagonal; undefined if nothing was measured. A sound file is unchanged.
 * @param {any} report */
const distanceOf = ({ fidelity, repair }) =>
  fidelity?.hausdorff ?? (repair?.reason === 'sound' ? 0 : undefined);

/**
 * @param {any} report of a run
 * @param {{ before: number, after: number, coverage?: number }} files bytes of those that were
 *   read and written; coverage: of new textures
 * @returns {Card}
 */
export function cardOf(report, { before, after, coverage }) {
  const { input, output, repair, dropped, diagonal, unit } = report;
  const percent = distanceOf(report);
  const [meetingBefore, meetingAfter] = repair?.selfIntersections ?? [];
  return {
    before: sideOf(input, before, meetingBefore),
    after: sideOf(output, after, meetingAfter),
    ...(percent === undefined ? {} : { distance: { percent, length: percent / 100 * diagonal,
      ...(unit === undefined ? {} : { unit }) } }),
    ...(dropped ? { hidden: dropped.hidden } : {}),
    ...(coverage === undefined ? {} : { coverage }),
  };
}
