// SPDX-License-Identifier: MIT
// The whole run: the number of vertices and how far sizes follow curvature, live.
import { Solid } from './solid.js';
import { Stage } from './stage.js';

/** @typedef {import('./stage.js').Point} Point */

/** @param {HTMLElement} figure */
export async function remeshedScene(figure) {
  const asked = { vertices: 600, adaptivity: 0.5 };
  let solid = await Solid.made(asked);
  /** @type {Point | undefined} */
  let last;
  const stage = new Stage(figure, 2, ({ context, canvas }) => {
    context.clearRect(0, 0, canvas.width, canvas.height);
    solid.draw(stage.view(0, 1, 1.25));
  });
  let isBusy = false, isWaiting = false;
  const remake = async () => {
    isWaiting = isBusy;
    if (isBusy) return;
    isBusy = true;
    const { tilt, turn } = solid;
    solid = Object.assign(await Solid.made({ ...asked, quality: 'draft' }), { tilt, turn });
    stage.redraw();
    isBusy = false;
    if (isWaiting) remake();
  };
  stage.slider('Adaptivity', { min: 0, max: 1, step: 0.1, value: asked.adaptivity }, (value) => {
    asked.adaptivity = value;
    remake();
  });
  stage.slider('Vertices', { min: 100, max: 3000, step: 50, value: asked.vertices }, (value) => {
    asked.vertices = value;
    remake();
  });
  stage.follow((at, isDown, began) => {
    if (isDown && last && !began)
      solid.drag([at[0] - last[0], at[1] - last[1]], stage.canvas.width / 2);
    last = at;
  });
}
