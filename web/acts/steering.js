// SPDX-License-Identifier: MIT
// Trying: while a slider moves, drafts follow; when it rests, the best result. Undo and redo over
// what was asked for.
import { addCommand } from '../base/commands.js';
import { byId } from '../base/dom.js';
import { Timeline } from '../model/timeline.js';
import { remesh } from './running.js';

/** @typedef {import('./page.js').Page} Page */
/** What is undone and done again.
 * @typedef {{ values: import('../model/address.js').Values,
 *   dabs: import('../model/density.js').Dab[] }} State */

/** Milliseconds without a change after which a slider is at rest. */
const rest = 400;
/** A draft keeps the textures: painting them takes longer than a draft may. */
const draft = /** @type {const} */ ({ quality: 'draft', textures: 'keep' });
/** Models with more vertices take too long to follow. */
const largestLive = 60_000;

export class Steering {
  /** @type {Timeline<State>} */
  #timeline = new Timeline();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  #isDrafting = false;
  #isStale = false;
  /** @type {Page | null} */
  #page = null;

  /** @param {Page} page */
  wire(page) {
    this.#page = page;
    addCommand('undo', () => this.#go(-1), 'Control+z');
    addCommand('redo', () => this.#go(1), 'Control+Shift+z');
    this.#showSteps();
  }

  /** @returns {State} */
  get #state() {
    const { panel, painting } = /** @type {Page} */ (this.#page);
    return { values: panel.values(), dabs: painting.dabs };
  }

  get #isLive() {
    const { session, panel } = /** @type {Page} */ (this.#page);
    return panel.isLive && (session.inspection?.input.vertices ?? Infinity) <= largestLive;
  }

  /** A model came in: what the form says now is where undoing ends. */
  begin() {
    if (!this.#page) return;
    clearTimeout(this.#timer);
    this.#timeline.begin(this.#state);
    this.#showSteps();
  }

  /** What the last moves asked for is no longer wanted: something else is, or nothing. */
  stop() {
    clearTimeout(this.#timer);
    this.#isStale = false;
  }

  /** A value moves. */
  move() {
    if (!this.#page || !this.#isLive) return;
    this.#isStale = true;
    if (!this.#isDrafting) void this.#draft(this.#page);
    this.#restSoon(this.#page);
  }

  /** A value has been chosen. */
  settle() {
    if (!this.#page) return;
    this.#timeline.add(this.#state);
    this.#showSteps();
  }

  /** A stroke of the brush is done. */
  stroke() {
    this.settle();
    this.move();
  }

  /** One draft after the other, the latest values always last: none waits in line.
   * @param {Page} page */
  async #draft(page) {
    this.#isDrafting = true;
    while (this.#isStale) {
      this.#isStale = false;
      await page.busy(() => remesh(page, draft), 'drafting');
    }
    this.#isDrafting = false;
  }

  /** @param {Page} page */
  #restSoon(page) {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      if (this.#isDrafting) this.#restSoon(page);
      else void page.busy(() => remesh(page));
    }, rest);
  }

  /** @param {1 | -1} step */
  #go(step) {
    const state = this.#timeline.go(step);
    this.#showSteps();
    if (!state || !this.#page) return;
    const page = this.#page;
    this.stop();
    page.panel.setValues(state.values);
    page.painting.set(state.dabs);
    if (this.#isLive) void page.busy(() => remesh(page));
  }

  #showSteps() {
    byId('undo', HTMLButtonElement).disabled = !this.#timeline.can(-1);
    byId('redo', HTMLButtonElement).disabled = !this.#timeline.can(1);
  }
}
