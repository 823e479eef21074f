// SPDX-License-Identifier: MIT
// The view's controls: comparison, shading, wireframe, divider, keys. Without WebGL the page says
// so, and works without a viewer.
import { Vector3 } from 'three';
import { addCommand, isTyping } from '../base/commands.js';
import { byId, element } from '../base/dom.js';
import { count } from '../base/format.js';
import { t } from '../base/i18n.js';
import { Cutting } from './cutting.js';
import { prepare } from './preparation.js';
import { loadScene } from './scene_loader.js';
import { isTooLarge, Thinning } from './thinning.js';
import { Viewer } from './viewer.js';

/** @typedef {import('./viewer.js').Side} Side */
/** @typedef {import('./viewer.js').Shading} Shading */

const narrow = '(max-width: 760px)';

/** @param {Event} event whether the space bar would press the focused element */
const isPressing = ({ target }) => target instanceof Element
  && target.matches('button, summary, select, input');

export class Stage {
  /** Null if the browser has no WebGL. @type {Viewer | null} */
  viewer = null;
  /** @type {Cutting | null} */
  #cutting = null;
  /** The stage's origin, in the original's world. */
  origin = new Vector3();
  /** Called after the shading has changed. */
  onShading = () => {};
  /** Whether the pointer paints or draws, instead of turning the model. */
  isBrushing = false;
  #root = byId('stage', HTMLElement);
  #wireframe = byId('wireframe', HTMLButtonElement);
  #menu = byId('view-menu', HTMLSelectElement);
  /** Null until the visitor chooses; until then textured and thinned models show no wires. */
  #chosenWireframe = /** @type {boolean | null} */ (null);
  /** The latest request of each side; older ones that load later are not shown.
   * @type {Record<Side, number>} */
  #turns = { original: 0, baseline: 0, result: 0 };
  /** @type {import('./viewer.js').Compare} */
  #compare = 'side';
  /** @type {Shading} */
  #shading = 'plain';

  constructor() {
    try {
      this.viewer = new Viewer(byId('canvas', HTMLCanvasElement));
      this.#cutting = new Cutting(this.viewer);
    } catch {
      this.say(t('noWebGL'));
      this.#root.classList.add('blind');
    }
    const canvas = byId('canvas', HTMLCanvasElement);
    canvas.addEventListener('webglcontextlost', () => this.say(t('contextLost')));
    canvas.addEventListener('webglcontextrestored', () => this.say(''));
    this.#wireDivider();
    this.#wireButtons();
    this.#wireKeys();
    this.#setCompare(matchMedia(narrow).matches ? 'wipe' : 'side');
    this.setShading('plain');
  }

  /** Shows a line of text on the stage; an empty text hides it. @param {string} text */
  say(text) {
    const message = byId('stage-message', HTMLElement);
    message.textContent = text;
    message.hidden = !text;
  }

