// SPDX-License-Identifier: MIT
// The package's messages are English, with a code. The page shows the code's text in the visitor's
// language, and the original message below it, because that has names, numbers and places.
import { textIfAny } from './i18n.js';

/** @param {'warning' | 'fault'} kind @param {string | undefined} code @param {string} message
 * @returns {{ text: string, original: string }} original: empty if the text is the message */
export function saidAs(kind, code, message) {
  const text = code && textIfAny(`${kind}.${code}`);
  return text ? { text, original: message } : { text: message, original: '' };
}
