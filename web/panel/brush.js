// SPDX-License-Identifier: MIT
// The brush's form, shown on the stage while density is painted.
import { byId, element } from '../base/dom.js';
import { t } from '../base/i18n.js';

/** size: as a share of the model's diagonal; strength: in levels.
 * @typedef {{ mode: 'dense' | 'sparse' | 'erase', size: number, strength: number,
 *   isMirrored: boolean }} Brush */

/** @type {Brush} */
const brush = { mode: 'dense', size: 0.08, strength: 0.6, isMirrored: false };

/** @param {Brush['mode']} mode */
function modeButton(mode) {
  const input = element('input', { type: 'radio', name: 'brush-mode', id: `brush-${mode}`,
    checked: brush.mode === mode, onchange: () => { brush.mode = mode; } });
  return element('label', { className: 'inline-check' }, input, t(`brush.${mode}`));
}

/** @param {'size' | 'strength'} name @param {{ min: number, max: number }} limits */
function slider(name, limits) {
  const input = element('input', { type: 'range', id: `brush-${name}`, ...limits, step: 0.01 });
  input.valueAsNumber = brush[name];
  input.addEventListener('input', () => { brush[name] = input.valueAsNumber; });
  return element('label', { className: 'brush-slider' }, t(`brush.${name}`), input);
}

/** @param {{ onClear: () => void, onDone: () => void }} acts */
export function showBrush({ onClear, onDone }) {
  const mirror = element('input', { type: 'checkbox', id: 'brush-mirror',
    checked: brush.isMirrored, onchange: () => { brush.isMirrored = mirror.checked; } });
  const box = byId('brush', HTMLElement);
  box.replaceChildren(
    element('p', { className: 'help' }, t('brush.help')),
    element('div', { className: 'modes', role: 'radiogroup', ariaLabel: t('brush') },
      modeButton('dense'), modeButton('sparse'), modeButton('erase')),
    slider('size', { min: 0.01, max: 0.4 }), slider('strength', { min: 0.05, max: 2 }),
    element('label', { className: 'inline-check' }, mirror, t('brush.mirror')),
    element('div', { className: 'inline' },
      element('button', { type: 'button', className: 'link', id: 'brush-clear',
        onclick: onClear }, t('brush.clear')),
      element('button', { type: 'button', className: 'link', id: 'brush-done',
        onclick: onDone }, t('brush.done'))));
  box.hidden = false;
}

export function hideBrush() {
  byId('brush', HTMLElement).hidden = true;
}

/** The brush as set in the form. @returns {Readonly<Brush>} */
export const currentBrush = () => brush;
