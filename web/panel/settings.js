// SPDX-License-Identifier: MIT
// The dialog with the list of keys and the page's settings.
import {
  addCommand, allCommands, hasSingleKeys, setSingleKeys,
} from '../base/commands.js';
import { byId, element } from '../base/dom.js';
import { language, languages, onLanguage, setLanguage, t, textIfAny } from '../base/i18n.js';
import { forgetRecent, keepsFiles, setKeepsFiles } from '../model/recent.js';
import { announce } from './messages.js';

/** @param {string} key as commands spell it */
function keyCaps(key) {
  return key.split('+').map((part) => element('kbd', {},
    part === 'Control' ? 'Ctrl' : part.length === 1 ? part.toUpperCase() : part));
}

/** @param {Node[]} caps @param {string} text */
const keyRow = (caps, text) => [element('dt', {}, ...caps), element('dd', {}, text)];

function showKeys() {
  const rows = allCommands().filter(({ key }) => key).flatMap(({ id, key }) =>
    keyRow(keyCaps(key), textIfAny(`key.${id}`) ?? id));
  const cap = (/** @type {string} */ text) => [element('kbd', {}, text)];
  byId('key-list', HTMLElement).replaceChildren(...rows,
    ...keyRow(keyCaps('Control+v'), t('key.paste')),
    ...keyRow(cap(t('key.space')), t('key.space.does')),
    ...keyRow(cap(t('key.arrows')), t('key.arrows.does')));
}

function wireLanguage() {
  const menu = byId('language', HTMLSelectElement);
  menu.append(...Object.entries(languages).map(([code, name]) =>
    element('option', { value: code, lang: code }, name)));
  menu.addEventListener('change', () => {
    void setLanguage(/** @type {import('../base/i18n.js').Language} */ (menu.value));
  });
  onLanguage(showKeys);
}

/** @param {() => void} onForget */
export function wireSettings(onForget) {
  const dialog = byId('settings', HTMLDialogElement);
  const keep = byId('keep-files', HTMLInputElement);
  const keys = byId('single-keys', HTMLInputElement);
  wireLanguage();
  keep.addEventListener('change', () => void setKeepsFiles(keep.checked));
  keys.addEventListener('change', () => setSingleKeys(keys.checked));
  byId('forget', HTMLButtonElement).addEventListener('click', async () => {
    await forgetRecent();
    onForget();
    announce(t('settings.forgotten'));
  });
  byId('settings-close', HTMLButtonElement).addEventListener('click', () => dialog.close());
  addCommand('settings', () => {
    keep.checked = keepsFiles();
    keys.checked = hasSingleKeys();
    byId('language', HTMLSelectElement).value = language();
    showKeys();
    dialog.showModal();
  }, '?');
}
