// SPDX-License-Identifier: MIT
// The dialog that asks which of several models to open, or all of them.
import { byId, element } from '../base/dom.js';
import { fileSize } from '../base/format.js';
import { t } from '../base/i18n.js';

/** @typedef {import('../files/files.js').PathedFile} PathedFile */

/** @param {PathedFile[]} models
 * @returns {Promise<PathedFile | 'all' | null>} null: none of them */
export function chooseModel(models) {
  const dialog = byId('chooser', HTMLDialogElement);
  return new Promise((resolve) => {
    const close = (/** @type {PathedFile | 'all' | null} */ answer) => () => {
      resolve(answer);
      dialog.close();
    };
    byId('chooser-list', HTMLElement).replaceChildren(...models.map((model) =>
      element('button', { type: 'button', className: 'entry', onclick: close(model) },
        element('span', {}, model.path),
        element('span', { className: 'quiet' }, fileSize(model.file.size)))));
    const all = byId('chooser-all', HTMLButtonElement);
    all.textContent = t('chooser.all', { count: models.length });
    all.onclick = close('all');
    byId('chooser-close', HTMLButtonElement).onclick = close(null);
    dialog.onclose = close(null);
    dialog.showModal();
  });
}
