// SPDX-License-Identifier: MIT
// The distribution of distances between result and original, the place of the largest, and a handle
// to allow less: dragging the handle sets the largest error.
import { distanceColors } from '../base/colors.js';
import { element } from '../base/dom.js';
import { percent } from '../base/format.js';
import { t } from '../base/i18n.js';
import { distanceIn, lengthIn } from '../model/units.js';

/** @typedef {import('../survey/surface.js').Distances} Distances */
/** diagonal: of the original; scale: how its lengths are said.
 * @typedef {{ diagonal: number, scale: import('../model/units.js').Scale }} Measure */

/** @param {number[]} bins */
function bars(bins) {
  const tallest = Math.max(...bins);
  return bins.map((share, i) => {
    const bar = element('span', { className: 'distance-bin' });
    bar.style.height = `${Math.max(share ? 2 : 0, 100 * Math.sqrt(share / tallest))}%`;
    bar.style.background = distanceColors[Math.floor(i / bins.length * distanceColors.length)];
    return bar;
  });
}

/**
 * @param {Distances} distances @param {Measure} measure
 * @param {{ onVisit: () => void, onMaxError: (percent: number, isChosen: boolean) => void }} acts
 */
export function distanceView({ bins, largest }, measure, { onVisit, onMaxError }) {
  const { diagonal, scale } = measure;
  const most = 100 * largest / diagonal;
  const value = element('output', { htmlFor: 'error-handle' }, '–');
  const handle = element('input', { id: 'error-handle', type: 'range', min: 0, max: 1,
    step: 0.01, value: '1', 'aria-label': t('distance.handle') });
  const change = (/** @type {boolean} */ isChosen) => () => {
    const error = Math.max(0.001, Number((handle.valueAsNumber * most).toPrecision(2)));
    value.value = `${percent(error)} (${lengthIn(scale, error * diagonal / 100)})`;
    onMaxError(error, isChosen);
  };
  handle.addEventListener('input', change(false));
  handle.addEventListener('change', change(true));
  return [
    element('h2', {}, t('distance')),
    element('div', { className: 'distances' },
      element('div', { className: 'distance-bins', 'aria-hidden': true }, ...bars(bins)), handle),
    element('div', { className: 'inline help' },
      element('span', {}, t('distance.handle'), ' ', value),
      element('button', { type: 'button', className: 'link', id: 'visit-largest',
        onclick: onVisit }, t('distance.largest',
        { distance: distanceIn(largest, measure) }))),
  ];
}
