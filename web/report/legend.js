// SPDX-License-Identifier: MIT
// The legend of the colours on the stage, and the figures of the face under the pointer.
import { angleColors, densityColors, distanceColors, gradient } from '../base/colors.js';
import { byId, element } from '../base/dom.js';
import { degrees, length, percent } from '../base/format.js';
import { t } from '../base/i18n.js';

/** @typedef {import('../survey/picking.js').Pick} Pick */

/** @param {string[]} marks */
const marksBelow = (marks) => element('div', { className: 'legend-marks' },
  ...marks.map((mark) => element('span', {}, mark)));

/** @param {string} label @param {readonly string[]} colors @param {string[]} marks */
function bar(label, colors, marks) {
  const strip = element('div', { className: 'legend-bar' });
  strip.style.background = gradient(colors);
  return [element('b', {}, label), strip, marksBelow(marks)];
}

/** The bar of colours by angle, labelled for triangles, for quads, or for both.
 * @param {import('../view/viewer.js').Faces[]} faces */
function angleBar(faces) {
  const triangles = ['0°', '30°', '60°'], quads = ['60°', '30°', '0°'];
  if (!faces.includes('quads')) return bar(t('report.angles'), angleColors, triangles);
  const ofQuads = bar(t('legend.deviation'), angleColors, quads);
  return faces.includes('triangles')
    ? [...bar(t('report.angles'), angleColors, triangles), ofQuads[0], ofQuads[2]] : ofQuads;
}

/** A length in model units and in percent of the model's diagonal.
 * @param {number} value @param {number} diagonal */
const lengthInWords = (value, diagonal) =>
  `${length(value)} (${percent(100 * value / diagonal)})`;

/** @param {number} largest distance @param {number} diagonal */
const distanceMarks = (largest, diagonal) => ['0', lengthInWords(largest / 2, diagonal),
  lengthInWords(largest, diagonal)];

/**
 * @param {import('../view/viewer.js').Shading} shading
 * @param {{ distance: { largest: number, diagonal: number } | null,
 *   faces: import('../view/viewer.js').Faces[] }} known distance: null while it is measured;
 *   faces: the kinds shown
 */
export function showLegend(shading, { distance, faces }) {
  const box = byId('legend', HTMLElement);
  const parts = {
    angles: () => angleBar(faces),
    density: () => bar(t('density'), densityColors, [t('density.low'), t('density.high')]),
    distance: () => (distance ? bar(t('distance'), distanceColors,
      distanceMarks(distance.largest, distance.diagonal)) : [t('distance.measuring')]),
  };
  const make = parts[/** @type {'angles'} */ (shading)];
  box.replaceChildren(...(make?.() ?? []));
  box.hidden = !make;
}

/** @param {Pick | null} pick @param {number} diagonal */
export function showProbe(pick, diagonal) {
  const box = byId('probe', HTMLElement);
  box.hidden = !pick;
  if (!pick) return;
  box.textContent = [
    t('probe.angles', { angles: pick.angles.map(degrees).join(' ') }),
    t('probe.edges', { lengths: pick.lengths.map(length).join(' ') }),
    ...(pick.distance === null ? []
      : [t('probe.distance', { distance: lengthInWords(pick.distance, diagonal) })]),
  ].join('\n');
}
