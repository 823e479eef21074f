// SPDX-License-Identifier: MIT
// The result's target: a number of vertices with a slider, a number of triangles, a share of the
// input's vertices, or an edge length. Only one of them is set at a time.
import { optionTable, targetNames } from 'remesher/options';
import { element } from '../base/dom.js';
import { count, number } from '../base/format.js';
import { t } from '../base/i18n.js';
import { optionHelp, optionName } from './option_words.js';

/** @typedef {import('../model/address.js').Values} Values */

/** Largest default number of vertices, so that the first run is short even for a large model. */
const largestDefault = 100_000;

/** Rounds to two significant digits, as a person would type. @param {number} value */
function rounded(value) {
  const unit = 10 ** Math.max(0, Math.floor(Math.log10(value)) - 1);
  return Math.round(value / unit) * unit;
}

const times = { maximumSignificantDigits: 3 };
const percents = { maximumSignificantDigits: 2, style: /** @type {const} */ ('percent') };

export class TargetField {
  /** @type {readonly string[]} */
  static names = targetNames;

  #inputVertices = 0;
  /** @type {number | ''} */
  #defaultVertices = '';
  /** Whether the result has exactly the target number of vertices; else nearly. */
  #isExact = true;
  /** The page's own choice of more vertices than the input has; 0: none. */
  #enough = 0;
  #kind = element('select', { id: 'target-kind' });
  #number = element('input', { id: 'target', type: 'number', min: '0', step: 'any',
    'aria-describedby': 'target-hint' });
  #slider = element('input', { id: 'target-slider', type: 'range', min: '0', max: '1',
    step: '0.002' });
  #hint = element('p', { className: 'help', id: 'target-hint' });
  /** The unit of lengths, if known. */
  #unit = '';
  /** The field's elements, to be placed above the rest of the form. */
  view = element('div', { className: 'target' },
    element('div', { className: 'target-line' }, this.#kind, this.#number),
    this.#slider, this.#hint);

  constructor() {
    this.build();
    this.#kind.addEventListener('change', () => this.#changeKind());
    this.#number.addEventListener('input', () => this.#show());
    this.#slider.addEventListener('input', () => {
      this.#number.value = String(this.#fromSlider(Number(this.#slider.value)));
      this.#showHint();
    });
  }

  /** Writes the field's words in the current language. */
  build() {
    const { value } = this.#kind;
    const rows = optionTable.filter(({ name }) => TargetField.names.includes(name));
    this.#kind.replaceChildren(...rows.map((option) =>
      element('option', { value: option.name }, option.unit && this.#unit
        ? `${optionName(option)}, ${this.#unit}` : optionName(option))));
    this.#kind.value = value || 'vertices';
    this.#kind.ariaLabel = t('target');
    this.#number.ariaLabel = t('target.value');
    this.#slider.ariaLabel = t('target.slider');
    this.#show();
  }

  /** @param {string} unit of lengths */
  setUnit(unit) {
    this.#unit = unit;
    this.build();
  }

  get #isVertices() {
    return this.#kind.value === 'vertices';
  }

  get #range() {
    const own = this.#inputVertices;
    return { least: Math.max(20, own / 50), most: Math.max(2000, own * 10) };
  }

  /** The slider is logarithmic, and snaps to the input's number of vertices.
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
      vertices: String(this.#defaultVertices),
      faces: String(2 * Number(this.#defaultVertices) || ''),
      ratio: '0.5', edgeLength: '' });
    this.#number.value = starts[this.#kind.value];
    this.#show();
  }

  #show() {
    this.#slider.hidden = !this.#isVertices;
    if (this.#isVertices && this.#inputVertices) this.#slider.value = String(this.#toSlider());
    this.#showHint();
  }

  #showHint() {
    const option = this.#option;
    const help = option ? optionHelp(option) : '';
    this.#hint.textContent = this.#isVertices ? this.#verticesHint() : help;
  }

  get #option() {
    return optionTable.find(({ name }) => name === this.#kind.value);
  }

  #verticesHint() {
    const original = this.#inputVertices;
    const share = Number(this.#number.value) / original;
    const closely = t(this.#isExact ? 'target.exactly' : 'target.nearly');
    if (!this.#number.value) return '';  // as many as a repair or a tolerance makes
    if (!original || !share) return t(this.#isExact ? 'target.exact' : 'target.near');
    if (share === 1) return t('target.same', { closely });
    if (Number(this.#number.value) === this.#enough) {
      return t('target.enough', { closely, times: number(share, times), count: count(original) });
    }
    return share < 1
      ? t('target.share', { closely, share: number(share, percents), count: count(original) })
      : t('target.times', { closely, times: number(share, times), count: count(original) });
  }

  /** Quads meet the number only within 1 %, unless the option `exact` is set.
   * @param {Values} values of the whole form */
  follow({ quads, exact }) {
    this.#isExact = !quads || Boolean(exact);
    this.#showHint();
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
    // A tolerance alone makes as many vertices as it needs.
    const isFree = values.purpose === 'print' || Number(values.maxError) > 0;
    this.#number.value = String(name ? values[name] : isFree ? '' : this.#defaultVertices);
    this.#show();
  }

  /** More than the input's number, which isotropic triangles need where the input's own are long.
   * @param {number} vertices */
  setEnough(vertices) {
    this.#enough = vertices;
    this.setValue({ vertices });
  }

  /** @param {number} vertices of the input @param {number} [target] the default, if known */
  setInput(vertices, target) {
    this.#inputVertices = vertices;
    this.#defaultVertices = target ?? (Math.min(vertices, largestDefault) || '');
    this.#enough = 0;
    this.#changeKind();
  }
}
