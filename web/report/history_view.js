// SPDX-License-Identifier: MIT
// The list of results so far. The visitor can show any of them again, and compare any two.
import { element } from '../base/dom.js';
import { count, degrees, percent } from '../base/format.js';
import { t } from '../base/i18n.js';
import { valuesInWords } from '../panel/option_words.js';

/** @typedef {import('../model/session.js').Session} Session */
/** @typedef {import('../model/result.js').Result} Result */

/** @param {Result} result */
export const resultName = ({ number }) => (number ? t('history.name', { number }) : t('draft'));

/** The mean of the smallest angles, or, for quads, the mean deviation of their angles from 90°.
 * @param {import('remesher').MeshReport} output */
const angleFigure = ({ quads, minAngle }) =>
  (quads ? `90 ± ${degrees(quads.angleDeviation.mean)}` : degrees(minAngle.mean));

/** @param {Result} result @param {boolean} isShown @param {() => void} onShow */
function entry(result, isShown, onShow) {
  const { report: { output, fidelity }, values } = result;
  const button = element('button', { type: 'button', className: 'entry history-entry',
    'aria-pressed': isShown, onclick: onShow },
  element('b', {}, String(result.number)),
  element('span', {}, t('facts.vertices', { count: count(output.vertices) }),
    element('span', { className: 'quiet' }, valuesInWords(values))),
  element('span', { className: 'quiet numbers' },
    element('span', { title: t(output.quads ? 'report.deviation' : 'report.meanAngle') },
      t('history.angles', { value: angleFigure(output) })),
    element('span', {},
      t('history.distance', { value: fidelity ? percent(fidelity.hausdorff) : '–' }))));
  return element('li', {}, button);
}

/** @param {Session} session @param {(baseline: Result | null) => void} onCompare */
function comparison({ results, baseline, shown }, onCompare) {
  const others = results.filter((result) => result !== shown);
  const menu = element('select', { id: 'baseline' },
    element('option', { value: '' }, t('original')),
    ...others.map((result) =>
      element('option', { value: String(result.number) }, resultName(result))));
  menu.value = String(baseline?.number ?? '');
  menu.addEventListener('change', () =>
    onCompare(results.find(({ number }) => String(number) === menu.value) ?? null));
  return element('div', { className: 'inline' },
    element('label', { htmlFor: 'baseline' }, t('history.compare')), menu);
}

/** The list, null while there is only one result.
 * @param {Session} session
 * @param {{ onShow: (result: Result) => void,
 *   onCompare: (baseline: Result | null) => void }} acts */
export function historyView(session, { onShow, onCompare }) {
  const { results, shown } = session;
  if (results.length < 2) return null;
  const entries = results.map((result) =>
    entry(result, result === shown, () => onShow(result))).reverse();
  return element('section', { className: 'history', 'aria-label': t('history') },
    element('h2', {}, t('history')), comparison(session, onCompare),
    element('ol', { reversed: true }, ...entries));
}
