// SPDX-License-Identifier: MIT
// What the package says, in English, with a code: the visitor's language has a text for the code,
// and what was said stays below it, for it knows names, numbers and places.
import { textIfAny } from './i18n.js';

/** @param {'warning' | 'fault'} kind @param {string | undefined} code @param {string} message
 * @returns {{ text: string, original: string }} original: empty where the text is the message */
export function saidAs(kind, code, message) {
  const text = code && textIfAny(`${kind}.${code}`);
  return text ? { text, original: message } : { text: message, original: '' };
}
