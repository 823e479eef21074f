// SPDX-License-Identifier: MIT
// The stage: original and result on one canvas under one camera, each in its share of the width.
// Draws only when something changed.
import {
  Box3, DirectionalLight, HemisphereLight, MathUtils, NeutralToneMapping, PerspectiveCamera,
  PMREMGenerator, Scene, Spherical, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { ModelView } from './model_view.js';

/** @typedef {'original' | 'result'} Side */
/** @typedef {'side' | 'wipe'} Compare beside each other, or one over the other */
/** @typedef {import('./model_view.js').Shading} Shading */
/** @typedef {{ x: number, width: number }} Span of the canvas, in CSS pixels */

const clayColors = { original: '#c9c2b8', result: '#a9c9c4' };
const fieldOfView = 32;
const none = { original: null, result: null };

export class Viewer {
  #canvas;
  #renderer;
  #controls;
  #camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
  #scene = new Scene();
  #sky = new HemisphereLight(0xffffff, 0x8c8a86, 1.5);
  #key = new DirectionalLight(0xffffff, 1.9);
  /** @type {import('three').Texture | null} */
  #room = null;
  /** @type {Record<Side, ModelView | null>} */
  #views = { ...none };
  #box = new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));
  #isDrawing = false;
  /** @type {Shading} */
  #shading = 'smooth';
  #wireframe = true;
  /** @type {Compare} */
  #compare = 'side';
  #divider = 0.5;
  #holdsOriginal = false;

  /** Throws where the browser offers no WebGL.
   * @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#canvas = canvas;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.toneMapping = NeutralToneMapping;
    this.#renderer.setScissorTest(true);
    this.#light();
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.#controls.addEventListener('change', () => this.#draw());
    canvas.addEventListener('webglcontextrestored', () => this.#draw());
    canvas.addEventListener('keydown', (event) => this.#onKey(event));
    new ResizeObserver(() => this.#resize()).observe(canvas);
    this.fit();
  }

  /** Lights travel with the eye, so that no side of a model is dark. */
  #light() {
    this.#key.position.set(-0.7, 1, 0.9);
    this.#camera.add(this.#key);
    this.#scene.add(this.#camera, this.#sky);
  }

  /** Shiny materials need a room to mirror; plain clay needs none, and is lit more.
   * @param {boolean} isTextured */
  #lightFor(isTextured) {
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

  #resize() {
    const { clientWidth, clientHeight } = this.#canvas;
    if (!clientWidth || !clientHeight) return;
    this.#renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.#render();  // at once: a resized canvas is blank until drawn
  }

  #draw() {
    if (this.#isDrawing) return;
    this.#isDrawing = true;
    requestAnimationFrame(() => {
      this.#isDrawing = false;
      this.#controls.update();  // tells 'change' while it still glides
      this.#render();
    });
  }

  /** A pane narrower than high sees as wide as it would be high.
   * @param {number} aspect */
  #aim(aspect) {
    const half = Math.tan(MathUtils.degToRad(fieldOfView / 2)) / Math.min(1, aspect);
    this.#camera.fov = MathUtils.radToDeg(2 * Math.atan(half));
    this.#camera.aspect = aspect;
    this.#camera.updateProjectionMatrix();
    return half;
  }

  /** @param {Side} side @param {Span} cut what may be drawn on
   * @param {Span} pane what the camera sees */
  #renderSide(side, cut, pane) {
    const height = this.#canvas.clientHeight;
    if (cut.width < 1) return;
    this.#renderer.setScissor(cut.x, 0, cut.width, height);
    this.#renderer.setViewport(pane.x, 0, pane.width, height);
    const half = this.#aim(pane.width / height);
    const shown = this.#holdsOriginal ? 'original' : side;
    for (const [name, view] of Object.entries(this.#views)) {
      if (view) view.group.visible = name === shown;
    }
    const distance = this.#camera.position.distanceTo(this.#controls.target);
    const view = this.#views[shown];
    view?.setEdgePixels(view.edgeLength * height / (2 * half * distance));
    this.#renderer.render(this.#scene, this.#camera);
  }

  #render() {
    const width = this.#canvas.clientWidth;
    const all = { x: 0, width };
    const isWipe = this.#compare === 'wipe';
    const share = isWipe && !this.#views.result ? 1 : this.#divider;
    const left = { x: 0, width: Math.round(width * share) };
    const right = { x: left.width, width: width - left.width };
    this.#renderSide('original', left, isWipe ? all : left);
    this.#renderSide('result', right, isWipe ? all : right);
  }

  /** How far the eye must be, looking along -direction, to see every corner of the model's box.
   * @param {Vector3} direction of unit length */
  #fittingDistance(direction) {
    const { clientWidth, clientHeight } = this.#canvas;
    const width = clientWidth * (this.#compare === 'side' ? 0.5 : 1);
    const aspect = width && clientHeight ? width / clientHeight : 1;
    const half = this.#aim(aspect) * 0.92;  // a margin
    const right = new Vector3(0, 1, 0).cross(direction).normalize();
    const up = direction.clone().cross(right);
    const center = this.#box.getCenter(new Vector3());
    let distance = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const point = new Vector3(corner & 1 ? this.#box.max.x : this.#box.min.x,
        corner & 2 ? this.#box.max.y : this.#box.min.y,
        corner & 4 ? this.#box.max.z : this.#box.min.z).sub(center);
      const across = Math.abs(point.dot(right)) / (half * aspect);
      const along = Math.abs(point.dot(up)) / half;
      distance = Math.max(distance, Math.max(across, along) + point.dot(direction));
    }
    return distance;
  }

  /** From the side that the model shows: its open one, or the broader one, a little from above. */
  #direction() {
    const { x, z } = this.#box.getSize(new Vector3());
    const [dx, dz] = z > 1.2 * x ? [1, 0.45] : [0.45, 1];
    const direction = new Vector3(dx, 0.28, dz).normalize();
    const front = this.#views.original?.front;
    return front && Math.abs(front.y) < 0.9 ? direction.lerp(front, 0.75).normalize() : direction;
  }

  /** Shows all of the model. */
  fit() {
    const direction = this.#direction();
    const distance = this.#fittingDistance(direction);
    this.#box.getCenter(this.#controls.target);
    this.#camera.position.copy(this.#controls.target).addScaledVector(direction, distance);
    this.#camera.near = distance / 500;
    this.#camera.far = distance * 50;
    this.#controls.minDistance = distance / 100;
    this.#controls.maxDistance = distance * 10;
    this.#controls.update();
    this.#draw();
  }

  /** @param {KeyboardEvent} event */
  #onKey(event) {
    const step = 0.12;
    /** @type {Record<string, [number, number, number]>} turn, tilt, zoom */
    const moves = {
      ArrowLeft: [-step, 0, 1], ArrowRight: [step, 0, 1], ArrowUp: [0, -step, 1],
      ArrowDown: [0, step, 1], '+': [0, 0, 0.9], '=': [0, 0, 0.9], '-': [0, 0, 1 / 0.9],
    };
    const move = moves[event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const offset = this.#camera.position.clone().sub(this.#controls.target);
    const spherical = new Spherical().setFromVector3(offset);
    spherical.theta += move[0];
    spherical.phi += move[1];
    spherical.radius *= move[2];
    offset.setFromSpherical(spherical.makeSafe());
    this.#camera.position.copy(this.#controls.target).add(offset);
    this.#controls.update();
    this.#draw();
  }

  /** Shows a model on its side, or nothing there; the camera moves only for a new original.
   * @param {Side} side @param {import('three').Group | null} group */
  show(side, group) {
    const old = this.#views[side];
    if (old) {
      this.#scene.remove(old.group);
      old.dispose();
    }
    const view = group && new ModelView(group, clayColors[side]);
    this.#views[side] = view;
    if (view) {
      view.setShading(this.#shading);
      view.setWireframe(this.#wireframe);
      this.#scene.add(view.group);
    }
    if (view && side === 'original') {
      this.#box.copy(view.bounds);
      this.#lightFor(view.isTextured);
      this.fit();
    }
    this.#draw();
  }

  /** Whether the original has materials or colours of its own. */
  get isTextured() {
    return Boolean(this.#views.original?.isTextured);
  }

  /** @param {Shading} shading */
  setShading(shading) {
    this.#shading = shading;
    for (const view of Object.values(this.#views)) view?.setShading(shading);
    this.#draw();
  }

  /** @param {boolean} isVisible */
  setWireframe(isVisible) {
    this.#wireframe = isVisible;
    for (const view of Object.values(this.#views)) view?.setWireframe(isVisible);
    this.#draw();
  }

  /** @param {Compare} compare */
  setCompare(compare) {
    this.#compare = compare;
    this.#draw();
  }

  /** @param {number} share of the width that the original gets */
  setDivider(share) {
    this.#divider = share;
    this.#draw();
  }

  /** Shows the original on both sides, for a look at what changed.
   * @param {boolean} holds */
  holdOriginal(holds) {
    this.#holdsOriginal = holds;
    this.#draw();
  }
}
