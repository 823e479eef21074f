// SPDX-License-Identifier: MIT
// The form, made from the package's option table: a new row there is a new field here. A field
// left at its default is left out of the options, so the scheme's own defaults hold.
import { defaultOf, optionTable } from 'remesher/options';
import { element } from '../base/dom.js';
import { t } from '../base/i18n.js';
import { optionHelp, optionName, optionUnit } from './option_words.js';
import { TargetField } from './target_field.js';

/** @typedef {import('remesher/options').Option} Option */
/** @typedef {import('../model/address.js').Values} Values */
/** @typedef {'best' | 'rounds'} Scheme */
/** @typedef {HTMLInputElement | HTMLSelectElement} Control */

/** @param {Option} option @param {Scheme} scheme */
const defaultText = (option, scheme) => String(defaultOf(option, scheme) ?? t('none'));

/** Whether a row is best served by a slider: both ends known, and close. @param {Option} option */
const isShare = ({ min, max, off }) => !off && min === 0 && max === 1;

/** @param {Option} option @returns {Control} */
function controlFor(option) {
  const id = `option-${option.name}`;
  const described = { id, name: option.name, 'aria-describedby': `${id}-help` };
  if (option.type === 'boolean') return element('input', { ...described, type: 'checkbox' });
  if (option.type === 'choice') {
    const choices = ['', ...option.choices ?? []];
    return element('select', described,
      ...choices.map((choice) => element('option', { value: choice }, choice)));
  }
  const limits = { min: option.min ?? option.above ?? '', max: option.max ?? '' };
  if (isShare(option)) {
    return element('input', { ...described, type: 'range', ...limits, step: '0.05' });
  }
  // A field that takes a word as well cannot be of type number.
  if (option.off) return element('input', { ...described, type: 'text', autocomplete: 'off' });
  return element('input', { ...described, type: 'number', ...limits, step: 'any' });
}

/** @param {Option} option @param {Control} control */
function fieldFor(option, control) {
  const unit = option.unit && element('span', { className: 'unit' }, `, ${optionUnit(option)}`);
  const label = element('label', { htmlFor: control.id }, optionName(option), unit);
  const help = element('p', { id: `${control.id}-help`, className: 'help' }, optionHelp(option));
  if (control.type === 'range') {
    const value = element('output', { htmlFor: control.id });
    return element('div', { className: 'field share' }, label, value, control, help);
  }
  return element('div', { className: `field ${option.type}` }, label, control, help);
}

/** What a control says, undefined for the default.
 * @param {Option} option @param {Control} control */
function valueOf(option, control) {
  if (control instanceof HTMLInputElement && control.type === 'checkbox') {
    return control.checked !== Boolean(option.default) ? control.checked : undefined;
  }
  if (control.type === 'range' && !control.dataset.touched) return undefined;
  const text = control.value.trim();
  if (!text) return undefined;
  const isWord = option.type === 'choice' || (option.off && text.toLowerCase() === 'off');
  return isWord ? text.toLowerCase() : Number(text.replace(',', '.'));
}

/** Rows without a flag take arrays, which no form can ask for. @param {Option} option */
const belongsInForm = ({ name, flag }) => flag && !TargetField.names.includes(name);

export class Panel {
  #form;
  #target = new TargetField();
  /** @type {{ option: Option, control: Control }[]} */
  #fields = [];
  #button = element('button', { type: 'submit', className: 'primary wide', disabled: true });

  /** @param {HTMLFormElement} form @param {() => void} onSubmit */
  constructor(form, onSubmit) {
    this.#form = form;
    this.build();
    form.addEventListener('input', ({ target }) => {
      if (target instanceof HTMLInputElement) target.dataset.touched = 'true';
      this.#showDefaults();
    });
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      onSubmit();
    });
  }

  /** Makes the fields, in the language of the day; what they say stays. */
  build() {
    const values = this.values();
    this.#target.build();
    this.#fields = optionTable.filter(belongsInForm)
      .map((option) => ({ option, control: controlFor(option) }));
    this.#button.textContent = t('remesh');
    this.#form.replaceChildren(this.#target.view, this.#moreOptions(), this.#button);
    this.setValues(values);
  }

  #moreOptions() {
    const fields = this.#fields.map(({ option, control }) => fieldFor(option, control));
    const reset = element('button', { type: 'button', className: 'link' }, t('defaults'));
    reset.addEventListener('click', () => this.setValues(this.#target.value()));
    return element('details', { className: 'more' },
      element('summary', {}, t('moreOptions')), ...fields, reset);
  }

  /** @returns {Scheme} */
  get #scheme() {
    const scheme = this.#fields.find(({ option }) => option.name === 'scheme');
    return scheme?.control.value === 'rounds' ? 'rounds' : 'best';
  }

  /** Untouched fields say what they stand for, which can depend on the scheme. */
  #showDefaults() {
    for (const { option, control } of this.#fields) {
      const text = defaultText(option, this.#scheme);
      if (control instanceof HTMLSelectElement) {
        control.options[0].text = t('default', { value: text });
      } else if (control.type !== 'range') {
        control.placeholder = text;
      } else {
        if (!control.dataset.touched) control.value = text;
        const output = control.parentElement?.querySelector('output');
        if (output) output.value = control.value;
      }
    }
  }

  /** @returns {Values} what was asked for; what was left alone is left out */
  values() {
    const values = this.#target.value();
    for (const { option, control } of this.#fields) {
      const value = valueOf(option, control);
      if (value !== undefined) values[option.name] = value;
    }
    return values;
  }

  /** @param {Values} values */
  setValues(values) {
    this.#target.setValue(values);
    for (const { option, control } of this.#fields) {
      const value = values[option.name];
      if (control instanceof HTMLInputElement && control.type === 'checkbox') {
        control.checked = Boolean(value ?? option.default);
        continue;
      }
      control.value = value === undefined ? '' : String(value);
      if (value === undefined) delete control.dataset.touched;
      else control.dataset.touched = 'true';
    }
    this.#showDefaults();
  }

  /** The model changed: its size is what targets are measured by.
   * @param {number} vertices of the input */
  setInput(vertices) {
    this.#target.setInput(vertices);
    this.#button.disabled = false;
  }

  /** @param {number} vertices to ask for */
  setTarget(vertices) {
    this.#target.setValue({ vertices });
  }

  /** @param {'idle' | 'busy'} state */
  setState(state) {
    this.#button.hidden = state === 'busy';
  }
}
