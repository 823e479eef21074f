// SPDX-License-Identifier: MIT
// How options are called and explained in the visitor's language; in English by the package itself.
import { optionTable } from 'remesher/options';
import { sentence, words } from '../base/format.js';
import { textIfAny } from '../base/i18n.js';

/** @typedef {import('remesher/options').Option} Option */

/** @param {Option} option */
export const optionName = ({ name }) => textIfAny(`option.${name}`) ?? words(name);

/** @param {Option} option */
export const optionHelp = ({ name, help }) => sentence(textIfAny(`help.${name}`) ?? help);

/** @param {Option} option */
export const optionUnit = ({ unit }) => unit && (textIfAny(`unit.${unit}`) ?? unit);

/** What was asked for beside the target, in a line.
 * @param {import('../model/address.js').Values} values */
export function valuesInWords(values) {
  return optionTable.filter(({ name }) =>
    values[name] !== undefined && !['vertices', 'ratio', 'edgeLength'].includes(name))
    .map((option) => (values[option.name] === true ? optionName(option)
      : `${optionName(option)} ${values[option.name]}`)).join(' · ');
}
