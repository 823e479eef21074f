// SPDX-License-Identifier: MIT
// The verdict on a result in words: closed or not, how far from the original, how large, what was
// repaired and what was lost, with places to look at.
import { element } from '../base/dom.js';
import { count, degrees, fileSize, length, percent, wholePercent } from '../base/format.js';
import { t } from '../base/i18n.js';
import { wasRepaired } from '../model/names.js';
import { distanceIn, lengthIn } from '../model/units.js';

/** @typedef {import('../model/result.js').Report} Report */
/** @typedef {import('../model/units.js').Scale} Scale */

/** report, values: of the result; largest: the largest distance from the original in the model's
 * units, null while it is not known; exact: triangles that keep all corners of flat sides, or 0;
 * edges: lengths of its edges, as soon as they are known; maps: titles of its new textures; size:
 * bytes of the file to download, null if not known; original: bytes of the model.
 * @typedef {{ report: Report, values: import('../model/address.js').Values, scale: Scale,
 *   diagonal: number, largest: number | null, exact: number,
 *   edges?: import('../survey/surface.js').Distances['edges'], format: string,
 *   maps: string[], size: number | null, original: number }} Judged */

/** @typedef {{ onLargest: () => void, onPlace: (place: [number, number, number]) => void,
 *   onThicken: () => void, onWithin: () => void, onExact: () => void, onMore: () => void,
 *   onShorter: () => void, onMaps: () => void, onNotes: () => void }} VerdictActs */

/** @typedef {{ kind: 'good' | 'bad' | 'plain', text: string,
 *   act?: { label: string, run: () => void } | null }} Line */

/** Percent of the diagonal: anyone sees a larger distance. */
export const seenByAnyone = 0.5;
/** A share of the diagonal that is rounding alone. */
const nothing = 1e-6;
/** Degrees: smaller angles make solvers slow or wrong. */
const smallAngle = 20;
/** A file larger by this is not said in percent of the original's; percent within which a file is
 * as large as the original. */
const most = 2, alike = 0.5;
/** Percent of the area: less is not worth a word. */
const leastLoss = 0.005;

/** @param {Judged} judged @param {VerdictActs} acts @returns {Line} */
function closedLine({ report: { output }, values }, { onThicken }) {
  const { boundaryEdges, nonManifoldEdges } = output;
  const needs = values.purpose === 'print' || values.purpose === 'simulation';
  if (boundaryEdges) {
    return { kind: needs ? 'bad' : 'plain',
      text: t('verdict.open', { count: count(boundaryEdges) }),
      act: needs && values.repair === 'auto'
        ? { label: t('verdict.thicken'), run: onThicken } : null };
  }
  return nonManifoldEdges
    ? { kind: needs ? 'bad' : 'plain',
      text: t('verdict.shared', { count: count(nonManifoldEdges) }) }
    : { kind: 'good', text: t('verdict.closed') };
}

/** Whether every mesh is as it came, to the last digit: not rounded to what the format holds.
 * @param {Report} report */
const isKept = ({ chosen = [] }) => [chosen].flat().every(({ rule }) => rule === 'kept');

/** Whether the surface was only repaired. Then what is far from the original is what was added; of
 * what is gone, the repair says how much. @param {Report} report */
const isOnlyRepaired = ({ repair, fidelity }) => repair !== undefined && !fidelity;

/** @param {Judged} judged @param {VerdictActs} acts @returns {Line[]} */
function distanceLines(judged, { onLargest }) {
  const { report, largest, diagonal } = judged;
  if (report.repair?.reason === 'sound' && !report.fidelity) {
    return [{ kind: 'good',
      text: t(isKept(report) ? 'verdict.unchanged' : 'verdict.sound') }];
  }
  if (largest === null) return [];
  if (largest < nothing * diagonal) return [{ kind: 'good', text: t('verdict.exact') }];
  const isFar = 100 * largest / diagonal > seenByAnyone;
  const distance = distanceIn(largest, judged);
  const act = { label: t('visit'), run: onLargest };
  if (!isFar) return [{ kind: 'good', text: t('verdict.near', { distance }), act }];
  return isOnlyRepaired(report)
    ? [{ kind: 'plain', text: t('verdict.added', { distance }), act }]
    : [{ kind: 'bad', text: t('verdict.far', { distance }), act }];
}

/** @param {Judged} judged @returns {Line} */
function facesLine({ report: { input, output } }) {
  const { quads } = output;
  if (quads) {
    return { kind: 'plain', text: t('verdict.quads', { count: count(quads.count),
      irregular: count(quads.irregular) }) };
  }
  const { triangles } = output;
  return { kind: 'plain', text: t(triangles === input.triangles ? 'verdict.sameTriangles'
    : 'verdict.triangles', { count: count(triangles), before: count(input.triangles) }) };
}

/** @param {Judged} judged @param {VerdictActs} acts @returns {Line[]} */
function mapLines({ maps }, { onMaps }) {
  if (!maps.length) return [];
  return [{ kind: 'plain', text: t('verdict.maps', { maps: maps.join(', ') }),
    act: { label: t('visit'), run: onMaps } }];
}

/** @param {Judged} judged @returns {Line[]} */
function sizeLines({ size, original, format }) {
  if (size === null) return [];
  const share = 100 * size / original;
  const kind = Math.abs(share - 100) < alike ? 'verdict.sameSize'
    : size > most * original ? 'verdict.sizes' : 'verdict.size';
  return [{ kind: 'plain', text: t(kind, { size: fileSize(size), format: format.toUpperCase(),
    share: wholePercent(share), original: fileSize(original) }) }];
}

