// SPDX-License-Identifier: MIT
// Numbers for people, as their language writes them.
import { language } from './i18n.js';

/** Makers of numbers, by language and digits. @type {Map<string, Intl.NumberFormat>} */
const formats = new Map();

/** @param {number} value @param {Intl.NumberFormatOptions} [options] */
export function number(value, options = {}) {
  const key = JSON.stringify([language(), options]);
  const format = formats.get(key) ?? new Intl.NumberFormat(language(), options);
  formats.set(key, format);
  return format.format(value);
}

/** @param {number} value @param {number} digits after the point, always */
const fixed = (value, digits) =>
  number(value, { minimumFractionDigits: digits, maximumFractionDigits: digits });

/** @param {number} value of any kind, to two digits behind the point */
export const decimal = (value) => fixed(value, 2);

/** @param {number} value a whole number: 35,947 */
export const count = (value) => number(value);

/** @param {number} value in degrees */
export const degrees = (value) => `${fixed(value, 1)}°`;

/** @param {number} value a part of a whole, in percent */
export const share = (value) => `${fixed(value, 1)} %`;

/** @param {number} value in percent */
export const wholePercent = (value) => `${fixed(value, 0)} %`;

/** Percent that four digits after the point can show: smaller figures are rounding. */
export const leastShown = 0.0001;

/** Three significant digits, never in exponents: 0.0131 %, 90.6 %.
 * @param {number} value */
export function percent(value) {
  if (!value) return '0 %';
  if (Math.abs(value) < leastShown) return `< ${fixed(leastShown, 4)} %`;
  const digits = Math.max(0, 2 - Math.floor(Math.log10(Math.abs(value))));
  return `${fixed(value, Math.min(4, digits))} %`;
}

/** A length in model units, which can be of any size. @param {number} value */
export const length = (value) => (Math.abs(value) >= 1e-4 && Math.abs(value) < 1e6 || !value
  ? number(value, { maximumSignificantDigits: 3 }) : value.toExponential(2));

/** @param {number} milliseconds */
export function duration(milliseconds) {
  if (milliseconds < 1000) return `${Math.max(1, Math.round(milliseconds))} ms`;
  return `${fixed(milliseconds / 1000, milliseconds < 10000 ? 2 : 1)} s`;
}

/** Estimated milliseconds left of a job; null while there is no estimate yet.
 * @param {number} elapsed milliseconds @param {number} fraction of the job that is done */
export function timeLeft(elapsed, fraction) {
  const isKnown = elapsed > 2000 && fraction > 0.05;
  return isKnown ? elapsed * (1 - fraction) / fraction : null;
}

/** @param {number} bytes */
export function fileSize(bytes) {
  const units = ['byte', 'kilobyte', 'megabyte', 'gigabyte'];
  const step = Math.min(3, Math.max(0, Math.floor(Math.log10(bytes || 1) / 3)));
  return number(bytes / 1000 ** step,
    { style: 'unit', unit: units[step], maximumSignificantDigits: 3 });
}

/** The word for a name in camelCase: vertexAngle becomes "Vertex angle".
 * @param {string} name */
export function words(name) {
  const text = name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  return text[0].toUpperCase() + text.slice(1);
}

/** @param {string} text the beginning of a sentence, or all of it without its full stop */
export const sentence = (text) => `${text[0].toUpperCase()}${text.slice(1)}.`;
