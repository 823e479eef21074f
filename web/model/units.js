// SPDX-License-Identifier: MIT
// The unit of a model's lengths. glTF is in metres, 3MF states its unit; of other formats the
// visitor says it, and the browser keeps it with the model. Until then lengths that look like
// millimetres are taken as such, which is said; others have no unit.
import { leastShown, length, percent } from '../base/format.js';
import { t } from '../base/i18n.js';
import { Setting } from '../base/memory.js';

/** A unit; `none`: lengths are said without one.
 * @typedef {'mm' | 'cm' | 'm' | 'in' | 'none'} Unit */

/** @type {Unit[]} */
export const units = ['mm', 'cm', 'm', 'in', 'none'];

/** Most models whose units are kept. */
const most = 50;

/** @param {any} entry @returns {entry is [string, Unit]} */
const isEntry = (entry) => Array.isArray(entry) && entry.length === 2
  && typeof entry[0] === 'string' && units.includes(entry[1]);

/** Models by name and size, with their units, the latest first. */
const kept = new Setting('units', (text) => {
  const entries = JSON.parse(text);
  return Array.isArray(entries) && entries.length > 0 && entries.every(isEntry)
    ? entries : undefined;
});

/** @typedef {{ name: string, size: number }} Named */

/** Tells a model from others where something is kept with it. @param {Named} model */
export const keyOf = ({ name, size }) => `${name.slice(0, 200)} ${size}`;

/** The unit that the visitor has said of a model.
 * @param {Named} model @returns {Unit | undefined} */
export function saidUnit(model) {
  return kept.recall()?.find(([key]) => key === keyOf(model))?.[1];
}

/** Longest sides that are plainly in millimetres. A printer's smallest part is not smaller; a model
 * in metres or inches is seldom as large. */
const plainly = { least: 10, most: 10_000 };

/** The unit that the lengths of a file without one look like.
 * @param {number} longest side of the model @returns {Unit} */
export const unitLike = (longest) =>
  (longest >= plainly.least && longest <= plainly.most ? 'mm' : 'none');

/** The unit that the visitor has said or the file states; undefined if neither does.
 * @param {{ model: Named | null, inspection: { unit?: string } | null }} session
 * @returns {string | undefined} */
export const knownUnit = ({ model, inspection }) =>
  (model ? saidUnit(model) : undefined) ?? inspection?.unit;

/** @param {Named} model @param {Unit} unit */
export function keepUnit(model, unit) {
  const others = (kept.recall() ?? []).filter(([key]) => key !== keyOf(model));
  kept.remember(JSON.stringify([[keyOf(model), unit], ...others].slice(0, most)));
}

/** A unit for people: its name, empty for none, and how many of the model's units it has.
 * @typedef {{ name: string, size: number }} Scale */

/** Metres above which a glTF model is spoken of in metres, below which in millimetres. */
const large = 5;

/** How lengths of a model are said.
 * @param {string | null} unit of the model; null: it is glTF @param {number} diagonal
 * @returns {Scale} */
export function scaleOf(unit, diagonal) {
  if (unit) return { name: unit === 'none' ? '' : unit, size: 1 };
  return diagonal > large ? { name: 'm', size: 1 } : { name: 'mm', size: 0.001 };
}

/** A length as people read it. @param {Scale} scale @param {number} value in the model's units */
export const lengthIn = ({ name, size }, value) =>
  `${length(value / size)} ${name || t('unit.some')}`;

/** A distance as a length and in percent of the diagonal; of rounding no length is said.
 * @param {number} value in the model's units @param {{ diagonal: number, scale: Scale }} measure */
export function distanceIn(value, { diagonal, scale }) {
  const share = 100 * value / diagonal;
  return share < leastShown ? percent(share) : `${lengthIn(scale, value)} (${percent(share)})`;
}

/** The nearest of 1, 2 and 5 times a power of ten. @param {number} value above 0 */
export function roundLength(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const step = [1, 2, 5, 10].reduce((best, next) =>
    (Math.abs(Math.log(next * power / value)) < Math.abs(Math.log(best * power / value))
      ? next : best));
  return Number((step * power).toPrecision(6));
}
