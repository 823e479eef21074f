// SPDX-License-Identifier: MIT
// Strokes on the original: a stroke is the places of its surface under the pointer, in order. The
// brush for density and the pencil for guides both draw with this pen, one at a time. The left
// and the right picture show the same places, so both can be drawn on.
import { byId } from '../base/dom.js';

/** @typedef {{ x: number, y: number }} Spot of the canvas, in CSS pixels */
/** @typedef {import('../survey/surface.js').Point} Point */
/** @typedef {import('./surveying.js').Desk & { surveying: import('./surveying.js').Surveying
 *   }} Desk */

/**
 * button: the id of the button that is pressed while the tool is in hand; put: the next place of
 * a stroke, isFirst: of a new one; end: the stroke has ended, isWhole: as it was meant, isKeyed: by
 * the keyboard, which gives one place at a time; drop: another tool is taken, or none.
 * @typedef {{ button: string, put: (point: Point, isFirst: boolean) => void,
 *   end: (how: { isWhole: boolean, isKeyed: boolean }) => void, drop: () => void }} Tool */

/** Pixels between the places of a stroke. */
const step = 8;

/** The spots from one to another, without the first. @param {Spot} from @param {Spot} to */
function spotsBetween(from, to) {
  const count = Math.floor(Math.hypot(to.x - from.x, to.y - from.y) / step);
  const at = (/** @type {number} */ share) =>
    ({ x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share });
  return Array.from({ length: count }, (_, i) => at((i + 1) / count));
}

export class Pen {
  #page;
  /** @type {Tool | null} */
  #tool = null;
  /** The last spot of the stroke that is being drawn. @type {Spot | null} */
  #last = null;
  /** Whether the next place is the first of a stroke. */
  #isFirst = true;
  /** The open tasks, in order. */
  #work = Promise.resolve();

  /** @param {Desk} page */
  constructor(page) {
    this.#page = page;
    const canvas = byId('canvas', HTMLCanvasElement);
    const at = (/** @type {PointerEvent} */ event) => ({ x: event.offsetX, y: event.offsetY });
    canvas.addEventListener('pointerdown', (event) => {
      if (this.#last) this.#end(false);  // a second finger: it turns the model
      else if (event.button === 0) this.#begin(at(event));
    });
    canvas.addEventListener('pointermove', (event) => {
      if (event.buttons & 1) this.#to(at(event));
    });
    canvas.addEventListener('pointerup', () => this.#end(true));
    canvas.addEventListener('pointercancel', () => this.#end(false));
    canvas.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.#press();
    });
  }

  /** @param {Tool} tool */
  isHeld(tool) {
    return this.#tool === tool;
  }

  /** Takes a tool in hand, null: none, and puts down the one before.
   * @param {Tool | null} tool */
  take(tool) {
    if (tool === this.#tool) return;
    const before = this.#tool;
    this.#tool = tool;
    this.#last = null;
    this.#page.stage.setBrushing(Boolean(tool));
    for (const one of [before, tool]) {
      if (one) document.getElementById(one.button)?.setAttribute('aria-pressed',
        String(one === tool));
    }
    before?.drop();
  }

  /** @param {Spot} spot */
  #begin(spot) {
    if (!this.#tool) return;
    this.#last = spot;
    this.#work = this.#work.then(() => { this.#isFirst = true; });
    this.#find(spot);
  }

  /** @param {Spot} spot */
  #to(spot) {
    if (!this.#last) return;
    const spots = spotsBetween(this.#last, spot);
    if (!spots.length) return;
    this.#last = spot;
    for (const one of spots) this.#find(one);
  }

  /** @param {boolean} isWhole */
  #end(isWhole) {
    if (!this.#last) return;
    this.#last = null;
    this.#finish({ isWhole, isKeyed: false });
  }

  /** @param {{ isWhole: boolean, isKeyed: boolean }} how */
  #finish(how) {
    const tool = this.#tool;
    this.#work = this.#work.then(() => { if (this.#tool === tool) tool?.end(how); });
  }

  /** A place in the middle of the picture, for those without a pointer. */
  #press() {
    const { viewer } = this.#page.stage;
    if (!this.#tool || !viewer) return;
    this.#work = this.#work.then(() => { this.#isFirst = true; });
    this.#find(viewer.middle);
    this.#finish({ isWhole: true, isKeyed: true });
  }

  /** Finds the place at a spot, where the surface is. @param {Spot} spot */
  #find(spot) {
    const { stage, surveying } = this.#page;
    const tool = this.#tool;
    const ray = stage.viewer?.rayAt(spot);
    this.#work = this.#work.then(async () => {
      const pick = ray ? await surveying.survey.ask('pick', { ...ray, side: 'original' }) : null;
      if (!pick || !tool || this.#tool !== tool) return;
      tool.put(pick.point, this.#isFirst);
      this.#isFirst = false;
    });
  }
}
