// SPDX-License-Identifier: MIT
// The eye: one camera for all panes, how it is turned, and what it is pointed at.
import {
  Box3, MathUtils, MOUSE, PerspectiveCamera, Spherical, TOUCH, Vector3,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** @typedef {[number, number, number]} Triple */

const fieldOfView = 32;
/** Milliseconds of a flight to a place. */
const flight = 350;

const isStill = () => matchMedia('(prefers-reduced-motion: reduce)').matches;

export class Eye {
  camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
  #controls;
  #box = new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));
  /** @type {Vector3 | null} */
  #front = null;
  #onMove;
  /** The width of a pane as a share of its height. */
  aspect = 1;

  /** @param {HTMLCanvasElement} canvas @param {() => void} onMove */
  constructor(canvas, onMove) {
    this.#onMove = onMove;
    this.#controls = new OrbitControls(this.camera, canvas);
    this.#controls.enableDamping = !isStill();
    this.#controls.addEventListener('change', onMove);
    canvas.addEventListener('keydown', (event) => this.#onKey(event));
  }

  /** Lets the turning glide on; tells onMove while it does. */
  update() {
    this.#controls.update();
  }

  /** Whether dragging turns the model; else the other button does, or two fingers.
   * @param {boolean} isOn */
  setTurning(isOn) {
    this.#controls.mouseButtons.RIGHT = isOn ? MOUSE.PAN : MOUSE.ROTATE;
    this.#controls.mouseButtons.LEFT = isOn ? MOUSE.ROTATE : null;
    this.#controls.touches.ONE = isOn ? TOUCH.ROTATE : null;
  }

  /** How far away what it looks at is. */
  get distance() {
    return this.camera.position.distanceTo(this.#controls.target);
  }

  /** The model's size. */
  get diagonal() {
    return this.#box.getSize(new Vector3()).length();
  }

  /** Around the model. */
  get box() {
    return this.#box;
  }

  /** The model's middle. */
  get center() {
    return this.#box.getCenter(new Vector3());
  }

  /** What to look at, from its open side if it has one.
   * @param {Box3} box @param {Vector3 | null} front */
  setSubject(box, front) {
    this.#box.copy(box);
    this.#front = front;
    this.fit();
  }

  /** A pane narrower than high sees as wide as it would be high.
   * @param {number} aspect @returns {number} half of what it sees, at distance 1 */
  aim(aspect) {
    const half = Math.tan(MathUtils.degToRad(fieldOfView / 2)) / Math.min(1, aspect);
    this.camera.fov = MathUtils.radToDeg(2 * Math.atan(half));
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    return half;
  }

  /** How far the eye must be, looking along -direction, to see every corner of the model's box.
   * @param {Vector3} direction of unit length */
  #fittingDistance(direction) {
    const half = this.aim(this.aspect) * 0.92;  // a margin
    const right = new Vector3(0, 1, 0).cross(direction).normalize();
    const up = direction.clone().cross(right);
    const center = this.#box.getCenter(new Vector3());
    const { min, max } = this.#box;
    let distance = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const point = new Vector3(corner & 1 ? max.x : min.x, corner & 2 ? max.y : min.y,
        corner & 4 ? max.z : min.z).sub(center);
      const across = Math.abs(point.dot(right)) / (half * this.aspect);
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
    const front = this.#front;
    return front && Math.abs(front.y) < 0.9 ? direction.lerp(front, 0.75).normalize() : direction;
  }

  /** Shows all of the model. */
  fit() {
    const direction = this.#direction();
    const distance = this.#fittingDistance(direction);
    this.camera.near = distance / 500;
    this.camera.far = distance * 50;
    this.#controls.minDistance = distance / 100;
    this.#controls.maxDistance = distance * 10;
    this.#place(this.#box.getCenter(new Vector3()), direction.multiplyScalar(distance));
  }

  /** @param {Vector3} target @param {Vector3} offset of the eye from there */
  #place(target, offset) {
    this.#controls.target.copy(target);
    this.camera.position.copy(target).add(offset);
    this.#controls.update();
    this.#onMove();
  }

  /** From what it looks at to the eye itself. @returns {Triple} */
  get direction() {
    return this.camera.position.clone().sub(this.#controls.target).normalize().toArray();
  }

  /** Flies to a place, to see it from a direction.
   * @param {Triple} point @param {Triple} direction */
  visit(point, direction) {
    const from = this.#controls.target.clone();
    const to = new Vector3(...point);
    const start = this.camera.position.clone().sub(from);
    const end = new Vector3(...direction)
      .setLength(Math.max(0.45 * this.diagonal, this.#controls.minDistance));
    const begin = performance.now();
    const step = () => {
      const time = isStill() ? 1 : Math.min(1, (performance.now() - begin) / flight);
      const eased = time * time * (3 - 2 * time);
      this.#place(from.clone().lerp(to, eased), start.clone().lerp(end, eased));
      if (time < 1) requestAnimationFrame(step);
    };
    step();
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
    const offset = this.camera.position.clone().sub(this.#controls.target);
    const spherical = new Spherical().setFromVector3(offset);
    spherical.theta += move[0];
    spherical.phi += move[1];
    spherical.radius *= move[2];
    this.#place(this.#controls.target.clone(), offset.setFromSpherical(spherical.makeSafe()));
  }
}
