// SPDX-License-Identifier: MIT
// Lengths with a unit, such as '0.1mm', where an option is a length or in percent of the diagonal:
// how they are written, and what they are in the units of a model. The one place that reads them,
// for the command line and JavaScript.

import { isGltf } from './contents.js';
import { RemeshError } from './errors.js';

/** The units that can be given. */
export const units = /** @type {const} */ ([
  'mm', 'cm', 'm', 'in',
]);

/** The units of 3MF, by its names for them: ours, and their lengths in metres, as
 * src/io/model/units.cpp has them: a test compares both.
 * @type {Record<string, { symbol: string, metres: number }>} */
export const threemfUnits = {
  micron: { symbol: 'µm', metres: 1e-6 },
  millimeter: { symbol: 'mm', metres: 1e-3 },
  centimeter: { symbol: 'cm', metres: 1e-2 },
  meter: { symbol: 'm', metres: 1 },
  inch: { symbol: 'in', metres: 0.0254 },
  foot: { symbol: 'ft', metres: 0.3048 },
};

/** What 3MF calls a unit. @param {unknown} unit @returns {string | undefined} */
export function threemfNameOf(unit) {
  return Object.keys(threemfUnits).find((name) => threemfUnits[name].symbol === unit);
}

/** How long a unit is. @param {string} unit its symbol */
export const metresIn = (unit) => threemfUnits[String(threemfNameOf(unit))].metres;

const written = /^((?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(mm|cm|m|in)$/i;

/** Whether an option's value is a length, or may be one. @param {{ unit?: string }} option */
export function takesLength({ unit }) {
  return unit === 'model units' || unit === '% of the diagonal';
}

/**
 * What '0.1mm' says; undefined if it is no length above 0.
 * @param {unknown} text
 */
export function lengthFrom(text) {
  const [, number, unit] = typeof text === 'string' ? written.exec(text.trim()) ?? [] : [];
  const value = Number(number);
  return value > 0 && Number.isFinite(value) ? { value, unit: unit.toLowerCase() } : undefined;
}

/** What '2px' says, a level of detail; undefined if it is no number of pixels above 0.
 * @param {unknown} text */
export function pixelsFrom(text) {
  const [, number] = typeof text === 'string'
    ? /^(\d+\.?\d*|\.\d+)\s*px$/i.exec(text.trim()) ?? [] : [];
  const value = Number(number);
  return value > 0 && Number.isFinite(value) ? value : undefined;
}

/** The unit that a 3MF states, whose model begins with it. @param {Uint8Array} bytes */
function threemfUnit(bytes) {
  const text = new TextDecoder().decode(bytes.subarray(0, 16384));
  const tag = /<(?:\w+:)?model\b[^>]*3dmanufacturing[^>]*>/.exec(text)?.[0];
  if (!tag) return undefined;
  return threemfUnits[/\bunit\s*=\s*["'](\w+)["']/.exec(tag)?.[1] ?? 'millimeter']?.symbol;
}

/**
 * The unit of a model: the one that was given, or its file's; undefined if neither says it.
 * @param {Record<string, unknown>} options
 * @param {{ bytes: Uint8Array }} [file] unpacked
 * @returns {string | undefined}
 */
export function unitOf(options, file) {
  if (typeof options.units === 'string') return options.units;
  if (!file) return undefined;
  return isGltf(file.bytes) ? 'm' : threemfUnit(file.bytes);
}

/** @param {string} name */
const flagOf = (name) =>
  `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;

/** @param {string} name @param {unknown} text */
const unitMissing = (name, text) => new RemeshError('INVALID_OPTION',
  `${flagOf(name)} ${text} is a length, but the unit of the model is unknown.`,
  'Say it: --units mm, cm, m or in.');

/** The options that are lengths in the core itself; the others are in percent of the diagonal. */
const plainLengths = ['edgeLength', 'minEdge', 'maxEdge', 'thickness'];

/**
 * The options as the core takes them: lengths in the model's units, those in place of a percentage
 * apart from the others.
 * @param {Record<string, unknown>} options checked
 * @param {string} [unit] of the model
 * @returns {Record<string, unknown>}
 */
export function inModelUnits(options, unit) {
  /** @type {Record<string, unknown>} */
  const result = {};
  /** @type {Record<string, number>} */
  const lengths = {};
  for (const [name, value] of Object.entries(options)) {
    const length = name === 'lods' ? undefined : lengthFrom(value);
    if (!length) {
      result[name] = value;
      continue;
    }
    if (unit === undefined) throw unitMissing(name, value);
    const size = (length.value * metresIn(length.unit)) / metresIn(unit);
    if (plainLengths.includes(name)) result[name] = size;
    else lengths[name] = size;
  }
  const pixels = Array.isArray(options.lods) ? options.lods.map(pixelsFrom) : [];
  if (pixels.length > 0) {
    Object.assign(result, { lods: Float64Array.from(/** @type {number[]} */ (pixels)),
      lodsBy: 'pixels' });
  }
  return Object.keys(lengths).length > 0 ? { ...result, lengths } : result;
}

/** Three significant digits. @param {number} value */
const short = (value) => Number(value.toPrecision(3));

/**
 * A length for people: metres of small models in millimetres.
 * @param {number} length in the model's unit @param {string} unit @param {number} diagonal
 */
export function lengthInWords(length, unit, diagonal) {
  const largest = 5; // metres: larger models are spoken of in metres
  return unit === 'm' && diagonal <= largest ? `${short(1000 * length)} mm`
    : `${short(length)} ${unit}`;
}