/** @param {Judged} judged @returns {Line[]} */
function solverLines({ report: { output }, values, scale, edges }) {
  if (values.purpose !== 'simulation') return [];
  const { worst, mean } = output.minAngle;
  /** @type {Line} */
  const angles = { kind: worst >= smallAngle ? 'good' : 'bad',
    text: t('verdict.angle', { worst: degrees(worst), mean: degrees(mean) }) };
  if (!edges) return [angles];
  return [angles, { kind: 'plain', text: t('verdict.edges', { mean: lengthIn(scale, edges.mean),
    least: length(edges.least / scale.size), most: lengthIn(scale, edges.most) }) }];
}

const counted = /** @type {const} */ (['holes', 'islands', 'shells', 'turned']);

/** @param {Judged} judged @param {VerdictActs} acts @returns {Line[]} */
function repairLines({ report, diagonal, scale }, { onPlace }) {
  const { repair } = report;
  if (!repair) return [];
  const [before, after] = repair.selfIntersections;
  const done = counted.filter((name) => repair[name])
    .map((name) => t(`repair.${name}`, { count: count(repair[name]) }));
  const [x, y, z] = repair.lostAt;
  /** @type {Line[]} */
  const lines = [
    { kind: 'good', text: t('verdict.repaired', { what: done.join(', ') }) },
    { kind: after ? 'bad' : 'good', text: t('repair.crossings',
      { before: count(before), after: count(after) }) },
    { kind: 'bad', text: repair.lostBeyond > 0
      ? t('repair.far', { share: percent(repair.lost),
        distance: distanceIn(repair.lostBeyond * diagonal / 100, { scale, diagonal }) })
      : t('repair.lost', { share: percent(repair.lost) }),
    act: z === undefined ? null : { label: t('visit'), run: () => onPlace([x, y, z]) } },
  ];
  const isSaid = [wasRepaired(report) && done.length > 0, before > 0 || after > 0,
    repair.lost >= leastLoss];
  return lines.filter((_, i) => isSaid[i]);
}

/** Where shape was lost, or kept at the cost of isotropic triangles: the way out.
 * @param {Judged} judged @param {VerdictActs} acts @returns {Line[]} */
function shapeLines({ report, values, largest, diagonal, exact },
  { onWithin, onExact, onMore, onShorter }) {
  if (!report.fidelity) return [];
  const { triangles } = report.output;
  if (values.purpose === 'asset' && exact === report.input.triangles && triangles === exact) {
    return [{ kind: 'plain', text: t('verdict.needed') }];
  }
  const isShapeFirst = report.prefer?.includes('shape') && values.prefer !== 'shape';
  const isOfLength = values.purpose === 'simulation' && Boolean(values.edgeLength);
  const shorter = { label: t('verdict.shorter'), run: onShorter };
  if (isShapeFirst && isOfLength) {
    return report.output.minAngle.worst >= smallAngle ? []
      : [{ kind: 'bad', text: t('verdict.narrow'), act: shorter }];
  }
  // With more triangles than it had, each facet was meshed for itself.
  if (isShapeFirst && triangles <= report.input.triangles) {
    return [{ kind: 'bad', text: t('verdict.own'),
      act: { label: t('verdict.within'), run: onWithin } }];
  }
  if (largest === null || 100 * largest / diagonal <= seenByAnyone) return [];
  if (triangles < exact) {
    return [{ kind: 'plain', text: t('verdict.corners', { count: count(exact) }),
      act: { label: t('verdict.within'), run: onExact } }];
  }
  return [{ kind: 'plain', text: t('verdict.lost'),
    act: isOfLength ? shorter : { label: t('verdict.more'), run: onMore } }];
}

/** @param {Judged} judged @param {VerdictActs} acts @returns {Line[]} */
function noteLines({ report: { warnings } }, { onNotes }) {
  if (!warnings.length) return [];
  return [{ kind: 'plain', text: t('verdict.notes', { count: count(warnings.length) }),
    act: { label: t('verdict.read'), run: onNotes } }];
}

/** @param {Line} line */
function lineView({ kind, text, act }) {
  return element('li', { className: kind }, element('span', {}, text, act && ' ',
    act && element('button', { type: 'button', className: 'link', onclick: act.run },
      act.label)));
}

/** @param {Judged} judged @param {VerdictActs} acts */
export function verdictView(judged, acts) {
  const lines = [closedLine(judged, acts), ...distanceLines(judged, acts),
    ...shapeLines(judged, acts), facesLine(judged), ...solverLines(judged),
    ...mapLines(judged, acts), ...sizeLines(judged), ...repairLines(judged, acts),
    ...noteLines(judged, acts)];
  return element('ul', {}, ...lines.map(lineView));
}

/** @param {Judged} judged @param {number} largest */
function distanceInShort({ report, scale, diagonal }, largest) {
  if (largest < nothing * diagonal) return t('short.exact');
  const share = 100 * largest / diagonal;
  if (share > seenByAnyone && isOnlyRepaired(report)) return t('short.added');
  const distance = scale.name ? lengthIn(scale, largest) : percent(share);
  return share > seenByAnyone ? t('short.far', { distance }) : `≤ ${distance}`;
}

/** The verdict's first three lines in a few words, for where there is room for one line.
 * @param {Judged} judged */
export function verdictInShort(judged) {
  const { report: { output }, largest } = judged;
  const { boundaryEdges, triangles, quads } = output;
  return [boundaryEdges ? t('short.open', { count: count(boundaryEdges) }) : t('short.closed'),
    ...(largest === null ? [] : [distanceInShort(judged, largest)]),
    quads ? t('facts.quads', { count: count(quads.count) })
      : t('facts.triangles', { count: count(triangles) })].join(' · ');
}
