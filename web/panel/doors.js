// SPDX-License-Identifier: MIT
// The four purposes, of which the visitor chooses one, and the one number that each has.
import { element } from '../base/dom.js';
import { count } from '../base/format.js';
import { t } from '../base/i18n.js';
import {
  amountOf, firstAmount, isRepairOnly, measured, purposes, rangeOf, valuesFor,
} from '../model/purposes.js';

/** @typedef {import('../model/purposes.js').Purpose} Purpose */
/** @typedef {import('../model/purposes.js').Subject} Subject */
/** @typedef {import('../model/address.js').Values} Values */

/** Steps of the slider, which is logarithmic. */
const sliderStep = '0.004';

export class Doors {
  /** @type {Subject | null} */
  #subject = null;
  #unit = 'mm';
  /** @type {Values} */
  #values = {};
  #acts;
  #doors = element('div', { className: 'doors', role: 'group' });
  #about = element('p', { className: 'help', id: 'purpose-about' });
  #label = element('label', { htmlFor: 'amount' });
  #number = element('input', { id: 'amount', type: 'number', min: '0', step: 'any' });
  #slider = element('input', { id: 'amount-slider', type: 'range', min: '0', max: '1',
    step: sliderStep });
  #amount = element('div', { className: 'amount', hidden: true });
  #works = element('div', { className: 'works', role: 'radiogroup', hidden: true });
  #guides = element('button', { type: 'button', className: 'chip', id: 'guides', 'data-do': 'guide',
    'aria-pressed': 'false' });
  #lines = element('div', { className: 'lines', hidden: true });
  #guideCount = 0;
  view = element('div', { className: 'purposes' });

  /** @param {{ onChoose: (values: Values) => void, onAmount: (values: Values) => void }} acts
   *   onChoose: a purpose, or the work, was chosen; onAmount: the number changes */
  constructor(acts) {
    this.#acts = acts;
    this.#number.addEventListener('input', () => this.#turn(Number(this.#number.value)));
    this.#slider.addEventListener('input', () => {
      const value = this.#fromSlider(this.#slider.valueAsNumber);
      this.#number.value = String(value);
      this.#turn(value);
    });
    this.build();
  }

  /** @returns {Purpose | undefined} */
  get #purpose() {
    return purposes.find((purpose) => purpose === this.#values.purpose);
  }

  /** Writes all words in the current language. */
  build() {
    this.#doors.ariaLabel = t('purposes');
    this.#doors.replaceChildren(...purposes.map((id) => element('button', { type: 'button',
      className: 'door', id: `purpose-${id}`, disabled: !this.#subject,
      onclick: () => this.#choose(id) }, element('b', {}, t(`purpose.${id}`)),
    element('small', {}, t(`purpose.${id}.for`)))));
    this.#works.ariaLabel = t('works');
    this.#works.replaceChildren(...(/** @type {const} */ (['repair', 'remesh'])).map((work) => {
      const input = element('input', { type: 'radio', name: 'work', id: `work-${work}`,
        onchange: () => this.#work(work === 'repair') });
      return element('label', { className: 'inline-check' }, input, t(`work.${work}`));
    }));
    this.#slider.ariaLabel = t('amount.slider');
    this.#amount.replaceChildren(this.#label, this.#number, this.#slider);
    this.setGuides(this.#guideCount);
    this.#lines.replaceChildren(this.#guides,
      element('p', { className: 'help' }, t('guides.help')));
    this.view.replaceChildren(element('h2', {}, t('purposes')), this.#doors, this.#about,
      this.#works, this.#amount, this.#lines);
    this.show(this.#values);
  }

  /** @param {Subject} subject the model @param {string} unit of lengths */
  setSubject(subject, unit) {
    this.#subject = subject;
    this.#unit = unit;
    this.build();
  }

  /** Another model comes, of which nothing is known yet. */
  forgetSubject() {
    this.#subject = null;
    this.build();
  }

  /** @param {number} total of the guides drawn on the model */
  setGuides(total) {
    this.#guideCount = total;
    this.#guides.textContent = total ? t('guides.some', { count: count(total) }) : t('guides');
  }

  /** Shows the purpose, the work and the number of these options. @param {Values} values */
  show(values) {
    this.#values = values;
    const purpose = this.#purpose;
    for (const id of purposes) {
      this.#doors.querySelector(`#purpose-${id}`)?.setAttribute('aria-pressed',
        String(id === purpose));
    }
    const isBaked = purpose === 'asset' && values.textures === 'bake';
    this.#about.textContent = t(isBaked ? 'purpose.asset.baked'
      : purpose ? `purpose.${purpose}.about` : 'purpose.none');
    this.#works.hidden = purpose !== 'print';
    this.#lines.hidden = !values.quads;
    this.#amount.hidden = !purpose || !this.#subject;
    if (!purpose || !this.#subject) return;
    const isOnly = isRepairOnly(values);
    for (const input of this.#works.querySelectorAll('input')) {
      input.checked = input.id === (isOnly ? 'work-repair' : 'work-remesh');
    }
    this.#amount.hidden = purpose === 'print' && isOnly;
    this.#label.textContent = measured.includes(purpose)
      ? `${t(`amount.${purpose}`)}, ${this.#unit}` : t(`amount.${purpose}`);
    const value = amountOf(values, this.#subject) ?? firstAmount(purpose, this.#subject);
    if (document.activeElement !== this.#number) this.#number.value = String(value);
    if (document.activeElement !== this.#slider) {
      this.#slider.value = String(this.#toSlider(value));
    }
  }

  /** @param {Purpose} purpose @param {boolean} [isOnly] for printing: repair only */
  #choose(purpose, isOnly) {
    if (!this.#subject) return;
    this.#acts.onChoose(valuesFor(purpose, firstAmount(purpose, this.#subject), this.#subject,
      { isRepairOnly: isOnly }));
  }

  /** @param {boolean} isOnly */
  #work(isOnly) {
    this.#choose('print', isOnly);
  }

  /** Chooses to repair, or to repair and remesh. @param {boolean} isOnly */
  repair(isOnly) {
    this.#choose('print', isOnly);
  }

  /** @param {number} value */
  #turn(value) {
    const purpose = this.#purpose;
    if (!purpose || !this.#subject || !(value > 0)) return;
    this.#acts.onAmount({ ...this.#values,
      ...valuesFor(purpose, value, this.#subject, { isRepairOnly: false }) });
  }

  get #range() {
    return rangeOf(/** @type {Purpose} */ (this.#purpose), /** @type {Subject} */ (this.#subject));
  }

  /** @param {number} position */
  #fromSlider(position) {
    const { least, most } = this.#range;
    const value = Number((least * (most / least) ** position).toPrecision(2));
    return measured.includes(/** @type {Purpose} */ (this.#purpose)) ? value : Math.round(value);
  }

  /** @param {number} value */
  #toSlider(value) {
    const { least, most } = this.#range;
    return Math.log(value / least) / Math.log(most / least);
  }
}
