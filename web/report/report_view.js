// SPDX-License-Identifier: MIT
// The report on a run: warnings, repairs, the mesh before and after, distances, and time.
import { cardRows, cardWords } from 'remesher/card';
import { valenceColors } from '../base/colors.js';
import { element } from '../base/dom.js';
import { count, decimal, degrees, duration, percent, share } from '../base/format.js';
import { language, t, textIfAny } from '../base/i18n.js';
import { saidAs } from '../base/said.js';
import { histogram } from './histogram.js';
import { repairView } from './repair_view.js';
import { seenByAnyone } from './verdict.js';

/** @typedef {import('remesher').MeshReport} MeshReport */
/** @typedef {import('../model/result.js').Report} Report */
/** @typedef {import('remesher').Inspection} Inspection */
/** @typedef {import('remesher').Warning} Warning */

/** @typedef {NonNullable<MeshReport['quads']>} QuadReport */
/** @typedef {import('../base/i18n.js').TextKey} TextKey */

/** @type {[TextKey, (mesh: MeshReport) => string][]} */
const triangleRows = [
  ['report.meanAngle', (mesh) => degrees(mesh.minAngle.mean)],
  ['report.worstAngle', (mesh) => degrees(mesh.minAngle.worst)],
  ['report.goodAngles', (mesh) => share(mesh.minAngle.histogram[5])],
  ['report.sixNeighbours', (mesh) => share(mesh.valence6)],
];

/** @type {[TextKey, (quads: QuadReport) => string][]} */
const quadRows = [
  ['report.irregular', (quads) => count(quads.irregular)],
  ['report.deviation', ({ angleDeviation }) => degrees(angleDeviation.mean)],
  ['report.deviationMost', ({ angleDeviation }) => degrees(angleDeviation.p95)],
  ['report.deviationWorst', ({ angleDeviation }) => degrees(angleDeviation.worst)],
  ['report.jacobian', ({ scaledJacobian }) => decimal(scaledJacobian.min)],
  ['report.loops', ({ loops }) => count(loops.count)],
  ['report.longestLoop', ({ loops }) => share(loops.longest)],
  ['report.symmetry', ({ symmetry }) => (symmetry > 0 ? count(symmetry) : '–')],
];

/** @param {string} label @param {string[]} values */
function row(label, values) {
  return element('tr', {}, element('th', { scope: 'row' }, label),
    ...values.map((value) => element('td', {}, value)));
}

/** The lines of a report card that stand nowhere else on the page. */
const notOnCard = ['distance', 'bytes'];

/** The rows that the report card has, too, in its words. @param {Report} report */
function cardRowsOf({ card }) {
  return cardRows(card, language()).filter(({ name }) => !notOnCard.includes(name))
    .map(({ label, before, after }) => row(label, [before, after]));
}

/** The table rows on both meshes: rows on triangles or rows on quads.
 * @param {MeshReport} input @param {MeshReport} output */
function meshRows(input, output) {
  const { quads } = output;
  if (!quads && !input.quads) {
    return triangleRows.map(([label, value]) => row(t(label), [value(input), value(output)]));
  }
  const ofQuads = quadRows.map(([label, value]) => row(t(label),
    [input.quads ? value(input.quads) : '', quads ? value(quads) : '']));
  const ofTriangles = triangleRows.map(([label, value]) => row(t(label),
    [input.quads ? '' : value(input), quads ? '' : value(output)]));
  return quads ? ofQuads : ofTriangles;
}

const valences = /** @type {const} */ (['three', 'five', 'other']);

/** The key to the dots on the stage. */
const dotKey = () => element('p', { className: 'key', id: 'dot-key' }, `${t('dots')} `,
  ...valences.map((name) => {
    const dot = element('span', { className: 'dot' });
    dot.style.background = valenceColors[name];
    return element('span', { className: 'dot-name' }, dot, t(`dots.${name}`));
  }));

/** @param {string} title */
const columnHead = (title) => element('th', { scope: 'col' }, title);

