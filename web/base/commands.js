// SPDX-License-Identifier: MIT
// The visitor's commands. A button (data-do), a key and a program run the same command.
import { switchSetting } from './memory.js';

/** @typedef {{ id: string, key: string, run: () => void }} Command key: '' for none */

/** @type {Map<string, Command>} */
const commands = new Map();

/** Whether a key belongs to the focused field, not to the page. @param {Event} event */
export function isTyping({ target }) {
  const kinds = 'input:not([type=range], [type=checkbox], [type=radio]), select, textarea';
  return target instanceof Element && target.matches(kinds);
}

const singleKeys = switchSetting('single-keys', 'off');
export const hasSingleKeys = () => singleKeys.recall() === undefined;

/** @param {boolean} isOn whether single letters, without Ctrl, run commands */
export function setSingleKeys(isOn) {
  singleKeys.remember(isOn ? null : 'off');
  showShortcuts();
}

/** @param {string} id @param {() => void} run @param {string} [key] 'w', or 'Control+z' */
export function addCommand(id, run, key = '') {
  commands.set(id, { id, key, run });
}

export const allCommands = () => [...commands.values()];

/** @param {string} id */
export function perform(id) {
  commands.get(id)?.run();
}

/** @param {KeyboardEvent} event @returns {string} as commands spell it */
function spelled({ key, ctrlKey, metaKey, shiftKey }) {
  const letter = key.length === 1 ? key.toLowerCase() : key;
  if (!ctrlKey && !metaKey) return letter;
  return `Control+${shiftKey ? 'Shift+' : ''}${letter}`;
}

/** Tells assistive technology the key of each button's command. */
function showShortcuts() {
  for (const node of document.querySelectorAll('[data-do]')) {
    const key = commands.get(/** @type {HTMLElement} */ (node).dataset.do ?? '')?.key;
    if (key && (hasSingleKeys() || key.length > 1)) node.setAttribute('aria-keyshortcuts', key);
    else node.removeAttribute('aria-keyshortcuts');
  }
}

/** @param {KeyboardEvent} event */
function onKey(event) {
  const isOpen = document.querySelector('dialog[open]');
  if (event.defaultPrevented || event.altKey || isTyping(event) || isOpen) return;
  const key = spelled(event);
  if (key.length === 1 && (event.repeat || !hasSingleKeys())) return;
  const command = allCommands().find((candidate) => candidate.key === key);
  if (!command) return;
  event.preventDefault();
  command.run();
}

/** To be called once all commands have been added. */
export function wireCommands() {
  showShortcuts();
  addEventListener('keydown', onKey);
  addEventListener('click', ({ target }) => {
    const button = target instanceof Element ? target.closest('[data-do]') : null;
    if (button instanceof HTMLElement) perform(button.dataset.do ?? '');
  });
}
