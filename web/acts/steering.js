// SPDX-License-Identifier: MIT
// Live results: drafts while a slider moves, a full run when the slider rests. Undo and redo of
// options and painted density.
import { addCommand } from '../base/commands.js';
import { byId } from '../base/dom.js';
import { isRepairOnly } from '../model/purposes.js';
import { Timeline } from '../model/timeline.js';
import { remesh } from './running.js';

/** @typedef {import('./page.js').Page} Page */
/** The state that undo and redo restore.
 * @typedef {{ values: import('../model/address.js').Values,
 *   dabs: import('../model/density.js').Dab[],
 *   strokes: import('../model/guides.js').Stroke[] }} State */

/** Milliseconds without a change after which a slider is at rest. */
const rest = 400;
/** A draft keeps the textures, because painting new ones takes too long for a draft. */
const draft = /** @type {const} */ ({ quality: 'draft', textures: 'keep' });
/** Models with more vertices are too slow for live results. */
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
    const { panel, painting, guiding } = /** @type {Page} */ (this.#page);
    return { values: panel.values(), dabs: painting.dabs, strokes: guiding.strokes };
  }

  get #isLive() {
    const { session, panel } = /** @type {Page} */ (this.#page);
    return panel.isLive && (session.inspection?.input.vertices ?? Infinity) <= largestLive;
  }

  /** A model was opened: undo goes back to the form's present values, and no further. */
  begin() {
    if (!this.#page) return;
    clearTimeout(this.#timer);
    this.#timeline.begin(this.#state);
    this.#showSteps();
  }

  /** Drops the drafts and the run that the last moves asked for and that have not begun. */
  stop() {
    clearTimeout(this.#timer);
    this.#isStale = false;
  }

  /** A value is changing. */
  move() {
    if (!this.#page || !this.#isLive) return;
    this.#isStale = !isRepairOnly(this.#page.panel.values());  // a repair has no draft
    if (this.#isStale && !this.#isDrafting) void this.#draft(this.#page);
    this.#restSoon(this.#page);
  }

  /** A value has been chosen. */
  settle() {
    if (!this.#page) return;
    this.#timeline.add(this.#state);
    this.#showSteps();
  }

  /** A stroke of the brush or the pencil has ended. */
  stroke() {
    this.settle();
    this.move();
  }

  /** Runs one draft after another, each with the latest values; drafts never queue.
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
    page.guiding.set(state.strokes);
    if (this.#isLive) void page.busy(() => remesh(page));
  }

  #showSteps() {
    byId('undo', HTMLButtonElement).disabled = !this.#timeline.can(-1);
    byId('redo', HTMLButtonElement).disabled = !this.#timeline.can(1);
  }
}
