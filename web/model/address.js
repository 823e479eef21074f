// SPDX-License-Identifier: MIT
// The part of the address after #: a sample, the purpose and the options, as in
// #model=bunny&vertices=2000. It is never sent to a server.
import { optionTable } from 'remesher/options';

/** @typedef {import('remesher/options').Option} Option */
/** @typedef {Record<string, string | number | boolean>} Values */

/** @param {Option} option @param {string} text */
function parse(option, text) {
  if (option.type === 'boolean') return text !== 'false';
  if (option.type === 'choice' || text === option.word) return text;
  return Number(text);
}

/** @param {string} hash @returns {{ model: string | null, values: Values }} */
export function readAddress(hash) {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  /** @type {Values} */
  const values = {};
  for (const option of optionTable) {
    const text = option.flag && option.form !== false && given.get(option.name);
    if (text) values[option.name] = parse(option, text);
  }
  const purpose = given.get('purpose');
  if (purpose) values.purpose = purpose;
  if (given.get('work') === 'repair') values.work = 'repair';
  return { model: given.get('model'), values };
}

/** @param {string | null} model a sample; null for a visitor's own file
 * @param {Values} values @returns {string} */
export function writeAddress(model, values) {
  const given = new URLSearchParams();
  if (model) given.set('model', model);
  for (const [name, value] of Object.entries(values)) given.set(name, String(value));
  return `#${given}`;
}
