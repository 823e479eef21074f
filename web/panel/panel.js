// SPDX-License-Identifier: MIT
// The form, made from the package's option table: a new row there is a new field here. A field
// left at its default is left out of the options, so the scheme's own defaults hold.
import { defaultOf, optionRules, optionTable, repairNames } from 'remesher/options';
import { byId, element } from '../base/dom.js';
import { t, textIfAny } from '../base/i18n.js';
import { ofTextures, ownChoices, presets, withPreset } from '../model/presets.js';
import { Doors } from './doors.js';
import { isRepairOnly, purposes } from '../model/purposes.js';
import {
  choiceName, optionHelp, optionName, optionUnit, valuesInWords,
} from './option_words.js';
import { TargetField } from './target_field.js';

/** @typedef {import('remesher/options').Option} Option */
/** @typedef {import('../model/address.js').Values} Values */
/** @typedef {'best' | 'rounds'} Scheme */
/** @typedef {HTMLInputElement | HTMLSelectElement} Control */

/** @param {Option} option @param {Scheme} scheme */
const defaultText = (option, scheme) =>
  choiceName(option, String(defaultOf(option, scheme) ?? textIfAny(`default.${option.name}`)
    ?? t('none')));

/** Whether a slider suits the option: its range is 0 to 1. @param {Option} option */
const isShare = ({ min, max, word }) => !word && min === 0 && max === 1;

/** @param {Option} option @returns {Control} */
function controlFor(option) {
  const id = `option-${option.name}`;
  const described = { id, name: option.name, 'aria-describedby': `${id}-help` };
  if (option.type === 'boolean') return element('input', { ...described, type: 'checkbox' });
  if (option.type === 'choice') {
    const choices = ['', ...option.choices ?? []];
    return element('select', described,
      ...choices.map((choice) => element('option', { value: choice }, choiceName(option, choice))));
  }
  const limits = { min: option.min ?? option.above ?? '', max: option.max ?? '' };
  if (isShare(option)) {
    return element('input', { ...described, type: 'range', ...limits, step: '0.05' });
  }
  // A field that also takes a word cannot be of type number.
  if (option.word) return element('input', { ...described, type: 'text', autocomplete: 'off' });
  return element('input', { ...described, type: 'number', ...limits, step: 'any' });
}

/** The step of sliders whose values are above 0, in percent of the diagonal. */
const fineStep = 0.1;
/** The core's default for the gap, in percent of the diagonal. */
const gapIfNone = 2;

/** Whether the option has a slider beside its field; the field takes more values.
 * @param {Option} option */
const hasHandle = ({ word, above, max }) =>
  max !== undefined && Boolean(word || above === 0);

/** A slider beside a field that also takes a word.
 * @param {Option} option @param {Control} control */
function handleFor(option, control) {
  const { name, min, max, default: standard } = option;
  const start = typeof standard === 'object' ? standard.best : standard;
  const handle = element('input', { type: 'range', id: `handle-${name}`, className: 'handle',
    min: String(min ?? fineStep), max: String(max), step: String(min === undefined ? fineStep : 1),
    'aria-label': optionName(option) });
  handle.value = String(start ?? gapIfNone);
  handle.addEventListener('input', () => { control.value = handle.value; });
  return handle;
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
  return element('div', { className: `field ${option.type}` }, label, control,
    hasHandle(option) && handleFor(option, control), help);
}

/** The value of a control; undefined for the default.
 * @param {Option} option @param {Control} control */
function valueOf(option, control) {
  if (control instanceof HTMLInputElement && control.type === 'checkbox') {
    return control.checked !== Boolean(option.default) ? control.checked : undefined;
  }
  if (control.type === 'range' && !control.dataset.touched) return undefined;
  const text = control.value.trim();
  if (!text) return undefined;
  const isWord = option.type === 'choice' || text.toLowerCase() === option.word;
  return isWord ? text.toLowerCase() : Number(text.replace(',', '.'));
}

/** Not in the form: options without a flag, which take arrays, and those with `form: false`.
 * @param {Option} option */
const belongsInForm = ({ name, flag, form }) =>
  flag && form !== false && !TargetField.names.includes(name);

const ofRepair = ['repair', 'holesUpTo', 'gap', 'cavities', 'sheets', 'keepRims', 'thickness',
  'base', 'unite', 'dropBelow', 'dropHidden'];

/** Whether a control chooses the work, which runs by itself. @param {EventTarget | null} target */
const isWork = (target) => target instanceof HTMLInputElement && target.name === 'work';

export class Panel {
  #form;
  #target = new TargetField();
  #doors;
  /** The settings beside the options: the purpose, and whether the model is only repaired.
   * @type {Values} */
  #wish = {};
  /** @type {{ option: Option, control: Control }[]} */
  #fields = [];
  #button = element('button', { type: 'submit', className: 'wide', disabled: true });
  #options = byId('options', HTMLFormElement);

