// SPDX-License-Identifier: MIT
// Shows the repairs before remeshing: the mode, and the count of each change.
import { element } from '../base/dom.js';
import { count, percent } from '../base/format.js';
import { t, textIfAny } from '../base/i18n.js';

/** @typedef {NonNullable<import('remesher').RemeshReport['repair']>} RepairSummary */

const counted = /** @type {const} */ (['holes', 'rims', 'bodies', 'islands', 'shells', 'turned']);

/** @param {RepairSummary} repair */
const lossOf = ({ lost, lostBeyond }) => (lostBeyond > 0
  ? t('repair.far', { share: percent(lost), distance: percent(lostBeyond) })
  : t('repair.lost', { share: percent(lost) }));

/** @param {RepairSummary} repair */
function whatWasDone(repair) {
  const [before, after] = repair.selfIntersections;
  const done = counted.filter((name) => repair[name])
    .map((name) => t(`repair.${name}`, { count: count(repair[name]) }));
  return [...done,
    ...(before || after ? [t('repair.crossings', { before: count(before), after: count(after) })]
      : []),
    ...(repair.lost >= 0.005 ? [lossOf(repair)] : [])];
}

/** @param {RepairSummary | undefined} repair */
export function repairView(repair) {
  if (!repair) return '';
  const mode = textIfAny(`choice.repair.${repair.mode}`) ?? repair.mode;
  const why = textIfAny(`reason.${repair.reason}`);
  const done = whatWasDone(repair);
  if (repair.reason === 'sound' && !done.length) {
    return element('section', { id: 'repaired', className: 'repaired' },
      element('h2', {}, t('repair.nothing')), element('p', { className: 'help' }, why ?? ''));
  }
  const otherwise = repair.reason === 'joined' ? []
    : [t(repair.mode === 'holes' ? 'repair.nothing' : 'repair.made')];
  return element('section', { id: 'repaired', className: 'repaired' },
    element('h2', {}, t('repair.title', { mode })),
    why && element('p', { className: 'help' }, why),
    element('ul', {}, ...(done.length ? done : otherwise)
      .map((text) => element('li', {}, text))));
}
