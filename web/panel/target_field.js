// SPDX-License-Identifier: MIT
// How fine the result shall be: a number of vertices with a slider, or a share of the input's, or
// an edge length. Just one of them is ever asked for.
import { optionTable } from 'remesher/options';
import { element } from '../base/dom.js';
import { count, sentence, words } from '../base/format.js';

/** @typedef {import('../model/address.js').Values} Values */

/** A first run shall not take long, whatever was dropped. */
const largestDefault = 100_000;

/** Two significant digits: what a person would have typed. @param {number} value */
function rounded(value) {
  const unit = 10 ** Math.max(0, Math.floor(Math.log10(value)) - 1);
  return Math.round(value / unit) * unit;
}

const times = { maximumSignificantDigits: 2 };
const percents = { ...times, style: /** @type {const} */ ('percent') };

export class TargetField {
  static names = ['vertices', 'ratio', 'edgeLength'];

  #inputVertices = 0;
  #kind = element('select', { 'aria-label': 'Target' });
  #number = element('input', { id: 'target', type: 'number', min: '0', step: 'any',
    'aria-label': 'Target value', 'aria-describedby': 'target-hint' });
  #slider = element('input', { type: 'range', min: '0', max: '1', step: '0.002',
    'aria-label': 'Vertices, by slider' });
  #hint = element('p', { className: 'help', id: 'target-hint' });
  /** What belongs above the rest of the form. */
  view;

  constructor() {
    const rows = optionTable.filter(({ name }) => TargetField.names.includes(name));
    for (const { name } of rows) this.#kind.append(element('option', { value: name }, words(name)));
    this.view = element('div', { className: 'target' },
      element('div', { className: 'target-line' }, this.#kind, this.#number),
      this.#slider, this.#hint);
    this.#kind.addEventListener('change', () => this.#changeKind());
    this.#number.addEventListener('input', () => this.#show());
    this.#slider.addEventListener('input', () => {
      this.#number.value = String(this.#fromSlider(Number(this.#slider.value)));
      this.#showHint();
    });
    this.#show();
  }

  get #isVertices() {
    return this.#kind.value === 'vertices';
  }

  get #range() {
    const own = this.#inputVertices;
    return { least: Math.max(20, own / 50), most: Math.max(2000, own * 10) };
  }

  /** The slider is logarithmic, and rests on the input's own number when near it.
   * @param {number} position */
  #fromSlider(position) {
    const { least, most } = this.#range;
    const value = least * (most / least) ** position;
    const isNear = Math.abs(Math.log(value / this.#inputVertices)) < 0.02;
    return isNear ? this.#inputVertices : rounded(value);
  }

  #toSlider() {
    const { least, most } = this.#range;
    return Math.log(Number(this.#number.value) / least) / Math.log(most / least);
  }

  #changeKind() {
    const starts = /** @type {Record<string, string>} */ ({
      vertices: String(this.#defaultVertices), ratio: '0.5', edgeLength: '' });
    this.#number.value = starts[this.#kind.value];
    this.#show();
  }

  get #defaultVertices() {
    return Math.min(this.#inputVertices, largestDefault) || '';
  }

  #show() {
    this.#slider.hidden = !this.#isVertices;
    if (this.#isVertices && this.#inputVertices) this.#slider.value = String(this.#toSlider());
    this.#showHint();
  }

  #showHint() {
    const help = this.#option?.help ?? '';
    this.#hint.textContent = this.#isVertices ? this.#verticesHint() : sentence(help);
  }

  get #option() {
    return optionTable.find(({ name }) => name === this.#kind.value);
  }

  #verticesHint() {
    const original = this.#inputVertices;
    const share = Number(this.#number.value) / original;
    if (!original || !share) return 'The result has exactly this many.';
    if (share === 1) return 'Exactly as many as the original has.';
    const ratio = share < 1 ? `${share.toLocaleString('en', percents)} of`
      : `${share.toLocaleString('en', times)} times`;
    return `Exactly; ${ratio} the original’s ${count(original)}.`;
  }

  /** @returns {Values} */
  value() {
    const text = this.#number.value.trim();
    return text ? { [this.#kind.value]: Number(text) } : {};
  }

  /** @param {Values} values */
  setValue(values) {
    const name = TargetField.names.find((candidate) => values[candidate] !== undefined);
    this.#kind.value = name ?? 'vertices';
    this.#number.value = String(name ? values[name] : this.#defaultVertices);
    this.#show();
  }

  /** @param {number} vertices */
  setInput(vertices) {
    this.#inputVertices = vertices;
    this.#changeKind();
  }
}
