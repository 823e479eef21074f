// SPDX-License-Identifier: MIT
// Peculiarities of the input, each with a button that shows where it is.
import { lineColors } from '../base/colors.js';
import { byId, element } from '../base/dom.js';
import { count } from '../base/format.js';
import { t } from '../base/i18n.js';

/** Landmarks are edges, which are drawn; fault places are points.
 * @typedef {'boundary' | 'nonManifold' | 'flipped'} Landmark
 * @typedef {'selfIntersections' | 'innerShells' | 'insideOut'} FaultPlace */

/** @type {Landmark[]} */
export const landmarks = ['boundary', 'nonManifold', 'flipped'];

/** @type {FaultPlace[]} */
const faultPlaces = ['selfIntersections', 'innerShells', 'insideOut'];

/** The landmark that a warning is about, if any. @param {string} code */
export function landmarkOf(code) {
  const codes = /** @type {Record<string, Landmark>} */ ({
    NON_MANIFOLD_EDGES_SPLIT: 'nonManifold', NON_MANIFOLD_VERTICES_SPLIT: 'nonManifold',
    JOINTS_RELEASED: 'nonManifold', INCONSISTENT_ORIENTATION_FIXED: 'flipped',
    NON_ORIENTABLE_CUT: 'flipped', SURFACE_OPENED: 'boundary',
  });
  return codes[code];
}

/** @param {Landmark | FaultPlace} name @param {number} total @param {string} color
 * @param {() => void} onclick */
function chip(name, total, color, onclick) {
  const dot = element('span', { className: 'dot' });
  dot.style.background = color;
  return element('button', { type: 'button', className: 'chip', id: `landmark-${name}`, onclick },
    dot, t(`landmark.${name}`, { count: count(total) }));
}

/** What mending takes, where that is known.
 * @param {import('remesher').FaultSummary | null} faults */
function needsOf(faults) {
  if (!faults || faults.repair === 'off') return [];
  const { seconds } = faults.needs;
  return [element('span', { className: 'needs' }, t('mend.needs',
    { seconds: count(Math.max(1, Math.round(seconds))) }))];
}

/** Why no faults are shown yet, `faults.KIND` in the texts; limit: a number of vertices.
 * @typedef {{ kind: 'sought' | 'large' | 'skipped' | 'room' | 'failed',
 *   limit?: number }} FaultNote */

/** @param {FaultNote | null} note @param {() => void} onSeek */
export function showFaultNote(note, onSeek) {
  const box = byId('fault-note', HTMLElement);
  box.hidden = !note;
  if (!note) return;
  const canSeek = note.kind === 'large' || note.kind === 'skipped';
  box.replaceChildren(t(`faults.${note.kind}`, { limit: count(note.limit ?? 0) }),
    ...(canSeek ? [' ', element('button', { type: 'button', className: 'link', id: 'seek-faults',
      onclick: onSeek }, t('faults.seek'))] : []));
}

/** @param {{ edges: Record<Landmark, number> | null,
 *   faults: import('remesher').FaultSummary | null }} found
 * @param {{ onVisit: (landmark: Landmark) => void, onFault: (fault: FaultPlace) => void,
 *   onMend: (isOnly: boolean) => void }} acts isOnly: without remeshing */
export function showLandmarks({ edges, faults }, { onVisit, onFault, onMend }) {
  const box = byId('landmarks', HTMLElement);
  const chips = [
    ...landmarks.filter((name) => edges?.[name]).map((name) =>
      chip(name, edges?.[name] ?? 0, lineColors[name], () => onVisit(name))),
    ...faultPlaces.filter((name) => faults?.[name]).map((name) =>
      chip(name, faults?.[name] ?? 0, lineColors.probe, () => onFault(name))),
  ];
  box.hidden = !chips.length;
  const mend = (/** @type {string} */ id, /** @type {boolean} */ isOnly) => element('button',
    { type: 'button', className: 'chip mend', id, onclick: () => onMend(isOnly) },
    t(isOnly ? 'repairOnly' : 'mend'), ...(isOnly ? needsOf(faults) : []));
  box.replaceChildren(...chips, mend('repair-only', true), mend('mend', false));
}
