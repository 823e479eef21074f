// SPDX-License-Identifier: MIT
// The ways to open a model: drop it anywhere, paste it, pick it from the disk, or choose a sample
// or a recent model from the menu.
import { addCommand, isTyping } from '../base/commands.js';
import { byId, element } from '../base/dom.js';
import { t } from '../base/i18n.js';
import { droppedFiles, PageError, pastedText, pickedFiles } from '../files/files.js';
import { keptFiles, recentNames } from '../model/recent.js';
import { sampleOf, samples } from '../model/samples.js';
import { servedFiles } from '../files/served.js';

/** @typedef {import('../files/files.js').PathedFile} PathedFile */
/** source: the model's name in an address, null for the visitor's own files.
 * @typedef {(items: Promise<PathedFile[]>, source: string | null) => void} OnFiles */

/** @param {OnFiles} onFiles */
function wireDrop(onFiles) {
  const { classList } = document.body;
  let depth = 0;  // dragenter and dragleave fire for every element under the pointer
  /** @param {DragEvent} event */
  const holdsFiles = ({ dataTransfer }) => dataTransfer?.types.includes('Files');
  addEventListener('dragenter', (event) => {
    if (!holdsFiles(event)) return;
    depth += 1;
    classList.add('dragging');
  });
  addEventListener('dragleave', () => {
    depth = Math.max(0, depth - 1);
    if (!depth) classList.remove('dragging');
  });
  addEventListener('dragover', (event) => {
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'copy';
  });
  addEventListener('drop', (event) => {
    event.preventDefault();
    depth = 0;
    classList.remove('dragging');
    if (event.dataTransfer?.files.length) onFiles(droppedFiles(event.dataTransfer), null);
  });
}

/** @param {OnFiles} onFiles */
function wirePaste(onFiles) {
  addEventListener('paste', (event) => {
    const { clipboardData } = event;
    if (!clipboardData || isTyping(event)) return;
    if (clipboardData.files.length) {
      onFiles(droppedFiles(clipboardData), null);
      return;
    }
    const pasted = pastedText(clipboardData.getData('text/plain'));
    if (pasted) onFiles(Promise.resolve([pasted]), null);
  });
}

/** @param {OnFiles} onFiles @param {{ command: string, id: string, key: string }} way */
function wirePicker(onFiles, { command, id, key }) {
  const input = byId(id, HTMLInputElement);
  input.addEventListener('change', () => {
    if (input.files?.length) onFiles(Promise.resolve(pickedFiles(input.files)), null);
    input.value = '';  // so that the same file can be picked again
  });
  addCommand(command, () => input.click(), key);
}

/** @param {string} name @returns {Promise<PathedFile[]>} */
async function recentFiles(name) {
  const files = await keptFiles(name);
  if (files) return files;
  throw new PageError(t('error.notKept', { name }), t('error.notKept.hint'));
}

const recentPrefix = 'recent:';

/** Fills the menu in the current language; the chosen entry stays. */
export function fillMenu() {
  const menu = byId('samples', HTMLSelectElement);
  const { value } = menu;
  const group = (/** @type {string} */ label, /** @type {[string, string][]} */ entries) =>
    element('optgroup', { label }, ...entries.map(([id, title]) =>
      element('option', { value: id }, title)));
  const recent = recentNames();
  menu.replaceChildren(
    element('option', { value: '', disabled: true, hidden: true }, t('menu.sampleGroup')),
    group(t('menu.sampleGroup'), samples.map(({ id }) => [id, t(`sample.${id}`)])));
  if (recent.length) {
    menu.append(group(t('menu.recentGroup'), recent.map((name) => [recentPrefix + name, name])));
  }
  menu.value = value;
}

/** @param {string | null} source */
export function showInMenu(source) {
  byId('samples', HTMLSelectElement).value = sampleOf(source) ? source ?? '' : '';
}

/** @param {OnFiles} onFiles */
function wireMenu(onFiles) {
  const menu = byId('samples', HTMLSelectElement);
  menu.addEventListener('change', () => {
    if (menu.value.startsWith(recentPrefix)) {
      onFiles(recentFiles(menu.value.slice(recentPrefix.length)), null);
    } else {
      onFiles(namedFiles(menu.value), menu.value);
    }
  });
}

/** The files that an address names: a sample, or files beside the page, separated by commas.
 * @param {string} source @returns {Promise<PathedFile[]>} */
export async function namedFiles(source) {
  const sample = sampleOf(source);
  const paths = sample ? [`samples/${sample.file}`] : source.split(',');
  return (await Promise.all(paths.map(servedFiles))).flat();
}

/** @param {OnFiles} onFiles */
export function wireIntake(onFiles) {
  wireDrop(onFiles);
  wirePaste(onFiles);
  wirePicker(onFiles, { command: 'open', id: 'file-input', key: 'o' });
  wirePicker(onFiles, { command: 'folder', id: 'folder-input', key: 'd' });
  wireMenu(onFiles);
}
