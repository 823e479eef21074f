// SPDX-License-Identifier: MIT
// remesher/card: the words of a report card, in three languages.

import { cardWords } from './base/card_words.js';

export { cardWords };

/**
 * @typedef {import('./base/messages.js').Card} Card
 * @typedef {import('./base/messages.js').CardLanguage} CardLanguage
 * @typedef {import('./base/messages.js').CardSide} CardSide
 * @typedef {import('./base/card_words.js').CardWords} CardWords
 */

/**
 * A line of a card.
 * @typedef {object} CardRow
 * @property {'triangles' | 'quads' | 'vertices' | 'pieces' | 'closed' | 'nonManifoldEdges'
 *   | 'selfIntersections' | 'hidden' | 'coverage' | 'distance' | 'bytes'} name Its subject.
 * @property {string} label The same in words.
 * @property {string} before Empty for what only the result has.
 * @property {string} after In words, with the numbers as the language writes them.
 */

/**
 * @typedef {object} CardTextOptions
 * @property {CardLanguage} [language] English if not given.
 * @property {string} [title] The heading, such as the file's name.
 */

/** The language if none is given. */
const usual = 'en';

/** Percent: smaller figures are rounding. */
const leastShown = 0.0001;

const unitsOfBytes = ['byte', 'kilobyte', 'megabyte', 'gigabyte'];

/** Numbers as a language writes them. @param {CardLanguage} language */
function numbersIn(language) {
  const number = (/** @type {number} */ value, /** @type {Intl.NumberFormatOptions} */ how = {}) =>
    new Intl.NumberFormat(language, how).format(value);
  const short = (/** @type {number} */ value) => number(value, { maximumSignificantDigits: 3 });
  const share = (/** @type {number} */ value) => (value > 0 && value < leastShown
    ? `< ${number(leastShown, { maximumSignificantDigits: 1 })} %` : `${short(value)} %`);
  const size = (/** @type {number} */ bytes) => {
    const step = Math.min(3, Math.max(0, Math.floor(Math.log10(bytes || 1) / 3)));
    return number(bytes / 1000 ** step,
      { style: 'unit', unit: unitsOfBytes[step], maximumSignificantDigits: 3 });
  };
  return { number, short, share, size };
}

/** Metres below one are said in millimetres; without a unit a length says nothing to a reader.
 * @param {NonNullable<Card['distance']>} distance @param {(value: number) => string} short */
function lengthOf({ percent, length, unit }, short) {
  if (unit === undefined || percent < leastShown) return '';
  const isSmall = unit === 'm' && length < 1;
  return isSmall ? ` (${short(1000 * length)} mm)` : ` (${short(length)} ${unit})`;
}

/**
 * The lines of a card, of all that is known.
 *
 * @example
 * for (const { label, before, after } of cardRows(report.card, 'de')) console.log(label, after);
 *
 * @param {Card} card Of the report on a file that was remeshed or repaired.
 * @param {CardLanguage} [language] English if not given.
 * @returns {CardRow[]} One line for each figure.
 */
export function cardRows(card, language = usual) {
  const { before, after, distance, hidden, coverage } = card;
  const words = cardWords[language];
  const { number, short, share, size } = numbersIn(language);
  const row = (/** @type {CardRow['name']} */ name, /** @type {string} */ first,
    /** @type {string} */ second) => ({ name, label: words[name], before: first, after: second });
  const both = (/** @type {CardRow['name']} */ name,
    /** @type {(side: CardSide) => string} */ said) => row(name, said(before), said(after));
  const counted = (/** @type {'quads' | 'nonManifoldEdges' | 'selfIntersections'} */ name) =>
    (before[name] || after[name]
      ? [both(name, (side) => (side[name] === undefined ? '–' : number(side[name] ?? 0)))] : []);
  return [
    both('triangles', ({ triangles }) => number(triangles)),
    ...counted('quads'),
    both('vertices', ({ vertices }) => number(vertices)),
    both('pieces', ({ pieces }) => number(pieces)),
    both('closed', ({ closed, openEdges }) => (closed ? words.yes
      : words.no.replace('{count}', number(openEdges)))),
    ...counted('nonManifoldEdges'),
    ...(before.selfIntersections === undefined ? []
      : [both('selfIntersections', ({ selfIntersections = 0 }) => number(selfIntersections))]),
    ...(hidden === undefined ? [] : [row('hidden', number(hidden), number(0))]),
    ...(coverage === undefined ? [] : [row('coverage', '', share(coverage))]),
    ...(distance ? [row('distance', '', words.ofDiagonal.replace('{share}',
      share(distance.percent)) + lengthOf(distance, short))] : []),
    both('bytes', ({ bytes }) => size(bytes)),
  ];
}

/** What would end a cell of a table, or begin something else. @param {string} text */
const plain = (text) => text.replace(/\s+/g, ' ').replace(/[\\|`*_<>[\]#]/g, '\\$&');

/**
 * A card as a page of Markdown: a table of figures before and after.
 *
 * @example
 * await writeFile('card.md', cardText(report.card, { title: 'helmet.glb' }));
 *
 * @param {Card} card Of the report on a file that was remeshed or repaired.
 * @param {CardTextOptions} [options] The language and the heading.
 * @returns {string} The text, which ends with its last line.
 */
export function cardText(card, options = {}) {
  const { language = usual, title } = options;
  const words = cardWords[language];
  return [
    `# ${title === undefined ? words.title : `${words.title}: ${plain(title)}`}`, '',
    `| ${words.figure} | ${words.before} | ${words.after} |`, '|---|---:|---:|',
    ...cardRows(card, language).map(({ label, before, after }) =>
      `| ${label} | ${before} | ${after} |`), '',
  ].join('\n');
}
