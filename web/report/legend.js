// SPDX-License-Identifier: MIT
// The legend of the colours on the stage, and the figures of the face under the pointer.
import { angleColors, densityColors, distanceColors, gradient } from '../base/colors.js';
import { byId, element } from '../base/dom.js';
import { degrees, length } from '../base/format.js';
import { t } from '../base/i18n.js';
import { distanceIn } from '../model/units.js';

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

/** diagonal: of the original; scale: how its lengths are said.
 * @typedef {{ diagonal: number, scale: import('../model/units.js').Scale }} Measure */

/** @param {number} largest distance @param {Measure} measure */
const distanceMarks = (largest, measure) => ['0', distanceIn(largest, measure)];

/**
 * @param {import('../view/viewer.js').Shading} shading
 * @param {{ distance: { largest: number } & Measure | null,
 *   faces: import('../view/viewer.js').Faces[] }} known distance: null while it is measured;
 *   faces: the kinds shown
 */
export function showLegend(shading, { distance, faces }) {
  const box = byId('legend', HTMLElement);
  const parts = {
    angles: () => angleBar(faces),
    density: () => bar(t('density'), densityColors, [t('density.low'), t('density.high')]),
    distance: () => (distance ? bar(t('distance'), distanceColors,
      distanceMarks(distance.largest, distance)) : [t('distance.measuring')]),
  };
  const make = parts[/** @type {'angles'} */ (shading)];
  box.replaceChildren(...(make?.() ?? []));
  box.hidden = !make;
}

/** @param {Pick | null} pick @param {Measure} measure */
export function showProbe(pick, measure) {
  const box = byId('probe', HTMLElement);
  box.hidden = !pick;
  if (!pick) return;
  box.textContent = [
    t('probe.angles', { angles: pick.angles.map(degrees).join(' ') }),
    t('probe.edges', { lengths: pick.lengths
      .map((side) => length(side / measure.scale.size)).join(' ') }),
    ...(pick.distance === null ? []
      : [t('probe.distance', { distance: distanceIn(pick.distance, measure) })]),
  ].join('\n');
}
