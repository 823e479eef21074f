// SPDX-License-Identifier: MIT
// Names and explanations of options in the visitor's language, else the package's English ones.
import { optionTable, targetNames } from 'remesher/options';
import { length, sentence, words } from '../base/format.js';
import { t, textIfAny } from '../base/i18n.js';
import { isRepairOnly } from '../model/purposes.js';

/** @typedef {import('remesher/options').Option} Option */

/** @param {Option} option */
export const optionName = ({ name }) => textIfAny(`option.${name}`) ?? words(name);

/** The option's purpose, or the choice's meaning.
 * @param {Option} option @param {string | number | boolean} [choice] */
export const optionHelp = ({ name, help }, choice) => textIfAny(`means.${name}.${choice}`)
  ?? sentence(namedHere(textIfAny(`help.${name}`) ?? help));

/** A text in which options have the names of the form, not those of the command line.
 * @param {string} text */
const namedHere = (text) => text.replace(/--[a-z][a-z-]*/g, (flag) => {
  const option = optionTable.find((one) => one.flag?.split(' ')[0] === flag);
  return option ? `“${optionName(option)}”` : flag;
});

/** @param {Option} option @param {string} choice */
export const choiceName = ({ name }, choice) => textIfAny(`choice.${name}.${choice}`) ?? choice;

/** The unit of a model's lengths, empty for none, and its diagonal.
 * @typedef {{ unit: string, diagonal: number }} Lengths */

/** @param {Option} option @param {Lengths} [lengths] where they are known */
export function optionUnit({ unit }, lengths) {
  if (lengths?.unit && unit === 'model units') return lengths.unit;
  const own = unit && (textIfAny(`unit.${unit}`) ?? unit);
  if (!lengths || unit !== '% of the diagonal') return own;
  return `${own} (1 % = ${length(lengths.diagonal / 100)} ${lengths.unit || t('unit.some')})`;
}

/** The purpose and the chosen options except the target, in one line.
 * @param {import('../model/address.js').Values} values */
export function valuesInWords(values) {
  const { purpose } = values;
  if (isRepairOnly(values)) return textIfAny('repairOnly') ?? '';
  const options = optionTable.filter(({ name }) =>
    values[name] !== undefined && !targetNames.some((target) => target === name))
    .map((option) => (values[option.name] === true ? optionName(option)
      : `${optionName(option)} ${choiceName(option, String(values[option.name]))}`));
  return [...(purpose ? [textIfAny(`purpose.${purpose}`)] : []), ...options].join(' · ');
}