  #wireDivider() {
    const divider = byId('divider', HTMLInputElement);
    const apply = () => {
      // The thumb stays within the track, so its centre does not travel the whole width.
      const thumb = 36, width = divider.clientWidth || 1;
      const x = thumb / 2 + divider.valueAsNumber * (width - thumb);
      this.viewer?.setDivider(x / width);
      this.#root.style.setProperty('--divider', `${(100 * x) / width}%`);
    };
    divider.addEventListener('input', apply);
    divider.addEventListener('dblclick', () => {
      divider.value = '0.5';
      apply();
    });
    new ResizeObserver(apply).observe(divider);
  }

  /** @param {'compare' | 'shading'} group @param {string} value */
  #press(group, value) {
    for (const button of this.#root.querySelectorAll(`[data-${group}]`)) {
      const { dataset } = /** @type {HTMLElement} */ (button);
      button.setAttribute('aria-pressed', String(dataset[group] === value));
    }
    if (group === 'shading') this.#menu.value = value;
  }

  /** Where the window is narrow, a list takes the place of the buttons of the views. */
  fillMenu() {
    const buttons = [...this.#root.querySelectorAll('[data-shading]')];
    this.#menu.replaceChildren(...buttons.map((button) => {
      const { shading = '' } = /** @type {HTMLElement} */ (button).dataset;
      return element('option', { value: shading, disabled: button.hasAttribute('disabled') },
        t(/** @type {'shading.plain'} */ (`shading.${shading}`)));
    }), element('option', { value: 'density', hidden: true }, t('density')));
    this.#menu.value = this.#shading;
  }

  /** @param {import('./viewer.js').Compare} compare */
  #setCompare(compare) {
    this.#compare = compare;
    this.#press('compare', compare);
    this.viewer?.setCompare(compare);
  }

  /** @param {Shading} shading */
  setShading(shading) {
    this.#shading = shading;
    this.#press('shading', shading);
    this.viewer?.setShading(shading);
    this.onShading();
  }

  /** @param {boolean} isOn */
  setBrushing(isOn) {
    this.isBrushing = isOn;
    this.#root.classList.toggle('brushing', isOn);
    this.viewer?.eye.setTurning(!isOn);
  }

  /** On a phone the stage may have been scrolled away. */
  bringIntoView() {
    this.#root.scrollIntoView({ block: 'nearest' });
  }

  get shading() {
    return this.#shading;
  }

  #wireButtons() {
    const buttons = [...this.#root.querySelectorAll('[data-shading]')];
    for (const [i, button] of buttons.entries()) {
      const { dataset } = /** @type {HTMLElement} */ (button);
      const shading = /** @type {Shading} */ (dataset.shading);
      dataset.do = `shading.${shading}`;
      addCommand(dataset.do, () => this.setShading(shading), String(i + 1));
    }
    this.#menu.addEventListener('change', () =>
      this.setShading(/** @type {Shading} */ (this.#menu.value)));
    addCommand('compare.side', () => this.#setCompare('side'));
    addCommand('compare.wipe', () => this.#setCompare('wipe'));
    addCommand('compare', () => this.#setCompare(this.#compare === 'side' ? 'wipe' : 'side'), 'c');
    addCommand('wireframe', () => this.#toggleWireframe(), 'w');
    addCommand('fit', () => this.viewer?.eye.fit(), 'f');
  }

  #toggleWireframe() {
    this.#chosenWireframe = this.#wireframe.getAttribute('aria-pressed') !== 'true';
    this.#setWireframe(this.#chosenWireframe);
  }

  /** @param {boolean} isVisible */
  #setWireframe(isVisible) {
    this.#wireframe.setAttribute('aria-pressed', String(isVisible));
    this.viewer?.setWireframe(isVisible);
  }

  #wireKeys() {
    addEventListener('keydown', (event) => {
      if (event.key !== ' ' || isTyping(event) || isPressing(event)) return;
      if (!document.querySelector('dialog[open]')) this.#hold(event, true);
    });
    addEventListener('keyup', (event) => {
      if (event.key === ' ' && !isPressing(event)) this.#hold(event, false);
    });
  }

  /** @param {Event} event @param {boolean} holds */
  #hold(event, holds) {
    event.preventDefault();  // the page would scroll
    this.viewer?.holdOriginal(holds);
    this.#root.classList.toggle('holding', holds);
  }

  /** @param {Side} side @param {import('./thinning.js').Gltf} gltf */
  async show(side, gltf) {
    if (!this.viewer) return;
    const turn = ++this.#turns[side];
    const thinning = isTooLarge(gltf) ? new Thinning() : null;
    const isOvertaken = () => turn !== this.#turns[side];
    try {
      const bytes = await thinning?.begin(gltf) ?? gltf.bytes;
      if (isOvertaken()) return;
      const scene = await loadScene(bytes, gltf.resources);
      const prepared = await prepare(scene, side === 'original' ? null : this.origin);
      if (isOvertaken()) return;
      this.origin = prepared.origin;
      this.viewer.show(side, prepared, thinning);
    } finally {
      if (this.viewer.view(side)?.thinning !== thinning) thinning?.close();
    }
    this.#cutting?.refresh();
    this.#root.classList.toggle(`has-${side}`, true);
    this.#tellThinned();
    if (side === 'original') this.#suit(this.viewer.isTextured, Boolean(thinning));
  }

  /** Chooses wireframe and shading for the model, unless the visitor chose. The many lines of a
   * thinned model would only be grey. @param {boolean} isTextured @param {boolean} isThinned */
  #suit(isTextured, isThinned) {
    this.#setWireframe(this.#chosenWireframe ?? !(isTextured || isThinned));
    const button = this.#root.querySelector('[data-shading=textured]');
    if (button instanceof HTMLButtonElement) button.disabled = !isTextured;
    this.fillMenu();
    const isPlain = this.#shading === 'plain' || this.#shading === 'textured';
    this.setShading(isPlain ? (isTextured ? 'textured' : 'plain') : this.#shading);
  }

  /** The stage as a PNG; null without WebGL.
   * @param {{ scale: number, hasBackground: boolean }} how */
  async picture({ scale, hasBackground }) {
    const picture = this.viewer?.picture(scale);
    if (!picture) return null;
    const context = picture.getContext('2d');
    if (hasBackground && context) {
      context.globalCompositeOperation = 'destination-over';
      context.fillStyle = getComputedStyle(this.#root).getPropertyValue('background-color');
      context.fillRect(0, 0, picture.width, picture.height);
    }
    return new Uint8Array(await (await picture.convertToBlob()).arrayBuffer());
  }

  /** Says how many triangles are drawn, if not all are. */
  #tellThinned() {
    const left = this.viewer?.view('baseline') ?? this.viewer?.view('original');
    for (const [id, view] of Object.entries({ 'left-thinned': left,
      'right-thinned': this.viewer?.view('result') })) {
      const { shown = 0, all = 0 } = view?.thinning?.thinned ?? {};
      const note = byId(id, HTMLElement);
      note.hidden = !all;
      note.textContent = all ? t('thinned', { shown: count(shown), all: count(all) }) : '';
    }
  }

  /** Sets the left side's name. @param {string} text @param {number} vertices */
  nameLeft(text, vertices) {
    byId('left-name', HTMLElement).textContent = text;
    byId('original-count', HTMLElement).textContent = count(vertices);
    this.#tellThinned();
  }

  /** Sets the right side's name. @param {string} text @param {number} vertices */
  nameRight(text, vertices) {
    byId('right-name', HTMLElement).textContent = text;
    byId('result-count', HTMLElement).textContent = count(vertices);
  }

  /** @param {Side} side */
  clear(side) {
    ++this.#turns[side];
    if (side === 'original') this.origin = new Vector3();
    this.viewer?.show(side, null);
    this.#root.classList.toggle(`has-${side}`, false);
    this.#tellThinned();
  }
}
