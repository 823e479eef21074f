// SPDX-License-Identifier: MIT
// Saves a result as files, a report or a picture, and copies texts such as its command line.
import { cardText } from 'remesher/card';
import { formats } from 'remesher/formats';
import { element } from '../base/dom.js';
import { count, fileSize, length } from '../base/format.js';
import { language, t } from '../base/i18n.js';
import { saidAs } from '../base/said.js';
import { packed } from '../files/archives.js';
import { extensionOf } from '../files/files.js';
import { download } from '../panel/downloads.js';
import { announce, showNews } from '../panel/messages.js';
import { trianglesOnly } from '../model/losses.js';
import { unitOption } from './measures.js';

/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('../files/files.js').NamedBytes} NamedBytes */
/** @typedef {import('../model/result.js').Result} Result */

/** The format in which a result is saved first: the model's own, unless that cuts quads in two.
 * @param {string} name of the model @param {import('../model/address.js').Values} values */
export function downloadFormat(name, { quads }) {
  const own = extensionOf(name);
  if (quads && trianglesOnly.includes(own)) return 'obj';
  return formats.find((format) => format === own) ?? formats[0];
}

/** The formats of other programs for each purpose; not glTF for quads, which few of them read. */
const formatsFor = /** @type {Record<string, string[]>} */ ({
  asset: ['glb'], print: ['3mf'], simulation: ['msh', 'inp'], quads: ['obj'] });

/** The formats that are offered beside the first. @param {string} first
 * @param {import('../model/address.js').Values} values */
export const besides = (first, { purpose }) =>
  (formatsFor[String(purpose)] ?? []).filter((format) => format !== first);

/** The words on the button that saves. @param {string} format @param {number | null} size bytes */
export const downloadLabel = (format, size) => [
  t('download.first', { format: format === 'gltf' ? t('download.gltf') : format.toUpperCase() }),
  size === null ? '' : element('small', {}, fileSize(size))];

/** Number of levels of detail. */
const levelCount = 4;

/** @param {NamedBytes} file */
function save(file) {
  download(file);
  announce(t('saved', { name: file.name }));
}

/** Saves one file as it is, several files (such as an OBJ with its materials) as one ZIP.
 * @param {NamedBytes[]} files @param {string} zipName @returns {Promise<string>} the name */
async function hand(files, zipName) {
  const file = files.length === 1 ? files[0] : await packed(zipName, files);
  download(file);
  return file.name;
}

/** Farther from the origin, in diagonals, single precision changes the shape as written. */
const farDiagonals = 16;

/** Says that an STL, whose numbers are of single precision, is rounded, if it is by much.
 * @param {Page} page @param {string} format */
function roundingOf({ stage, surveying }, format) {
  const farthest = Math.max(...stage.origin.toArray().map(Math.abs));
  if (format !== 'stl' || farthest < farDiagonals * surveying.diagonal) return [];
  const step = 2 ** (Math.floor(Math.log2(farthest)) - 23);
  return [t('loss.digits', { format: 'STL', step: length(step) })];
}

/** Saves a result in a format, and says what the format does not hold.
 * @param {Page} page @param {Result} result @param {string} format */
async function saveAs(page, result, format) {
  const { session } = page;
  const { files, losses, warnings } =
    await session.filesIn(result, format, unitOption(page));
  const name = await hand(files, result.nameIn('zip'));
  const lacks = [
    ...losses.map(({ kind, count: total }) =>
      t(`loss.${kind}`, { format: format.toUpperCase(), count: count(total) })),
    ...roundingOf(page, format),
    ...warnings.map(({ code, message }) => saidAs('warning', code, message).text),
  ];
  if (lacks.length) showNews([t('saved', { name }), ...lacks].join(' '));
}

/** @param {Page} page @param {Result} result @param {boolean} hasBackground */
async function picture({ stage }, result, hasBackground) {
  const bytes = await stage.picture({ scale: 2, hasBackground });
  if (bytes) download({ name: result.nameIn('png'), bytes });
}

/** @param {string} text */
async function copy(text) {
  await navigator.clipboard.writeText(text);
  showNews(t('copied'));
}

/** The report card of a result with what the page knows better: the size of the file in the format
 * that is saved first, the unit, and the distance after a repair alone.
 * @param {Page} page @param {Result} result */
function cardOf({ session: { model, shown }, surveying }, result) {
  const { card } = result.report;
  const { scale: { name, size }, diagonal, distances } = surveying;
  const percent = card.distance?.percent
    ?? (result === shown && distances ? 100 * distances.largest / diagonal : undefined);
  const bytes = result.sizeIn(downloadFormat(model?.name ?? '', result.values))
    ?? card.after.bytes;
  return { ...card, after: { ...card.after, bytes },
    ...(percent === undefined ? {} : { distance: { percent,
      length: percent / 100 * diagonal / size, ...(name ? { unit: name } : {}) } }) };
}

/** @param {Page} page @param {Result} result */
export function savingActs(page, result) {
  const { session } = page;
  return {
    onFormat: (/** @type {string} */ format) =>
      page.busy(() => saveAs(page, result, format)),
    onLevels: () => page.busy(async () => {
      await hand(await session.levels(result, levelCount), result.nameIn('zip', 'lods'));
    }),
    onCard: () => {
      const text = cardText(cardOf(page, result),
        { language: language(), title: session.model?.name });
      save({ name: result.nameIn('md', 'card'), bytes: new TextEncoder().encode(text) });
    },
    onReport: () => {
      const text = `${JSON.stringify(result.report, null, 2)}\n`;
      save({ name: result.nameIn('json', 'report'), bytes: new TextEncoder().encode(text) });
    },
    onFile: save,
    onPicture: (/** @type {boolean} */ hasBackground) =>
      page.busy(() => picture(page, result, hasBackground)),
    onCopy: (/** @type {string} */ text) => page.busy(() => copy(text)),
  };
}
