// SPDX-License-Identifier: MIT
// The law "continuity": of neighbouring numbers of vertices no error is several times that of its
// neighbour without a reason in the report. With fewer vertices than its exact shape needs, at most
// those of the original, no surface need be as good as with these; with more it must.

const most = 3; // times the neighbour's
const floor = 0.05; // % of the diagonal: what nobody sees
const exact = 1e-6; // % of the diagonal: nothing but rounding

/** Codes of warnings that give a reason for a larger error. */
const reasons = ['TOO_FEW_VERTICES', 'MAX_ERROR_EXCEEDED', 'SHAPE_LOST_TO_ROUNDING',
  'SPIKES_LEFT_COARSE', 'JOINTS_RELEASED', 'SHAPE_SIMPLIFIED', 'QUADS_TOO_FEW',
  'SHAPE_TAKES_MORE'];

/** A rule of the report's that another mesh was taken than by the neighbour's rule, and why. */
const otherMesh = 'resampled';

/** Whether a mesh was chosen by that rule: `chosen` is a list if the report has several. */
const isOther = ({ chosen }) => [chosen ?? []].flat().some(({ rule }) => rule === otherMesh);
const tookOther = (low, high) => isOther(high) && !isOther(low);

/**
 * The broken laws. @param {{ asked: number, report: any }[]} runs of neighbouring numbers
 */
export function lawsOfNeighbours(runs) {
  const broken = [];
  for (let i = 1; i < runs.length; i += 1) {
    const pair = [runs[i - 1], runs[i]]
      .sort((a, b) => a.report.fidelity.hausdorff - b.report.fidelity.hausdorff);
    const [low, high] = pair.map(({ report }) => report.fidelity.hausdorff);
    const isSaid = pair[1].report.stopped !== 'target' || pair[1].report.warnings.some(
      (/** @type {any} */ { code }) => reasons.includes(code))
      || tookOther(pair[0].report, pair[1].report);
    const own = pair[0].report.input?.vertices;
    const isWhole = pair[0].asked >= own || (low < exact && pair[0].asked < own);
    const isTooFew = isWhole && pair[1].asked < Math.min(pair[0].asked, own);
    if (high > most * low && high - low > floor && !isSaid && !isTooFew) {
      broken.push(`${high.toFixed(3)} % at ${pair[1].asked} vertices, ${low.toFixed(3)} % at ${
        pair[0].asked}`);
    }
  }
  return broken;
}
