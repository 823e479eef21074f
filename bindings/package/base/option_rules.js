// SPDX-License-Identifier: MIT
// Which options go together. The rules are the columns `needs` and `excludes` of the table of
// options; from them come the checks, their sentences, and the fields that the page hides.

import { RemeshError } from './errors.js';

/**
 * The columns of the table of options that matter here.
 * @typedef {object} Option
 * @property {string} name
 * @property {string} type
 * @property {unknown} [default]
 * @property {readonly string[]} [choices]
 * @property {readonly Others[]} [needs]
 * @property {Excludes} [excludes]
 */

/** @typedef {(option: any) => string} Label how the caller knows an option */

/**
 * Options by name, each with the values that are meant; true: any value that is given.
 * @typedef {Readonly<Record<string, true | readonly (string | boolean)[]>>} Others
 */

/**
 * What cannot be given together with an option.
 * @typedef {object} Excludes
 * @property {string} [value] Of the option itself: the only value that excludes the others.
 * @property {Others} others
 * @property {string} why Half a sentence.
 */

/** @param {Option} option @param {unknown} value whether it says more than the default does */
function isGiven(option, value) {
  return value !== undefined && value !== option.default;
}

/** The rules of a table. */
export class OptionRules {
  /** @type {Map<string, Option>} */
  #byName;

  /** @param {readonly Option[]} table */
  constructor(table) {
    this.#byName = new Map(table.map((option) => [option.name, option]));
  }

  /**
   * Whether an option has no effect beside the others.
   * @param {string} name
   * @param {Readonly<Record<string, unknown>>} values
   */
  isIdle(name, values) {
    const needs = this.#byName.get(name)?.needs;
    return needs !== undefined && !needs.some((others) => this.#holds(others, values));
  }

  /**
   * Throws if options are given that do not go together.
   * @param {Readonly<Record<string, unknown>>} given
   * @param {Label} label
   */
  check(given, label) {
    for (const option of this.#byName.values()) {
      if (!isGiven(option, given[option.name])) continue;
      if (this.isIdle(option.name, given)) throw this.#needed(option, label);
      const excluded = this.#excludedBy(option, given);
      if (excluded) throw excludes([this.#spelled(option, given, label),
        this.#spelled(excluded, given, label)], option.excludes?.why);
    }
  }

  /** @param {string} name @returns {Option} */
  #option(name) {
    const option = this.#byName.get(name);
    if (!option) throw new Error(`There is no option ${name}.`);
    return option;
  }

  /** @param {Others} others @param {Readonly<Record<string, unknown>>} values */
  #holds(others, values) {
    return Object.entries(others).every(([name, wanted]) => {
      const option = this.#option(name);
      return wanted === true ? isGiven(option, values[name])
        : wanted.some((value) => value === (values[name] ?? option.default));
    });
  }

  /** @param {Option} option @param {Readonly<Record<string, unknown>>} given */
  #excludedBy({ name, excludes: rule }, given) {
    if (!rule || (rule.value !== undefined && rule.value !== given[name])) return undefined;
    const found = Object.entries(rule.others).find(([other, wanted]) =>
      this.#holds({ [other]: wanted }, given));
    return found && this.#option(found[0]);
  }

  /** An option as the caller gave it. @param {Option} option
   * @param {Readonly<Record<string, unknown>>} given @param {Label} label */
  #spelled(option, given, label) {
    return option.choices ? withValues(option, [String(given[option.name])], label) : label(option);
  }

  /**
   * The alternatives that an option needs, in words; conditions that hold by default are left out.
   * @param {Option} option
   * @param {(other: Option, wanted: Others[string]) => string} spell
   */
  #alternatives(option, spell) {
    return (option.needs ?? []).map((others) => Object.entries(others).flatMap(([name, wanted]) => {
      const other = this.#option(name);
      const isDefault = wanted !== true && wanted.some((value) => value === other.default);
      return isDefault ? [] : [spell(other, wanted)];
    }).join(' and '));
  }

  /** @param {Option} option @param {Label} label */
  #needed(option, label) {
    const all = this.#alternatives(option, (other, wanted) => withValues(other, wanted, label));
    const [first] = this.#alternatives(option, (other, wanted) =>
      withValues(other, wanted === true ? true : wanted.slice(0, 1), label));
    return new RemeshError('INVALID_OPTION', `${label(option)} needs ${all.join(', or ')}.`,
      `Add ${first}.`);
  }
}

/** @param {[string, string]} both @param {string} [why] */
function excludes([one, other], why) {
  return new RemeshError('INVALID_OPTION', `${one} and ${other} exclude each other: ${why}.`,
    'Leave out one of them.');
}

/**
 * `--repair holes or auto` for the command line, `repair: 'holes' or 'auto'` for programs.
 * @param {Option} option
 * @param {true | readonly (string | boolean)[]} values
 * @param {Label} label
 */
function withValues(option, values, label) {
  const isFlag = label(option).startsWith('-');
  if (values === true || (isFlag && option.type === 'boolean')) return label(option);
  const words = values.map((value) =>
    (isFlag || typeof value === 'boolean' ? String(value) : `'${value}'`));
  const last = words.pop();
  const list = words.length > 0 ? `${words.join(', ')} or ${last}` : last;
  return `${label(option)}${isFlag ? '' : ':'} ${list}`;
}
