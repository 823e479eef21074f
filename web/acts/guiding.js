// SPDX-License-Identifier: MIT
// The visitor draws lines on the model that quads follow. Later runs use them, and the browser
// keeps them for the same model.
import { addCommand } from '../base/commands.js';
import { t } from '../base/i18n.js';
import { Setting } from '../base/memory.js';
import {
  areStrokes, guidesOf, isRound, lengthOf, mirrored, segmentsOf, thinned, without,
} from '../model/guides.js';
import { showNews } from '../panel/messages.js';
import { currentPencil, hidePencil, showOpenLine, showPencil } from '../panel/pencil.js';
import { keyOf } from '../model/units.js';

/** @typedef {import('../model/guides.js').Stroke} Stroke */
/** @typedef {import('../model/guides.js').Point} Point */
/** @typedef {import('./pen.js').Desk & { pen: import('./pen.js').Pen }} Desk */

/** The strokes, and the model that they are on. */
const kept = new Setting('guides', (text) => {
  const { key, strokes } = JSON.parse(text);
  return typeof key === 'string' && areStrokes(strokes) ? { key, strokes } : undefined;
});

/** Shares of the diagonal: a stroke's points are at least so far apart; a shorter stroke was a
 * click; a line nearer to the rubber goes. */
const least = { step: 0.005, length: 0.02, reach: 0.015 };

const sides = /** @type {const} */ (['original', 'baseline', 'result']);

export class Guiding {
  #page;
  #onStroke;
  /** @type {Stroke[]} */
  #strokes = [];
  /** The line that is being drawn. @type {Point[]} */
  #line = [];
  /** Whether the line's points come from the keyboard, one by one. */
  #isOpen = false;
  #isErased = false;
  /** @type {import('./pen.js').Tool} */
  #tool = { button: 'guides',
    put: (point, isFirst) => this.#put(point, isFirst),
    end: (how) => this.#end(how),
    drop: () => this.#drop() };

  /** @param {Desk} page @param {() => void} onStroke called after each stroke */
  constructor(page, onStroke) {
    this.#page = page;
    this.#onStroke = onStroke;
    addCommand('guide', () => this.#toggle(), 'g');
  }

  get strokes() {
    return this.#strokes;
  }

  /** Identifies the model whose strokes are remembered. */
  get #key() {
    const { model } = this.#page.session;
    return model && keyOf(model);
  }

  get #isForQuads() {
    return Boolean(this.#page.panel.values().quads);
  }

  #toggle() {
    const { pen } = this.#page;
    if (pen.isHeld(this.#tool)) {
      pen.take(null);
      return;
    }
    if (!this.#isForQuads || !this.#page.stage.viewer) return;
    pen.take(this.#tool);
    showPencil({ onFinish: () => void this.#finish(), onClear: () => this.#clear(),
      onDone: () => pen.take(null) });
    this.#page.stage.bringIntoView();
  }

  #drop() {
    hidePencil();
    this.#line = [];
    this.#isOpen = false;
    this.show();
  }

  /** A new original is on the stage: strokes drawn on it before are restored. */
  begin() {
    this.#page.pen.take(null);
    const before = kept.recall();
    this.set(before?.key === this.#key ? before?.strokes ?? [] : []);
  }

  /** @param {Stroke[]} strokes replace all present ones */
  set(strokes) {
    this.#strokes = strokes;
    if (strokes.length) kept.remember(JSON.stringify({ key: this.#key, strokes }));
    else if (this.#key) kept.remember(null);
    this.#page.panel.setGuides(strokes.length);
    this.show();
  }

  /** Draws the lines over both pictures, while there are quads that follow them. */
  show() {
    const { viewer } = this.#page.stage;
    if (!this.#isForQuads && this.#page.pen.isHeld(this.#tool)) this.#page.pen.take(null);
    const strokes = this.#isForQuads ? this.#strokes : [];
    const line = segmentsOf([{ kind: 'direction', points: this.#line }], 'direction');
    for (const side of sides) {
      viewer?.overlays[side].setLines('direction', segmentsOf(strokes, 'direction'));
      viewer?.overlays[side].setLines('loop', segmentsOf(strokes, 'loop'));
      viewer?.overlays[side].setLines('drawn', line);
    }
    viewer?.draw();
  }

  #clear() {
    this.set([]);
    this.#onStroke();
  }

  /** @param {Point} point @param {boolean} isFirst */
  #put(point, isFirst) {
    const { diagonal } = this.#page.surveying;
    if (currentPencil().mode === 'erase') {
      const left = without(this.#strokes, point, least.reach * diagonal);
      this.#isErased ||= left.length < this.#strokes.length;
      this.#strokes = left;
    } else {
      if (isFirst && !this.#isOpen) this.#line = [];
      this.#line.push(point);
    }
    this.show();
  }

  /** @param {{ isWhole: boolean, isKeyed: boolean }} how */
  #end({ isWhole, isKeyed }) {
    if (this.#isErased) {
      this.#isErased = false;
      this.set(this.#strokes);
      this.#onStroke();
      return;
    }
    if (isKeyed && currentPencil().mode !== 'erase') {
      this.#isOpen = true;
      showOpenLine(this.#line.length > 1);
    } else if (isWhole) void this.#finish();
    else {
      this.#line = [];
      this.show();
    }
  }

  /** Makes a guide of the line. */
  async #finish() {
    const { surveying: { diagonal, middle } } = this.#page;
    const points = thinned(this.#line, least.step * diagonal);
    this.#line = [];
    this.#isOpen = false;
    showOpenLine(false);
    if (points.length < 2 || lengthOf(points) < least.length * diagonal) {
      if (points.length) showNews(t('pencil.short'));
      this.show();
      return;
    }
    const { mode, isMirrored } = currentPencil();
    const stroke = mode === 'loop' ? await this.#loopOf(points)
      : /** @type {Stroke} */ ({ kind: 'direction', points });
    const other = mirrored(stroke, middle);
    const isOther = other.points.some((point) =>
      without([stroke], point, least.reach * diagonal).length > 0);
    this.set([...this.#strokes, stroke, ...(isMirrored && isOther ? [other] : [])]);
    this.#onStroke();
  }

  /** A line that closes is a loop as it was drawn. Another one lies across what is seen: its loop
   * is the ring that the plane through the line and the eye cuts out of the surface.
   * @param {Point[]} points @returns {Promise<Stroke>} */
  async #loopOf(points) {
    if (isRound(points)) return { kind: 'loop', points };
    const { surveying: { survey, diagonal }, stage } = this.#page;
    const [from, to] = [points[0], points[points.length - 1]];
    const [x, y, z] = to.map((value, k) => value - from[k]);
    const [u, v, w] = stage.viewer?.eye.direction ?? [0, 0, 1];
    /** @type {Point} */
    const normal = [y * w - z * v, z * u - x * w, x * v - y * u];
    const through = points[Math.floor(points.length / 2)];
    const ring = await survey.ask('ring', { through, normal });
    if (ring) return { kind: 'loop', points: thinned(ring, least.step * diagonal) };
    showNews(t('pencil.noRing'));
    return { kind: 'direction', points };
  }

  /** The run's option `guides`; empty if there are none, or no quads.
   * @returns {{ guides?: import('remesher').Guide[] }} */
  option() {
    if (!this.#strokes.length || !this.#isForQuads) return {};
    return { guides: guidesOf(this.#strokes, this.#page.stage.origin.toArray()) };
  }
}
