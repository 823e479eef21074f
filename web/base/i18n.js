// SPDX-License-Identifier: MIT
// The page's words in the visitor's language: web/texts has one file for each language; missing
// texts are English. Elements name their text by data-text, their label by data-label, and their
// role description by data-role.
import en from '../texts/en.js';
import { Setting } from './memory.js';

/** @typedef {keyof typeof en} TextKey */
/** @typedef {Record<string, string | number>} Filling */

/** The languages by their own names. */
export const languages = { en: 'English', de: 'Deutsch', fr: 'Français' };
/** @typedef {keyof typeof languages} Language */

/** @type {Record<Language, () => Promise<Record<string, string>>>} */
const files = {
  en: async () => en,
  de: async () => (await import('../texts/de.js')).default,
  fr: async () => (await import('../texts/fr.js')).default,
};

/** @type {Record<string, string>} */
let texts = en;
/** @type {Language} */
let current = 'en';
/** @type {(() => void)[]} */
const listeners = [];

/** @param {string | undefined} code @returns {code is Language} */
const isKnown = (code) => code !== undefined && Object.hasOwn(languages, code);

/** The visitor's choice. */
const chosen = new Setting('language', (code) => (isKnown(code) ? code : undefined));

export const language = () => current;

/** @param {() => void} listener called after the words have changed */
export function onLanguage(listener) {
  listeners.push(listener);
}

/** The text in the visitor's language, else in English, if any. @param {string} key */
export const textIfAny = (key) => texts[key] ?? /** @type {Record<string, string>} */ (en)[key];

/** A text with two forms, of one and of many, is written `one|many`; `count` decides.
 * @param {string} text @param {Filling} filling */
function formOf(text, { count }) {
  const [one, many = one] = text.split('|');
  return String(count) === '1' ? one : many;
}

/** @param {TextKey} key @param {Filling} [filling] values that replace {names} in the text */
export function t(key, filling = {}) {
  return formOf(textIfAny(key), filling)
    .replace(/\{(\w+)\}/g, (whole, name) => String(filling[name] ?? whole));
}

/** Writes the texts that elements ask for. @param {ParentNode} root */
export function applyTexts(root) {
  for (const node of root.querySelectorAll('[data-text], [data-label], [data-role]')) {
    const { text, label, role } = /** @type {Record<string, TextKey>} */ (
      /** @type {HTMLElement} */ (node).dataset);
    if (text) node.textContent = t(text);
    if (label) node.setAttribute('aria-label', t(label));
    if (role) node.setAttribute('aria-roledescription', t(role));
  }
}

/** @param {Language} code */
export async function setLanguage(code) {
  texts = await files[code]();
  current = code;
  chosen.remember(code);
  document.documentElement.lang = code;
  applyTexts(document);
  for (const listener of listeners) listener();
}

/** The visitor's choice, or the first of the browser's languages with texts. */
export function firstLanguage() {
  const asked = [chosen.recall(), ...navigator.languages.map((tag) => tag.slice(0, 2))];
  return asked.find(isKnown) ?? 'en';
}
