// SPDX-License-Identifier: MIT
// Build step: writes the English texts into the page's elements, so that they are visible before
// any script has run.
import en from './texts/en.js';

const texts = /** @type {Record<string, string>} */ (en);

/** @param {string} key */
function textOf(key) {
  if (!(key in texts)) throw new Error(`index.html asks for a text ${key}, which no file has.`);
  return texts[key].replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
}

/** @param {string} html */
export const withWords = (html) => html
  .replace(/\sdata-label="([^"]+)"/g, (all, key) => `${all} aria-label="${textOf(key)}"`)
  .replace(/\sdata-role="([^"]+)"/g,
    (all, key) => `${all} aria-roledescription="${textOf(key)}"`)
  .replace(/(\sdata-text="([^"]+)"[^>]*>)(?=<\/)/g, (all, _tag, key) => all + textOf(key));

/** @returns {import('vite').Plugin} */
export function wordsInPlace() {
  return { name: 'words-in-place', transformIndexHtml: withWords };
}
