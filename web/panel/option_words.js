// SPDX-License-Identifier: MIT
// How options are called and explained in the visitor's language; in English by the package itself.
import { optionTable } from 'remesher/options';
import { sentence, words } from '../base/format.js';
import { textIfAny } from '../base/i18n.js';

/** @typedef {import('remesher/options').Option} Option */

/** @param {Option} option */
export const optionName = ({ name }) => textIfAny(`option.${name}`) ?? words(name);

/** What the option is for, or what the choice means.
 * @param {Option} option @param {string | number | boolean} [choice] */
export const optionHelp = ({ name, help }, choice) => textIfAny(`means.${name}.${choice}`)
  ?? sentence(textIfAny(`help.${name}`) ?? help);

/** @param {Option} option @param {string} choice */
export const choiceName = ({ name }, choice) => textIfAny(`choice.${name}.${choice}`) ?? choice;

/** @param {Option} option */
export const optionUnit = ({ unit }) => unit && (textIfAny(`unit.${unit}`) ?? unit);

/** What was asked for beside the target, in a line.
 * @param {import('../model/address.js').Values} values */
export function valuesInWords(values) {
  return optionTable.filter(({ name }) =>
    values[name] !== undefined && !['vertices', 'ratio', 'edgeLength'].includes(name))
    .map((option) => (values[option.name] === true ? optionName(option)
      : `${optionName(option)} ${choiceName(option, String(values[option.name]))}`)).join(' · ');
}
