// SPDX-License-Identifier: MIT
// The stage's picture: two models on one canvas, seen by one eye, each in its share of the width.
// The picture is drawn only after a change.
import {
  DirectionalLight, HemisphereLight, NeutralToneMapping, PMREMGenerator, Scene, Vector3,
  WebGLRenderer,
} from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { clearance } from './clearance.js';
import { Eye } from './eye.js';
import { ModelView } from './model_view.js';
import { Overlays } from './overlays.js';

/** baseline: another result, shown in place of the original.
 * @typedef {'original' | 'baseline' | 'result'} Side */
/** @typedef {'side' | 'wipe'} Compare side by side, or in the same place with a divider */
/** @typedef {import('./model_view.js').Shading} Shading */
/** @typedef {'triangles' | 'quads'} Faces */
/** @typedef {{ x: number, width: number }} Span of the canvas, in CSS pixels */
/** @typedef {{ side: Side, cut: Span, pane: Span }} Pane */
/** @typedef {[number, number, number]} Triple */

const clayColors = { original: '#c9c2b8', baseline: '#c3b8cc', result: '#a9c9c4' };

export class Viewer {
  #canvas;
  #renderer;
  #scene = new Scene();
  #sky = new HemisphereLight(0xffffff, 0x8c8a86, 1.5);
  #key = new DirectionalLight(0xffffff, 1.9);
  /** @type {import('three').Texture | null} */
  #room = null;
  /** @type {Record<Side, ModelView | null>} */
  #views = { original: null, baseline: null, result: null };
  /** The overlays of each side. @type {Record<Side, Overlays>} */
  overlays = { original: new Overlays(), baseline: new Overlays(), result: new Overlays() };
  #isDrawing = false;
  /** @type {Shading} */
  #shading = 'plain';
  #wireframe = true;
  /** @type {Compare} */
  #compare = 'side';
  #divider = 0.5;
  #holdsOriginal = false;

  /** Throws if the browser has no WebGL.
   * @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#canvas = canvas;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.toneMapping = NeutralToneMapping;
    this.#renderer.setScissorTest(true);
    this.#renderer.info.autoReset = false;
    this.#renderer.debug.checkShaderErrors = false;  // the check makes the page wait for the GPU
    this.eye = new Eye(canvas, () => this.draw());
    this.#light();
    canvas.addEventListener('webglcontextrestored', () => this.#restore());
    new ResizeObserver(() => this.#resize()).observe(canvas);
    this.eye.fit();
  }

  /** The key light moves with the eye, so that no side of a model is dark. */
  #light() {
    this.#key.position.set(-0.7, 1, 0.9);
    this.eye.camera.add(this.#key);
    this.#scene.add(this.eye.camera, this.#sky);
    for (const { group } of Object.values(this.overlays)) this.#scene.add(group);
  }

