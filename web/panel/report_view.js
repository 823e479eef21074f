// SPDX-License-Identifier: MIT
// The report on a run: what got better, by how much the surface moved, what to know, and the files.
import { element } from '../base/dom.js';
import { count, degrees, duration, percent, share } from '../base/format.js';
import { histogram } from './histogram.js';

/** @typedef {import('remesher').MeshReport} MeshReport */
/** @typedef {import('remesher').RemeshReport} RemeshReport */
/** @typedef {import('remesher').Inspection} Inspection */

/** @type {[string, (mesh: MeshReport) => string][]} */
const rows = [
  ['Vertices', (mesh) => count(mesh.vertices)],
  ['Triangles', (mesh) => count(mesh.triangles)],
  ['Mean smallest angle', (mesh) => degrees(mesh.minAngle.mean)],
  ['Worst angle', (mesh) => degrees(mesh.minAngle.worst)],
  ['Triangles in 50–60°', (mesh) => share(mesh.minAngle.histogram[5])],
  ['Vertices of valence 6', (mesh) => share(mesh.valence6)],
];

/** Why a run ended before its target, and what would let it go on. */
const stops = /** @type {Record<string, string>} */ ({
  fidelity: 'Stopped before the target: every further step would bend the surface by more than '
    + 'the angles allow. Loosen the fidelity or widen its angles.',
  'max-error': 'Stopped before the target: every further step would leave the original by more '
    + 'than the largest error allowed.',
});

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
    element('caption', { className: 'visually-hidden' }, 'Original and result compared'),
    element('thead', {}, element('tr', {}, element('td'), columnHead('Original'),
      columnHead('Result'))),
    element('tbody', {},
      ...rows.map(([label, value]) => row(label, [value(input), value(output)])),
      row('Largest distance', ['', percent(fidelity.hausdorff)]),
      row('Mean distance (RMS)', ['', percent(fidelity.rms)]),
      row('Time', ['', duration(time)])));
}

/** @param {number[]} before @param {number[]} after */
function histogramWithKey(before, after) {
  return element('figure', {}, histogram(before, after),
    element('figcaption', { className: 'key' },
      element('span', { className: 'swatch before' }), 'original ',
      element('span', { className: 'swatch after' }), 'result, % of the triangles'));
}

/** The report on a finished run. @param {RemeshReport} report */
export function reportView(report) {
  const { input, output, stopped, warnings } = report;
  const notes = warnings.map(({ message, count: times }) =>
    (times > 1 ? `${message} (${count(times)}×)` : message));
  if (stopped in stops) notes.unshift(stops[stopped]);
  return [
    ...notes.map((note) => element('p', { className: 'notice' }, note)),
    element('h2', {}, 'Smallest angles'),
    histogramWithKey(input.minAngle.histogram, output.minAngle.histogram),
    table(report),
    element('p', { className: 'quiet' }, 'Distances between the surfaces, both ways, in percent of '
      + 'the bounding-box diagonal.'),
  ];
}

/** One line on a model that was opened.
 * @param {Inspection} report @param {string[]} others models that came along, left aside */
export function modelFacts({ input }, others) {
  const parts = [`${count(input.vertices)} vertices`, `${count(input.triangles)} triangles`];
  if (input.components > 1) parts.push(`${count(input.components)} parts`);
  if (input.boundaryEdges) parts.push('open');
  if (others.length) parts.push(`not opened: ${others.join(', ')}`);
  return parts.join(' · ');
}
