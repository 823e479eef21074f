// SPDX-License-Identifier: MIT
// A cut through the models: a plane across one axis hides the part in front of it, so that inner
// shells are visible.
import { Plane, Vector3 } from 'three';
import { addCommand } from '../base/commands.js';
import { byId, element } from '../base/dom.js';
import { t } from '../base/i18n.js';

/** @typedef {0 | 1 | 2} Axis x, y, z */

const names = ['X', 'Y', 'Z'];
const axes = /** @type {Axis[]} */ ([0, 1, 2]);

export class Cutting {
  #viewer;
  #box = byId('cut-box', HTMLElement);
  #button = byId('cut', HTMLButtonElement);
  #slider = element('input', { id: 'cut-depth', type: 'range', min: '0', max: '1', step: '0.005',
    value: '0.5', oninput: () => this.refresh() });
  /** @type {Axis} */
  #axis = 2;
  /** The direction along the axis, 1 or -1, in which the model is cut away. */
  #side = 1;

  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.#viewer = viewer;
    addCommand('cut', () => this.#toggle(!this.isOn), 'x');
  }

  get isOn() {
    return this.#button.getAttribute('aria-pressed') === 'true';
  }

  /** @param {boolean} isOn */
  #toggle(isOn) {
    this.#button.setAttribute('aria-pressed', String(isOn));
    this.#box.hidden = !isOn;
    if (!isOn) {
      this.refresh();
      return;
    }
    const sizes = this.#viewer.eye.direction.map(Math.abs);
    this.#setAxis(/** @type {Axis} */ (sizes.indexOf(Math.max(...sizes))));
  }

  /** The part on the eye's side is cut away. @param {Axis} axis */
  #setAxis(axis) {
    this.#axis = axis;
    this.#side = this.#viewer.eye.direction[axis] < 0 ? -1 : 1;
    this.#slider.ariaLabel = t('cut.depth');
    this.#box.replaceChildren(
      element('div', { className: 'inline' }, ...axes.map((one) => this.#axisButton(one))),
      this.#slider);
    this.refresh();
  }

  /** @param {Axis} axis */
  #axisButton(axis) {
    const input = element('input', { type: 'radio', name: 'cut-axis', id: `cut-${names[axis]}`,
      checked: axis === this.#axis, onchange: () => this.#setAxis(axis) });
    return element('label', { className: 'inline-check' }, input, names[axis]);
  }

  /** To be called after the models or the cut's settings have changed. */
  refresh() {
    if (!this.isOn) {
      this.#viewer.setCut(null);
      return;
    }
    const { min, max } = this.#viewer.eye.box;
    const [near, far] = this.#side > 0 ? [max, min] : [min, max];
    const at = near.clone().lerp(far, this.#slider.valueAsNumber).getComponent(this.#axis);
    const normal = new Vector3().setComponent(this.#axis, -this.#side);
    this.#viewer.setCut(new Plane(normal, this.#side * at));
  }
}
