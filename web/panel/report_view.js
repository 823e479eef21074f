// SPDX-License-Identifier: MIT
// The report on a run: what got better, by how much the surface moved, what to know, and the files.
import { element } from '../base/dom.js';
import { count, degrees, duration, percent, share } from '../base/format.js';
import { t, textIfAny } from '../base/i18n.js';
import { histogram } from './histogram.js';

/** @typedef {import('remesher').MeshReport} MeshReport */
/** @typedef {import('remesher').RemeshReport} RemeshReport */
/** @typedef {import('remesher').Inspection} Inspection */

/** @type {[import('../base/i18n.js').TextKey, (mesh: MeshReport) => string][]} */
const rows = [
  ['report.vertices', (mesh) => count(mesh.vertices)],
  ['report.triangles', (mesh) => count(mesh.triangles)],
  ['report.meanAngle', (mesh) => degrees(mesh.minAngle.mean)],
  ['report.worstAngle', (mesh) => degrees(mesh.minAngle.worst)],
  ['report.goodAngles', (mesh) => share(mesh.minAngle.histogram[5])],
  ['report.valence6', (mesh) => share(mesh.valence6)],
];

/** @param {string} label @param {string[]} values */
function row(label, values) {
  return element('tr', {}, element('th', { scope: 'row' }, label),
    ...values.map((value) => element('td', {}, value)));
}

/** @param {string} title */
const columnHead = (title) => element('th', { scope: 'col' }, title);

/** @param {RemeshReport} report */
function table({ input, output, fidelity, timings }) {
  const time = Object.values(timings).reduce((sum, part) => sum + part, 0);
  return element('table', {},
    element('caption', { className: 'visually-hidden' }, t('report.compared')),
    element('thead', {}, element('tr', {}, element('td'), columnHead(t('original')),
      columnHead(t('result')))),
    element('tbody', {},
      ...rows.map(([label, value]) => row(t(label), [value(input), value(output)])),
      row(t('report.largest'), ['', percent(fidelity.hausdorff)]),
      row(t('report.rms'), ['', percent(fidelity.rms)]),
      row(t('report.time'), ['', duration(time)])));
}

/** @param {number[]} before @param {number[]} after */
function histogramWithKey(before, after) {
  return element('figure', {}, histogram(before, after),
    element('figcaption', { className: 'key' },
      element('span', { className: 'swatch before' }), `${t('report.keyBefore')} `,
      element('span', { className: 'swatch after' }), t('report.key')));
}

/** The report on a finished run. @param {RemeshReport} report */
export function reportView(report) {
  const { input, output, stopped, warnings } = report;
  const notes = warnings.map(({ message, count: times }) =>
    (times > 1 ? `${message} (${count(times)}×)` : message));
  const early = textIfAny(`stopped.${stopped}`);
  if (early) notes.unshift(early);
  return [
    ...notes.map((note) => element('p', { className: 'notice' }, note)),
    element('h2', {}, t('report.angles')),
    histogramWithKey(input.minAngle.histogram, output.minAngle.histogram),
    table(report),
    element('p', { className: 'quiet' }, t('report.distances')),
  ];
}

/** One line on a model that was opened. @param {Inspection} report */
export function modelFacts({ input }) {
  const parts = [t('facts.vertices', { count: count(input.vertices) }),
    t('facts.triangles', { count: count(input.triangles) })];
  if (input.components > 1) parts.push(t('facts.parts', { count: count(input.components) }));
  if (input.boundaryEdges) parts.push(t('facts.open'));
  return parts.join(' · ');
}