  /** Shiny materials need a room to reflect; plain clay needs none, but more light. */
  #setLights() {
    const isTextured = this.isTextured && this.#shading === 'textured';
    if (isTextured) this.#room ??= this.#makeRoom();
    this.#scene.environment = isTextured ? this.#room : null;
    this.#sky.intensity = isTextured ? 0.3 : 1.5;
    this.#key.intensity = isTextured ? 1.2 : 1.9;
  }

  #makeRoom() {
    const generator = new PMREMGenerator(this.#renderer);
    const { texture } = generator.fromScene(new RoomEnvironment(), 0.04);
    generator.dispose();
    return texture;
  }

  /** The graphics card rendered the room, so it is lost with the WebGL context. */
  #restore() {
    this.#room = null;
    this.#setLights();
    this.draw();
  }

  #resize() {
    const { clientWidth, clientHeight } = this.#canvas;
    if (!clientWidth || !clientHeight) return;
    this.#renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.#shape();
    this.#render();  // at once: a resized canvas is blank until drawn
  }

  /** Tells the eye the shape of a pane. */
  #shape() {
    const { clientWidth, clientHeight } = this.#canvas;
    const width = clientWidth * (this.#compare === 'side' ? 0.5 : 1);
    this.eye.aspect = width && clientHeight ? width / clientHeight : 1;
    Object.assign(this.eye, clearance(clientHeight));
  }

  /** Draws in the next frame; several calls before then draw once. */
  draw() {
    if (this.#isDrawing) return;
    this.#isDrawing = true;
    requestAnimationFrame(() => {
      this.#isDrawing = false;
      this.eye.update();
      this.#render();
    });
  }

  /** @returns {Side} the model on the left */
  get #left() {
    return this.#views.baseline ? 'baseline' : 'original';
  }

  /** The panes, from left to right: the side, the drawn part (cut) and the eye's view (pane).
   * @returns {Pane[]} */
  #panes() {
    const width = this.#canvas.clientWidth;
    const isWipe = this.#compare === 'wipe';
    const share = isWipe && !this.#views.result ? 1 : this.#divider;
    const left = { x: 0, width: Math.round(width * share) };
    const right = { x: left.width, width: width - left.width };
    const all = { x: 0, width };
    return [{ side: this.#left, cut: left, pane: isWipe ? all : left },
      { side: this.#holdsOriginal ? 'original' : 'result', cut: right,
        pane: isWipe ? all : right }];
  }

  /** @param {Pane} where */
  #renderPane({ side, cut, pane }) {
    const height = this.#canvas.clientHeight;
    if (cut.width < 1) return;
    this.#renderer.setScissor(cut.x, 0, cut.width, height);
    this.#renderer.setViewport(pane.x, 0, pane.width, height);
    const half = this.eye.aim(pane.width / height);
    for (const [name, view] of Object.entries(this.#views)) {
      if (view) view.group.visible = name === side;
      this.overlays[/** @type {Side} */ (name)].group.visible = name === side;
    }
    const view = this.#views[side];
    view?.setEdgePixels(view.edgeLength * height / (2 * half * this.eye.distance));
    this.#renderer.render(this.#scene, this.eye.camera);
  }

  #render() {
    this.#renderer.info.reset();
    for (const pane of this.#panes()) this.#renderPane(pane);
    const { calls, triangles } = this.#renderer.info.render;
    Object.assign(this.#canvas.dataset, { calls, triangles });
  }

  /** The ray through a point of the canvas, and the side whose pane has the point.
   * @param {{ x: number, y: number }} at in CSS pixels
   * @returns {{ side: Side, origin: Triple, direction: Triple } | null} */
  rayAt({ x, y }) {
    const found = this.#panes().find(({ cut }) => x >= cut.x && x < cut.x + cut.width);
    if (!found || !this.#views[found.side]) return null;
    const { side, pane } = found;
    const { clientHeight } = this.#canvas;
    this.eye.aim(pane.width / clientHeight);
    const point = new Vector3(2 * (x - pane.x) / pane.width - 1, 1 - 2 * y / clientHeight, 0.5);
    const { camera } = this.eye;
    camera.updateMatrixWorld();
    const direction = point.unproject(camera).sub(camera.position).normalize();
    return { side, origin: camera.position.toArray(), direction: direction.toArray() };
  }

  /** The middle of the left pane, in CSS pixels of the canvas. */
  get middle() {
    const [{ pane }] = this.#panes();
    return { x: pane.x + pane.width / 2, y: this.#canvas.clientHeight / 2 };
  }

  /** A copy of the canvas, `scale` times as large.
   * @param {number} scale */
  picture(scale) {
    const { clientWidth, clientHeight } = this.#canvas;
    const ratio = this.#renderer.getPixelRatio();
    this.#renderer.setPixelRatio(scale);
    this.#render();
    const copy = new OffscreenCanvas(scale * clientWidth, scale * clientHeight);
    copy.getContext('2d')?.drawImage(this.#canvas, 0, 0, copy.width, copy.height);
    this.#renderer.setPixelRatio(ratio);
    this.#render();
    return copy;
  }

  /** Shows a model on its side, null: nothing. The eye moves only for a new original, or
   * for what is shown without one.
   * @param {Side} side @param {import('./model_view.js').Prepared | null} prepared
   * @param {import('./thinning.js').Thinning | null} [thinning] null: all triangles are drawn */
  show(side, prepared, thinning = null) {
    const old = this.#views[side];
    if (old) {
      this.#scene.remove(old.group);
      old.dispose();
      this.overlays[side].clear();
    }
    const view = prepared && new ModelView(prepared, clayColors[side], thinning);
    this.#views[side] = view;
    if (view) {
      view.setShading(this.#shading);
      view.setWireframe(this.#wireframe);
      this.#scene.add(view.group);
    }
    if (view && (side === 'original' || !this.#views.original)) {
      this.#shape();
      this.eye.setSubject(view.bounds, view.front);
    }
    this.#setLights();
    this.draw();
  }

  /** @param {Side} side */
  view(side) {
    return this.#views[side];
  }

  /** The kinds of faces shown: triangles, quads, or both. @returns {Faces[]} */
  get faces() {
    const shown = [this.#views[this.#left], this.#views.result].filter((view) => view !== null);
    return [...new Set(shown.map((view) => (view.hasQuads ? 'quads' : 'triangles')))];
  }

  /** Whether the original has materials or colours of its own. */
  get isTextured() {
    return Boolean(this.#views.original?.isTextured);
  }

  /** @param {Shading} shading */
  setShading(shading) {
    this.#shading = shading;
    for (const view of Object.values(this.#views)) view?.setShading(shading);
    this.#setLights();
    this.draw();
  }

  /** @param {boolean} isVisible */
  setWireframe(isVisible) {
    this.#wireframe = isVisible;
    for (const view of Object.values(this.#views)) view?.setWireframe(isVisible);
    for (const overlays of Object.values(this.overlays)) overlays.showDots(isVisible);
    this.draw();
  }

  /** @param {import('three').Plane | null} plane nothing is drawn behind it; null: no cut */
  setCut(plane) {
    this.#renderer.clippingPlanes = plane ? [plane] : [];
    this.draw();
  }

  get isCut() {
    return this.#renderer.clippingPlanes.length > 0;
  }

  /** @param {Compare} compare */
  setCompare(compare) {
    this.#compare = compare;
    this.#shape();
    this.draw();
  }

  /** @param {number} share of the width for the left side */
  setDivider(share) {
    this.#divider = share;
    this.draw();
  }

  /** Shows the original on the right, too, to compare it with the result.
   * @param {boolean} holds */
  holdOriginal(holds) {
    this.#holdsOriginal = holds;
    this.draw();
  }
}