  /** Shown only if the model has something to paint textures from. */
  #textures = element('div', { className: 'textures', hidden: true });
  #repair = element('div', { className: 'repair' });
  #asked = element('p', { id: 'asked', className: 'help' });
  /** The target and the texture options that no purpose has set. @type {Values} */
  #own = {};
  /** The unit and the size of the model, once they are known.
   * @type {import('./option_words.js').Lengths | undefined} */
  #lengths;
  /** Whether the result is updated while options change. */
  #live = element('input', { id: 'live', type: 'checkbox', checked: true });
  #acts;

  /** @param {HTMLFormElement} form
   * @param {{ onSubmit: () => void, onMove: () => void, onSettle: () => void }} acts onMove: while
   *   a value changes; onSettle: when it has */
  constructor(form, acts) {
    this.#form = form;
    this.#acts = acts;
    this.#doors = new Doors({ onChoose: (values) => this.#run(values),
      onAmount: (values) => this.setValues(values) });
    this.build();
    for (const part of [form, this.#options]) {
      part.addEventListener('change', ({ target }) => {
        if (target !== this.#live && !isWork(target)) acts.onSettle();
      });
      part.addEventListener('submit', (event) => {
        event.preventDefault();
        acts.onSubmit();
      });
    }
    form.addEventListener('input', ({ target }) => {
      if (!isWork(target)) acts.onMove();
    });
    this.#options.addEventListener('input', ({ target }) => this.#onInput(target));
  }

  /** @param {EventTarget | null} target */
  #onInput(target) {
    if (target === this.#live) return;
    if (target instanceof HTMLInputElement) target.dataset.touched = 'true';
    const { name } = /** @type {Control} */ (target);
    if (!repairNames.some((own) => own === name)) delete this.#wish.work;
    this.#showDefaults();
    this.#acts.onMove();
  }

  get isLive() {
    return this.#live.checked;
  }

  /** Makes the fields in the current language; their values stay. */
  build() {
    const values = this.values();
    this.#target.build();
    this.#doors.build();
    this.#fields = optionTable.filter(belongsInForm)
      .map((option) => ({ option, control: controlFor(option) }));
    this.#button.textContent = t('remesh');
    const live = element('label', { className: 'inline-check' }, this.#live, t('live'));
    const others = this.#fields.filter(({ option: { name } }) =>
      ![...ofTextures, ...ofRepair].includes(name));
    const viewsOf = (/** @type {string[]} */ names) => this.#views(this.#fields
      .filter(({ option }) => names.includes(option.name)));
    this.#textures.replaceChildren(...viewsOf(ofTextures));
    this.#repair.replaceChildren(...viewsOf(ofRepair));
    this.#form.replaceChildren(this.#doors.view, this.#button);
    this.#options.replaceChildren(this.#target.view, this.#presets(), this.#textures,
      this.#repair, this.#moreOptions(others), live);
    this.#showUnits();
    this.setValues(values);
  }

  #presets() {
    const buttons = presets.map((preset) => element('button', { type: 'button', className: 'chip',
      id: `preset-${preset.id}`, onclick: () =>
        this.#change(withPreset(preset, this.#own)) },
    t(`preset.${preset.id}`)));
    return element('div', { className: 'presets', role: 'group', 'aria-label': t('presets') },
      ...buttons, this.#asked);
  }

  /** Sets values by a button, and runs with them at once. @param {Values} values */
  #run(values) {
    this.setValues(values);
    this.#acts.onSettle();
    this.#acts.onSubmit();
  }

  /** Repairs the model, and remeshes it unless it is only to be repaired.
   * @param {boolean} isOnly */
  repair(isOnly) {
    this.#doors.repair(isOnly);
  }

  /** Runs with some options beside those that are set; an empty one is no longer set.
   * @param {Values} values */
  runWith(values) {
    const all = { ...this.values(), ...values };
    this.#run(Object.fromEntries(Object.entries(all).filter(([, value]) => value !== '')));
  }

  /** Sets values by a button, as if they had been typed. @param {Values} values */
  #change(values) {
    this.setValues(values);
    this.#acts.onMove();
    this.#acts.onSettle();
  }

  /** @param {{ option: Option, control: Control }[]} fields */
  #views(fields) {
    return fields.map(({ option, control }) => fieldFor(option, control));
  }

  /** @param {{ option: Option, control: Control }[]} fields */
  #moreOptions(fields) {
    const reset = element('button', { type: 'button', className: 'link' }, t('defaults'));
    reset.addEventListener('click', () => this.#change(this.#own));
    return element('details', { className: 'more' },
      element('summary', {}, t('moreOptions')), ...this.#views(fields), reset);
  }

  /** @returns {Scheme} */
  get #scheme() {
    const scheme = this.#fields.find(({ option }) => option.name === 'scheme');
    return scheme?.control.value === 'rounds' ? 'rounds' : 'best';
  }

  /** Shows in untouched fields their defaults, which can depend on the scheme. */
  #showDefaults() {
    for (const { option, control } of this.#fields) {
      const text = defaultText(option, this.#scheme);
      if (control instanceof HTMLSelectElement) {
        control.options[0].text = t('default', { value: text });
      } else if (control.type !== 'range') {
        control.placeholder = text;
        const handle = control.parentElement?.querySelector('input.handle');
        if (handle instanceof HTMLInputElement && Number(control.value)) {
          handle.value = control.value;
        }
      } else {
        if (!control.dataset.touched) control.value = text;
        const output = control.parentElement?.querySelector('output');
        if (output) output.value = control.value;
      }
    }
    this.#showAsked();
  }

  /** Shows which options were set, in a line and at their fields. */
  #showAsked() {
    const values = this.values();
    this.#own = ownChoices(values, this.#own);
    this.#asked.textContent = valuesInWords(values);
    this.#target.follow(values);
    this.#doors.show(values);
    this.#button.textContent = t(isRepairOnly(values) ? 'repairOnly' : 'remesh');
    for (const { option, control } of this.#fields) {
      const field = /** @type {HTMLElement | null} */ (control.closest('.field'));
      field?.classList.toggle('set', values[option.name] !== undefined);
      const help = field?.querySelector('.help');
      const choice = values[option.name] ?? String(option.default);
      if (help && option.type === 'choice') help.textContent = optionHelp(option, choice);
      if (field) field.hidden = optionRules.isIdle(option.name, values);
    }
  }

  /** The angle from which an edge can be a feature, in degrees; Infinity where none can. */
  get featureAngle() {
    const option = optionTable.find(({ name }) => name === 'featureAngle');
    const value = this.values().featureAngle ?? (option && defaultOf(option, this.#scheme));
    return value === 'off' ? Infinity : Number(value);
  }

  /** Sets one option, as if it had been typed.
   * @param {string} name @param {string | number} value @param {boolean} isChosen finally */
  ask(name, value, isChosen) {
    this.setValues({ ...this.values(), [name]: value });
    this.#acts.onMove();
    if (isChosen) this.#acts.onSettle();
  }

  /** @returns {Values} the options that were set; all others are left out */
  values() {
    const values = { ...this.#wish, ...this.#target.value() };
    if (isRepairOnly(values)) delete values.vertices;
    for (const { option, control } of this.#fields) {
      const value = valueOf(option, control);
      if (value !== undefined) values[option.name] = value;
    }
    for (const { option: { name } } of this.#fields) {
      if (optionRules.isIdle(name, values)) delete values[name];
    }
    return values;
  }

  /** @param {Values} values */
  setValues(values) {
    const { purpose, work } = values;
    const isKnown = purposes.some((one) => one === purpose);  // an address can say anything
    this.#wish = { ...(isKnown && { purpose }), ...(isKnown && work && { work }) };
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

  /** Takes the size of a new model, by which targets are measured.
   * @param {number} vertices of the input @param {number} [target] the default; the input's size,
   *   if that is not large, if not given */
  setInput(vertices, target) {
    this.#own = {};
    this.#target.setInput(vertices, target);
    this.#button.disabled = false;
  }

  /** @param {number} count of the guides drawn on the model */
  setGuides(count) {
    this.#doors.setGuides(count);
  }

  /** No purpose can be chosen until the next model is known: its number would be the last one's. */
  forgetSubject() {
    this.#doors.forgetSubject();
  }

  /** The facts about the model that the purposes make their numbers of.
   * @param {import('../model/purposes.js').Subject} subject isPaintable: whether new textures can
   *   be painted from it @param {{ ofAmount: string, ofModel: string }} units of lengths */
  setSubject(subject, { ofAmount, ofModel }) {
    this.#doors.setSubject(subject, ofAmount);
    this.#lengths = { unit: ofModel, diagonal: subject.diagonal };
    this.#showUnits();
    this.#setPaintable(subject.isPaintable);
    this.#doors.show(this.values());
  }

  /** Says lengths in the model's unit, and percentages of its diagonal as lengths, too. */
  #showUnits() {
    this.#target.setUnit(this.#lengths?.unit ?? '');
    for (const { option, control } of this.#fields) {
      const unit = control.closest('.field')?.querySelector('.unit');
      if (unit) unit.textContent = `, ${optionUnit(option, this.#lengths)}`;
    }
  }

  /** @param {boolean} isPaintable */
  #setPaintable(isPaintable) {
    this.#textures.hidden = !isPaintable;
    if (isPaintable) return;
    const others = Object.entries(this.values()).filter(([name]) => !ofTextures.includes(name));
    this.setValues(Object.fromEntries(others));
  }

  /** Asks for the vertices that isotropic triangles need, and says so. @param {number} vertices */
  setEnough(vertices) {
    this.#target.setEnough(vertices);
  }

  /** @param {'idle' | 'busy' | 'drafting'} state */
  setState(state) {
    this.#button.hidden = state === 'busy';
  }
}
