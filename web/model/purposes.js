// SPDX-License-Identifier: MIT
// The purposes of remeshing: each stands for options, and has one number in the
// visitor's unit. Names and texts are purpose.ID and amount.ID in the texts.
import { belonging, presets } from 'remesher/options';
import { roundLength } from './units.js';

/** @typedef {import('./address.js').Values} Values */
/** @typedef {'asset' | 'print' | 'simulation' | 'quads'} Purpose */

/** Facts about the model; diagonal and unit in the model's own units; unit: of its number;
 * exact: triangles from which a body of flat sides keeps its shape, 0 if that is not known;
 * isBaked: whether one of so many triangles gets new textures.
 * @typedef {{ triangles: number, diagonal: number, unit: number, exact: number,
 *   isPaintable: boolean, isBaked: (faces: number) => boolean }} Subject */

/** @type {Purpose[]} */
export const purposes = ['asset', 'print', 'simulation', 'quads'];

/** The purposes whose number is a length. */
export const measured = /** @type {Purpose[]} */ (['print', 'simulation']);

/** Rounds to two significant digits, as a person would type. @param {number} value
 * @param {(x: number) => number} [round] */
function rounded(value, round = Math.round) {
  const unit = 10 ** Math.max(0, Math.floor(Math.log10(value)) - 1);
  return round(value / unit) * unit;
}

/** The number of triangles from which a body of flat sides keeps its shape: all, if hardly fewer
 * do; 0 if it has no corners, or so many that it would stay too heavy.
 * @param {number} corners @param {number} triangles */
export function exactFrom(corners, triangles) {
  const exact = rounded(2 * corners, Math.ceil);
  if (!corners || exact > mostExact) return 0;
  return exact < lighter * triangles ? exact : triangles;
}

/** Most triangles of a model for the web, and as many as keep most looks, if nobody says
 * otherwise. */
const forWeb = 20_000, forLooks = 8000;
/** Fewer triangles are few enough; a share of them that is lighter; the most for an exact shape. */
const few = 400, lighter = 0.9, mostExact = 100_000;
/** A tolerance that printers keep, and edges that show a part, in shares of the diagonal. */
const shares = { tolerance: 1 / 1000, edge: 1 / 80 };

/** The number that a purpose begins with. @param {Purpose} purpose @param {Subject} subject */
export function firstAmount(purpose, { triangles, diagonal, unit, exact }) {
  switch (purpose) {
    case 'asset':
      return triangles < few ? triangles : Math.max(exact,
        rounded(Math.min(forWeb, Math.max(triangles / 10, Math.min(triangles / 2, forLooks)))));
    case 'print': return roundLength(shares.tolerance * diagonal / unit);
    case 'simulation': return roundLength(shares.edge * diagonal / unit);
    default: return rounded(Math.min(5000, Math.max(500, triangles / 2)));
  }
}

/** The limits of a purpose's slider. @param {Purpose} purpose @param {Subject} subject */
export function rangeOf(purpose, subject) {
  const first = firstAmount(purpose, subject);
  if (purpose === 'asset') {
    return { least: Math.max(20, Math.min(first, subject.triangles / 100)),
      most: Math.max(2 * first, subject.triangles) };
  }
  return { least: first / 20, most: first * 20 };
}

const digits = 4;

/** A purpose's number as an option. @param {Purpose} purpose @param {number} amount
 * @param {Subject} subject @returns {Values} */
function targetOf(purpose, amount, { diagonal, unit }) {
  switch (purpose) {
    case 'print':
      return { maxError: Number((100 * amount * unit / diagonal).toPrecision(digits)) };
    case 'simulation': return { edgeLength: Number((amount * unit).toPrecision(digits)) };
    default: return { faces: Math.max(1, Math.round(amount)) };
  }
}

const ofRepair = ['repair', ...belonging.repair, 'dropBelow'];

/** Options of files that the page leaves out: it compresses none that it writes. */
const ofFiles = ['compress'];

/** The options of a purpose besides its number: those of the package's preset. New textures are
 * baked where they pay. A lighter model keeps its openings and its pieces: to repair it is a
 * purpose of its own, and may cost looks.
 * @param {Purpose} purpose @param {number} amount @param {Subject} subject @returns {Values} */
function optionsOf(purpose, amount, { isBaked }) {
  const values = Object.entries(presets.find(({ name }) => name === purpose)?.values ?? {})
    .filter(([name]) => !ofFiles.includes(name));
  const isKept = (/** @type {string} */ name) => purpose !== 'asset' || !ofRepair.includes(name);
  return Object.fromEntries(values.filter(([name]) =>
    (name.startsWith('texture') ? isBaked(amount) : isKept(name))));
}

/** All options of a purpose. For printing the model is only repaired, unless that is asked for.
 * @param {Purpose} purpose @param {number} amount @param {Subject} subject
 * @param {{ isRepairOnly?: boolean }} [how] @returns {Values} */
export function valuesFor(purpose, amount, subject, { isRepairOnly = purpose === 'print' } = {}) {
  if (purpose === 'print' && isRepairOnly) return { purpose, work: 'repair', repair: 'auto' };
  return { purpose, ...optionsOf(purpose, amount, subject), ...targetOf(purpose, amount, subject) };
}

/** The purpose's number among some options; null if it is not set there.
 * @param {Values} values @param {Subject} subject @returns {number | null} */
export function amountOf({ purpose, faces, maxError, edgeLength }, { diagonal, unit }) {
  const value = { asset: Number(faces),
    print: Number(maxError) * diagonal / 100 / unit, simulation: Number(edgeLength) / unit,
    quads: Number(faces) }[/** @type {Purpose} */ (purpose)] ?? NaN;
  if (!Number.isFinite(value)) return null;
  const isLength = measured.includes(/** @type {Purpose} */ (purpose));
  return isLength ? Number(value.toPrecision(3)) : Math.round(value);
}

/** The options that the engine takes: a purpose and the work are the page's own.
 * @param {Values} values @returns {Values} */
export function optionsIn(values) {
  const rest = { ...values };
  delete rest.purpose;
  delete rest.work;
  return rest;
}

/** Whether the model is only repaired. @param {Values} values */
export const isRepairOnly = ({ work }) => work === 'repair';
