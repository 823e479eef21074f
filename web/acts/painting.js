// SPDX-License-Identifier: MIT
// The visitor paints density on the original with a brush. Later runs use the density, and the
// browser keeps it for the same model.
import { addCommand } from '../base/commands.js';
import { densityColors } from '../base/colors.js';
import { Setting } from '../base/memory.js';
import {
  applyDab, areDabs, densityOf, largestLevel, levelsOf, mirrored,
} from '../model/density.js';
import { currentBrush, hideBrush, showBrush } from '../panel/brush.js';
import { ramp } from '../view/ramp.js';
import { keyOf } from '../model/units.js';

/** @typedef {import('../model/density.js').Dab} Dab */
/** @typedef {import('./pen.js').Desk & { pen: import('./pen.js').Pen }} Desk */

const densityColor = ramp(densityColors);

/** The dabs, and the model that they are on. */
const paint = new Setting('paint', (text) => {
  const { key, dabs } = JSON.parse(text);
  return typeof key === 'string' && areDabs(dabs) ? { key, dabs } : undefined;
});

export class Painting {
  #page;
  #onStroke;
  /** @type {Dab[]} */
  #dabs = [];
  /** Vertex positions of the original on the stage, null until needed.
   * @type {Float32Array | null} */
  #shownAt = null;
  #levels = new Float32Array();
  /** Vertex positions in the core's order, null until needed. @type {Float32Array | null} */
  #countedAt = null;
  /** Whether the stroke has put a dab. */
  #isChanged = false;
  /** @type {import('./pen.js').Tool} */
  #tool = { button: 'paint',
    put: (point) => this.#dab(point),
    end: () => this.#endStroke(),
    drop: () => this.#drop() };

  /** @param {Desk} page @param {() => void} onStroke called after each stroke */
  constructor(page, onStroke) {
    this.#page = page;
    this.#onStroke = onStroke;
    addCommand('paint', () => this.#toggle(), 'p');
  }

  get dabs() {
    return this.#dabs;
  }

  /** Identifies the model whose dabs are remembered. */
  get #key() {
    const { model } = this.#page.session;
    return model && keyOf(model);
  }

  /** A new original is on the stage: dabs painted on it before are restored. */
  begin() {
    this.#shownAt = null;
    this.#countedAt = null;
    this.#page.pen.take(null);
    const kept = paint.recall();
    this.set(kept?.key === this.#key ? kept?.dabs ?? [] : []);
  }

  /** @param {Dab[]} dabs replace all present dabs */
  set(dabs) {
    this.#dabs = [...dabs];
    if (dabs.length) paint.remember(JSON.stringify({ key: this.#key, dabs }));
    else if (this.#key) paint.remember(null);
    void this.#measure();
  }

  /** Finds the levels of what is on the stage, if anything is painted or about to be. */
  async #measure() {
    const { stage } = this.#page;
    const view = stage.viewer?.view('original');
    if (!view || (!this.#dabs.length && stage.shading !== 'density')) return;
    const places = this.#shownAt ?? (await view.soup()).positions;
    if (view !== stage.viewer?.view('original')) return;
    this.#shownAt = places;
    this.#levels = levelsOf(places, this.#dabs);
    this.#showLevels();
  }

  #showLevels() {
    const { stage } = this.#page;
    stage.viewer?.view('original')?.setColors('density', (vertex, color) =>
      densityColor(0.5 + this.#levels[vertex] / (2 * largestLevel), color));
    stage.setShading(stage.shading);
  }

  #toggle() {
    const { pen, stage } = this.#page;
    if (pen.isHeld(this.#tool)) {
      pen.take(null);
      return;
    }
    pen.take(this.#tool);
    showBrush({ onClear: () => this.#clear(), onDone: () => pen.take(null) });
    stage.setShading('density');
    void this.#measure();
    stage.bringIntoView();
  }

  #drop() {
    const { stage } = this.#page;
    hideBrush();
    stage.setShading(stage.viewer?.isTextured ? 'textured' : 'plain');
  }

  #clear() {
    this.set([]);
    this.#onStroke();
  }

  /** @param {Dab['point']} point */
  #dab(point) {
    const { mode, size, strength, isMirrored } = currentBrush();
    const signs = { dense: 1, sparse: -1, erase: 0 };
    const { diagonal, middle } = this.#page.surveying;
    const dab = { point, radius: size * diagonal, strength: signs[mode] * strength };
    for (const one of isMirrored ? [dab, mirrored(dab, middle)] : [dab]) {
      this.#dabs.push(one);
      if (this.#shownAt) applyDab(this.#levels, this.#shownAt, one);
    }
    this.#isChanged = true;
    if (this.#shownAt) this.#showLevels();
  }

  #endStroke() {
    if (!this.#isChanged) return;
    this.#isChanged = false;
    this.set(this.#dabs);
    this.#onStroke();
  }

  /** The run's option `density`; empty if nothing is painted.
   * @returns {Promise<{ density?: Float32Array }>} */
  async option() {
    if (!this.#dabs.length) return {};
    if (!this.#countedAt) {
      const { session, stage, surveying } = this.#page;
      const { bytes } = await session.converted('off');
      const origin = stage.origin.toArray();
      this.#countedAt = await surveying.survey.ask('offVertices', { bytes, origin });
    }
    return { density: densityOf(levelsOf(this.#countedAt, this.#dabs)) };
  }
}
