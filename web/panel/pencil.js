// SPDX-License-Identifier: MIT
// The pencil's form, shown on the stage while guides are drawn.
import { byId, element } from '../base/dom.js';
import { t } from '../base/i18n.js';

/** @typedef {{ mode: 'direction' | 'loop' | 'erase', isMirrored: boolean }} Pencil */

/** @type {Pencil} */
const pencil = { mode: 'direction', isMirrored: false };

/** @param {Pencil['mode']} mode */
function modeButton(mode) {
  const help = byId('pencil', HTMLElement);
  const input = element('input', { type: 'radio', name: 'pencil-mode', id: `pencil-${mode}`,
    checked: pencil.mode === mode, onchange: () => {
      pencil.mode = mode;
      const line = help.querySelector('.help');
      if (line) line.textContent = t(`pencil.${mode}.help`);
    } });
  return element('label', { className: 'inline-check' }, input, t(`pencil.${mode}`));
}

/** @param {{ onFinish: () => void, onClear: () => void, onDone: () => void }} acts onFinish: of a
 *   line whose points come from the keyboard */
export function showPencil({ onFinish, onClear, onDone }) {
  const mirror = element('input', { type: 'checkbox', id: 'pencil-mirror',
    checked: pencil.isMirrored, onchange: () => { pencil.isMirrored = mirror.checked; } });
  const link = (/** @type {string} */ id, /** @type {string} */ text,
    /** @type {() => void} */ onclick) =>
    element('button', { type: 'button', className: 'link', id, onclick }, text);
  const finish = link('pencil-finish', t('pencil.finish'), onFinish);
  finish.hidden = true;
  byId('pencil', HTMLElement).replaceChildren(
    element('p', { className: 'help' }, t(`pencil.${pencil.mode}.help`)),
    element('div', { className: 'modes', role: 'radiogroup', ariaLabel: t('pencil') },
      modeButton('direction'), modeButton('loop'), modeButton('erase')),
    element('label', { className: 'inline-check' }, mirror, t('brush.mirror')),
    element('div', { className: 'inline' }, finish,
      element('button', { type: 'button', className: 'link', id: 'pencil-undo',
        'data-do': 'undo' }, t('undo')),
      link('pencil-clear', t('brush.clear'), onClear),
      link('pencil-done', t('brush.done'), onDone)));
  byId('pencil', HTMLElement).hidden = false;
}

/** Whether a line waits for further points from the keyboard. @param {boolean} isOpen */
export function showOpenLine(isOpen) {
  const button = document.getElementById('pencil-finish');
  if (button) button.hidden = !isOpen;
}

export function hidePencil() {
  byId('pencil', HTMLElement).hidden = true;
}

/** The pencil as set in the form. @returns {Readonly<Pencil>} */
export const currentPencil = () => pencil;