/** @param {Report} report */
function table(report) {
  const { input, output, fidelity, timings } = report;
  const time = Object.values(timings).reduce((sum, part) => sum + part, 0);
  return element('table', {},
    element('caption', { className: 'visually-hidden' }, t('report.compared')),
    element('thead', {}, element('tr', {}, element('td'), columnHead(t('original')),
      columnHead(t('result')))),
    element('tbody', {},
      ...cardRowsOf(report), ...meshRows(input, output),
      ...(fidelity ? [row(cardWords[language()].distance, ['', percent(fidelity.hausdorff)]),
        row(t('report.rms'), ['', percent(fidelity.rms)])] : []),
      row(t('report.time'), ['', duration(time)])));
}

/** @param {number[]} before @param {number[]} after */
function histogramWithKey(before, after) {
  return element('figure', {}, histogram(before, after),
    element('figcaption', { className: 'key' },
      element('span', { className: 'swatch before' }), `${t('report.keyBefore')} `,
      element('span', { className: 'swatch after' }), t('report.key')));
}

/** @param {Warning} warning
 * @param {(warning: Warning) => (() => void) | null} visitorOf returns a function that shows the
 *   warning's place, null if the place is unknown */
function note(warning, visitorOf) {
  const { code, message, count: times } = warning;
  const { text, original } = saidAs('warning', code, message);
  const onclick = visitorOf(warning);
  return element('p', { className: 'notice' }, times > 1 ? `${text} (${count(times)}×)` : text,
    original && element('small', { lang: 'en' }, original), onclick
    && element('button', { type: 'button', className: 'link', onclick }, t('visit')));
}

/** Whether a result is nowhere away from the original as far as anyone sees.
 * @param {Report} report */
const keepsShape = ({ fidelity }) => !fidelity || fidelity.hausdorff <= seenByAnyone;

/** Where shape was lost, if it was. @param {Report} report @param {() => void} onLargest */
function loss(report, onLargest) {
  if (!report.fidelity || keepsShape(report)) return '';
  const said = report.output.quads ? 'report.shapeLostByQuads' : 'report.shapeLost';
  return element('p', { className: 'notice', id: 'shape-lost' },
    t(said, { distance: percent(report.fidelity.hausdorff) }),
    element('button', { type: 'button', className: 'link', onclick: onLargest }, t('visit')));
}

/** Why the result is the mesh that it is, each sentence once; that isotropic triangles keep the
 * shape is not said where they lost some of it, nor that a sound surface changed by being rounded.
 * @param {Report} report */
function choice(report) {
  const chosen = [report.chosen ?? []].flat()
    .filter(({ rule }) => (keepsShape(report) || !rule.startsWith('isotropic-near'))
      && (report.repair?.reason !== 'sound' || rule !== 'repaired'));
  const reasons = chosen.map(({ rule, reason }) => textIfAny(`chosen.${rule}`) ?? reason);
  return element('p', { className: 'quiet', id: 'chosen' }, [...new Set(reasons)].join(' '));
}

/** The report on a finished run.
 * @param {Report} report
 * @param {{ visitorOf: (warning: Warning) => (() => void) | null, onLargest: () => void }} acts
 *   onLargest: shows where the result is farthest from the original */
export function reportView(report, { visitorOf, onLargest }) {
  const { input, output, stopped, warnings, prefer } = report;
  const early = textIfAny(`stopped.${stopped}`);
  return [
    early ? element('p', { className: 'notice' }, early) : '',
    loss(report, onLargest),
    prefer?.includes('shape') ? element('p', { className: 'notice' }, t('report.shape')) : '',
    choice(report),
    ...warnings.map((warning) => note(warning, visitorOf)),
    repairView(report.repair),
    ...(output.quads ? [element('h2', {}, cardWords[language()].quads)]
      : [element('h2', {}, t('report.angles')),
        histogramWithKey(input.minAngle.histogram, output.minAngle.histogram)]),
    table(report),
    output.quads ? dotKey() : '',
    element('p', { className: 'quiet' }, t('report.distances')),
    element('section', { id: 'distances', hidden: true }),
  ];
}

/** One line on a model that was opened. @param {Inspection} report */
export function modelFacts({ input }) {
  const parts = [t('facts.vertices', { count: count(input.vertices) }),
    input.quads ? t('facts.quads', { count: count(input.quads.count) })
      : t('facts.triangles', { count: count(input.triangles) })];
  if (input.components > 1) parts.push(t('facts.parts', { count: count(input.components) }));
  if (input.boundaryEdges) parts.push(t('facts.open'));
  return parts.join(' · ');
}
