// SPDX-License-Identifier: MIT
// What is peculiar about the input, each a button that shows where.
import { lineColors } from '../base/colors.js';
import { byId, element } from '../base/dom.js';
import { count } from '../base/format.js';
import { t } from '../base/i18n.js';

/** @typedef {'boundary' | 'nonManifold' | 'flipped'} Landmark */

/** @type {Landmark[]} */
export const landmarks = ['boundary', 'nonManifold', 'flipped'];

/** The landmark that a warning speaks of, if any. @param {string} code */
export function landmarkOf(code) {
  const codes = /** @type {Record<string, Landmark>} */ ({
    NON_MANIFOLD_EDGES_SPLIT: 'nonManifold', NON_MANIFOLD_VERTICES_SPLIT: 'nonManifold',
    JOINTS_RELEASED: 'nonManifold', INCONSISTENT_ORIENTATION_FIXED: 'flipped',
    NON_ORIENTABLE_CUT: 'flipped', SURFACE_OPENED: 'boundary',
  });
  return codes[code];
}

/** The place in a message: "… near (0.1, 2, -3e-4)". @param {string} message
 * @returns {[number, number, number] | null} */
export function placeIn(message) {
  const [, ...numbers] = /\((-?[\d.e+-]+), (-?[\d.e+-]+), (-?[\d.e+-]+)\)/.exec(message) ?? [];
  const place = numbers.map(Number);
  return place.length === 3 && place.every(Number.isFinite)
    ? /** @type {[number, number, number]} */ (place) : null;
}

/** @param {Record<Landmark, number> | null} counts of edges
 * @param {{ onVisit: (landmark: Landmark) => void, onMend: () => void }} acts */
export function showLandmarks(counts, { onVisit, onMend }) {
  const box = byId('landmarks', HTMLElement);
  const found = landmarks.filter((name) => counts?.[name]);
  box.hidden = !found.length;
  box.replaceChildren(...found.map((name) => {
    const dot = element('span', { className: 'dot' });
    dot.style.background = lineColors[name];
    return element('button', { type: 'button', className: 'chip', id: `landmark-${name}`,
      onclick: () => onVisit(name) }, dot,
    t(`landmark.${name}`, { count: count(counts?.[name] ?? 0) }));
  }), element('button', { type: 'button', className: 'chip', id: 'mend', onclick: onMend },
    t('mend')));
}
