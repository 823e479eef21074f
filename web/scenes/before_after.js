// SPDX-License-Identifier: MIT
// A model before and after a job, beside each other, turned together. What changes is made again,
// and figures below say what came of it.
import { Solid } from './solid.js';
import { Stage } from './stage.js';

/** @typedef {import('./stage.js').Point} Point */
/** @typedef {import('./solid.js').Polygons} Polygons */
/** polygons: the result; words: figures of it.
 * @typedef {{ polygons: Polygons, words: string }} Made */
/** @typedef {{ name: string, min: number, max: number, step: number, value: number }} Slider */

/** Calls back once the element is about to be seen. @param {Element} seen
 * @param {() => void} begin */
function whenSeen(seen, begin) {
  const watch = new IntersectionObserver((entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    watch.disconnect();
    begin();
  }, { rootMargin: '200px' });
  watch.observe(seen);
}

/**
 * @param {HTMLElement} figure
 * @param {{ before: Polygons, sliders: Slider[], make: (values: number[]) => Promise<Made>,
 *   tilt?: number, isOpen?: boolean }} job tilt: at first; isOpen: the model has holes before
 */
export function beforeAfter(figure, { before, sliders, make, tilt = -0.9, isOpen = false }) {
  const left = Object.assign(new Solid(before), { tilt }), words = document.createElement('output');
  /** @type {Solid | undefined} */
  let right;
  /** @type {Point | undefined} */
  let last;
  const stage = new Stage(figure, 2, ({ context, canvas }) => {
    context.clearRect(0, 0, canvas.width, canvas.height);
    left.drawLit(stage.view(0, 2, 1.35), isOpen);
    right?.drawLit(stage.view(1, 2, 1.35), false);
  });
  let isBusy = false, isWaiting = false;
  const values = sliders.map(({ value }) => value);
  const remake = async () => {
    isWaiting = isBusy;
    if (isBusy) return;
    isBusy = true;
    const made = await make(values);
    right = Object.assign(new Solid(made.polygons), { tilt: left.tilt, turn: left.turn });
    words.value = made.words;
    stage.redraw();
    isBusy = false;
    if (isWaiting) void remake();
  };
  words.value = '…';
  words.style.display = 'block';
  stage.canvas.after(words);
  for (const [i, { name, ...range }] of [...sliders.entries()].reverse()) {
    stage.slider(name, range, (value) => {
      values[i] = value;
      void remake();
    });
  }
  stage.follow((at, isDown, began) => {
    if (isDown && last && !began) {
      for (const solid of [left, right]) {
        solid?.drag([at[0] - last[0], at[1] - last[1]], stage.canvas.width / 2);
      }
    }
    last = at;
  });
  whenSeen(figure, () => void remake());
}
