// SPDX-License-Identifier: MIT
// A figure that one can touch: a canvas as sharp as the screen, and what scenes draw on it.

/** @typedef {[number, number]} Point in the figure's own units, x to the right, y up */

const colors = {
  line: '#5b6b7c', face: '#dfe8f2', chosen: '#f2b134', point: '#c2452d', other: '#2f6f9f',
};

export class Stage {
  #frame = 0;

  /** @param {HTMLElement} figure which gets the canvas @param {number} wide of it over its height
   * @param {(stage: Stage) => void} draw */
  constructor(figure, wide, draw) {
    this.figure = figure;
    this.draw = draw;
    this.canvas = document.createElement('canvas');
    this.canvas.style.cssText = `width: 100%; aspect-ratio: ${wide}; touch-action: pan-y`;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', figure.querySelector('figcaption')?.textContent ?? '');
    figure.prepend(this.canvas);
    this.context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d'));
    new ResizeObserver(() => this.redraw()).observe(this.canvas);
  }

  redraw() {
    cancelAnimationFrame(this.#frame);
    this.#frame = requestAnimationFrame(() => {
      const { clientWidth, clientHeight } = this.canvas;
      if (!clientWidth) return;
      this.canvas.width = clientWidth * devicePixelRatio;
      this.canvas.height = clientHeight * devicePixelRatio;
      this.draw(this);
    });
  }

  /** The view into a square of the canvas: of `count` beside each other the one at `index`.
   * @param {number} index @param {number} count @param {number} reach from its middle to a side */
  view(index, count, reach) {
    const { width, height } = this.canvas;
    const scale = Math.min(width / count, height) / 2 / reach;
    return new View(this.context, [(index + 0.5) * width / count, height / 2], scale);
  }

  /** Calls `move` with points of the pixels, while a button or a finger is down, or always.
   * @param {(at: Point, isDown: boolean, began: boolean) => void} move in pixels of the canvas */
  follow(move) {
    const at = (/** @type {PointerEvent} */ event) => {
      const box = this.canvas.getBoundingClientRect();
      const ratio = this.canvas.width / box.width;
      return /** @type {Point} */ ([(event.clientX - box.left) * ratio,
        (event.clientY - box.top) * ratio]);
    };
    this.canvas.addEventListener('pointerdown', (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      move(at(event), true, true);
      this.redraw();
    });
    this.canvas.addEventListener('pointermove', (event) => {
      move(at(event), event.buttons > 0, false);
      this.redraw();
    });
  }

  /** A slider below the canvas. @param {string} words @param {{ min: number, max: number,
   *   step: number, value: number }} range @param {(value: number) => void} changed */
  slider(words, range, changed) {
    const label = document.createElement('label'), input = document.createElement('input');
    const value = document.createElement('output');
    Object.assign(input, { type: 'range', ...range, value: String(range.value) });
    const show = () => { value.textContent = input.value; };
    input.addEventListener('input', () => { show(); changed(Number(input.value)); });
    label.append(`${words} `, input, ' ', value);
    label.style.display = 'block';
    this.canvas.after(label);
    show();
  }
}

class View {
  /** @param {CanvasRenderingContext2D} context @param {Point} middle in pixels
   * @param {number} scale pixels for each unit */
  constructor(context, middle, scale) {
    this.context = context;
    this.middle = middle;
    this.scale = scale;
  }

  /** @param {Point} p @returns {Point} in pixels */
  pixels([x, y]) { return [this.middle[0] + this.scale * x, this.middle[1] - this.scale * y]; }

  /** @param {Point} pixels @returns {Point} */
  point([x, y]) { return [(x - this.middle[0]) / this.scale, (this.middle[1] - y) / this.scale]; }

  /** @param {Point[]} points @param {string} fill @param {string} [line] one of our colours, or
   *   another */
  polygon(points, fill, line = 'line') {
    const { context } = this;
    context.beginPath();
    for (const p of points) context.lineTo(...this.pixels(p));
    context.closePath();
    const colorOf = (/** @type {string} */ name) =>
      colors[/** @type {keyof typeof colors} */ (name)] ?? name;
    context.fillStyle = colorOf(fill);
    context.fill();
    context.lineWidth = devicePixelRatio;
    context.strokeStyle = colorOf(line);
    context.stroke();
  }

  /** @param {Point} middle @param {number} radius @param {keyof typeof colors} line */
  circle(middle, radius, line) {
    const { context } = this;
    context.beginPath();
    context.arc(...this.pixels(middle), this.scale * radius, 0, 2 * Math.PI);
    context.lineWidth = devicePixelRatio;
    context.strokeStyle = colors[line];
    context.stroke();
  }

  /** @param {Point} at @param {keyof typeof colors} color */
  dot(at, color) {
    const { context } = this;
    context.beginPath();
    context.arc(...this.pixels(at), 5 * devicePixelRatio, 0, 2 * Math.PI);
    context.fillStyle = colors[color];
    context.fill();
  }
}
