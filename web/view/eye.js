// SPDX-License-Identifier: MIT
// The eye: one camera for all panes, its turning, and the target it looks at.
import {
  Box3, MathUtils, MOUSE, PerspectiveCamera, Spherical, TOUCH, Vector3,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** @typedef {[number, number, number]} Triple */

const fieldOfView = 32;
/** Duration of a flight to a place, in milliseconds. */
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
  /** The share of the height that the toolbar and the tags leave free, and how far the middle of
   * that is above the middle of the pane. */
  free = 1;
  lift = 0;

  /** @param {HTMLCanvasElement} canvas @param {() => void} onMove */
  constructor(canvas, onMove) {
    this.#onMove = onMove;
    this.#controls = new OrbitControls(this.camera, canvas);
    this.#controls.enableDamping = !isStill();
    this.#controls.addEventListener('change', onMove);
    canvas.addEventListener('keydown', (event) => this.#onKey(event));
  }

  /** Lets the turning glide on, and calls onMove while the eye moves. */
  update() {
    this.#controls.update();
  }

  /** Whether dragging turns the model; else the right button or two fingers turn it.
   * @param {boolean} isOn */
  setTurning(isOn) {
    this.#controls.mouseButtons.RIGHT = isOn ? MOUSE.PAN : MOUSE.ROTATE;
    this.#controls.mouseButtons.LEFT = isOn ? MOUSE.ROTATE : null;
    this.#controls.touches.ONE = isOn ? TOUCH.ROTATE : null;
  }

  /** Distance from the eye to its target. */
  get distance() {
    return this.camera.position.distanceTo(this.#controls.target);
  }

  /** The length of the box's diagonal. */
  get diagonal() {
    return this.#box.getSize(new Vector3()).length();
  }

  /** The model's bounding box. */
  get box() {
    return this.#box;
  }

  /** The box's centre. */
  get center() {
    return this.#box.getCenter(new Vector3());
  }

  /** Looks at a model, from its open side if it has one.
   * @param {Box3} box @param {Vector3 | null} front */
  setSubject(box, front) {
    this.#box.copy(box);
    this.#front = front;
    this.fit();
  }

  /** In a pane narrower than high the field of view applies to the width.
   * @param {number} aspect @returns {number} half the visible height at distance 1 */
  aim(aspect) {
    const half = Math.tan(MathUtils.degToRad(fieldOfView / 2)) / Math.min(1, aspect);
    this.camera.fov = MathUtils.radToDeg(2 * Math.atan(half));
    this.camera.setViewOffset(1, 1, 0, this.lift, 1, 1);
    this.camera.aspect = aspect;  // which the offset has set, too
    this.camera.updateProjectionMatrix();
    return half;
  }

  /** The distance from which the eye, looking along -direction, sees all corners of the box.
   * @param {Vector3} direction of unit length */
  #fittingDistance(direction) {
    const margin = 0.92;
    const half = this.aim(this.aspect);
    const [wide, tall] = [half * this.aspect * margin, half * Math.min(margin, this.free)];
    const right = new Vector3(0, 1, 0).cross(direction).normalize();
    const up = direction.clone().cross(right);
    const center = this.#box.getCenter(new Vector3());
    const { min, max } = this.#box;
    let distance = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const point = new Vector3(corner & 1 ? max.x : min.x, corner & 2 ? max.y : min.y,
        corner & 4 ? max.z : min.z).sub(center);
      const across = Math.abs(point.dot(right)) / wide;
      const along = Math.abs(point.dot(up)) / tall;
      distance = Math.max(distance, Math.max(across, along) + point.dot(direction));
    }
    return distance;
  }

  /** The direction of the first view: from the open side, or the broader one, a little above. */
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

  /** The unit vector from the target to the eye. @returns {Triple} */
  get direction() {
    return this.camera.position.clone().sub(this.#controls.target).normalize().toArray();
  }

  /** Flies to a view of a place from a direction.
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
