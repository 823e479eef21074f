// SPDX-License-Identifier: MIT
// Numbers for people.

const counts = new Intl.NumberFormat('en');

/** @param {number} value a whole number: 35,947 */
export const count = (value) => counts.format(value);

/** @param {number} value in degrees */
export const degrees = (value) => `${value.toFixed(1)}°`;

/** @param {number} value a part of a whole, in percent */
export const share = (value) => `${value.toFixed(1)} %`;

/** Three significant digits, never in exponents: 0.0131 %, 90.6 %.
 * @param {number} value */
export function percent(value) {
  if (!value) return '0 %';
  const digits = Math.max(0, 2 - Math.floor(Math.log10(Math.abs(value))));
  return `${value.toFixed(Math.min(4, digits))} %`;
}

/** @param {number} milliseconds */
export function duration(milliseconds) {
  if (milliseconds < 1000) return `${Math.max(1, Math.round(milliseconds))} ms`;
  return `${(milliseconds / 1000).toFixed(milliseconds < 10000 ? 2 : 1)} s`;
}

/** The word for a name in camelCase: vertexAngle becomes "Vertex angle".
 * @param {string} name */
export function words(name) {
  const text = name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  return text[0].toUpperCase() + text.slice(1);
}

/** @param {string} text the beginning of a sentence, or all of it without its full stop */
export const sentence = (text) => `${text[0].toUpperCase()}${text.slice(1)}.`;

/** @param {string} name of a file @param {string} extension */
export function withExtension(name, extension) {
  return `${name.replace(/\.[^.]*$/, '')}.${extension}`;
}
