// SPDX-License-Identifier: MIT
// Lines, dots and a mark over a surface: feature curves, borders, the triangle under the pointer,
// the field, the guides and the irregular vertices of quads, the place of the largest distance.
import {
  BufferAttribute, BufferGeometry, CanvasTexture, Color, Group, Points, PointsMaterial, Sprite,
  SpriteMaterial,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { lineColors, valenceColors } from '../base/colors.js';

/** @typedef {keyof typeof lineColors} LineKind */

/** In pixels; the strokes of a field are many. @type {Partial<Record<LineKind, number>>} */
const widths = { field: 1.5, direction: 4, loop: 4, drawn: 4 };

/** The mark's picture: a ring. */
function ring() {
  const canvas = new OffscreenCanvas(64, 64);
  const context = canvas.getContext('2d');
  if (context) {
    const strokes = /** @type {[number, string][]} */ ([[14, '#fff'], [7, '#c2255c']]);
    for (const [width, color] of strokes) {
      context.beginPath();
      context.arc(32, 32, 22, 0, 2 * Math.PI);
      context.lineWidth = width;
      context.strokeStyle = color;
      context.stroke();
    }
  }
  return new CanvasTexture(canvas);
}

/** The dots' picture: a white disc, coloured by the vertex colours. */
function disc() {
  const canvas = new OffscreenCanvas(32, 32);
  const context = canvas.getContext('2d');
  if (context) {
    context.fillStyle = '#fff';
    context.beginPath();
    context.arc(16, 16, 15, 0, 2 * Math.PI);
    context.fill();
  }
  return new CanvasTexture(canvas);
}

/** @param {number} valence */
const colorOf = (valence) => new Color(valence === 3 ? valenceColors.three
  : valence === 5 ? valenceColors.five : valenceColors.other);

/** Draws the dots a little nearer to the eye, so that the surface does not cut them.
 * @param {{ vertexShader: string }} shader */
function nearer(shader) {
  const part = '#include <project_vertex>';
  shader.vertexShader = shader.vertexShader.replace(part,
    `${part}\ngl_Position = projectionMatrix * vec4(0.985 * mvPosition.xyz, 1.0);`);
}

/** @param {import('../triangles/polygons.js').Irregular} irregular */
function dotsAt({ places, valences }) {
  const colors = Float32Array.from(valences.flatMap((valence) => colorOf(valence).toArray()));
  const geometry = new BufferGeometry()
    .setAttribute('position', new BufferAttribute(places, 3))
    .setAttribute('color', new BufferAttribute(colors, 3));
  const material = new PointsMaterial({ size: 8, sizeAttenuation: false, vertexColors: true,
    map: disc(), alphaTest: 0.5 });
  material.onBeforeCompile = nearer;
  const dots = new Points(geometry, material);
  dots.renderOrder = 2;
  dots.frustumCulled = false;
  return dots;
}

export class Overlays {
  group = new Group();
  /** @type {Points<BufferGeometry, PointsMaterial> | null} */
  #dots = null;
  #hasDots = true;
  /** @type {Map<LineKind, LineSegments2>} */
  #lines = new Map();
  /** @type {Sprite | null} */
  #mark = null;

  /** @param {LineKind} kind @param {Float32Array} segments pairs of points, six numbers each */
  setLines(kind, segments) {
    this.#remove(kind);
    if (!segments.length) return;
    const material = new LineMaterial({ color: lineColors[kind], linewidth: widths[kind] ?? 3,
      polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 });
    const geometry = new LineSegmentsGeometry().setPositions(segments);
    const lines = new LineSegments2(geometry, material);
    lines.renderOrder = 2;
    lines.frustumCulled = false;
    this.#lines.set(kind, lines);
    this.group.add(lines);
  }

  /** @param {LineKind} kind @param {number} count how many of its segments are drawn, from the
   * first */
  setCount(kind, count) {
    const lines = this.#lines.get(kind);
    if (!lines) return;
    lines.geometry.instanceCount = count;
    lines.visible = count > 0;
  }

  /** @param {LineKind} kind */
  #remove(kind) {
    const lines = this.#lines.get(kind);
    if (!lines) return;
    this.group.remove(lines);
    lines.geometry.dispose();
    lines.material.dispose();
    this.#lines.delete(kind);
  }

  /** @param {import('../triangles/polygons.js').Irregular | null} irregular null: none */
  setDots(irregular) {
    if (this.#dots) {
      this.group.remove(this.#dots);
      this.#dots.geometry.dispose();
      this.#dots.material.map?.dispose();
      this.#dots.material.dispose();
    }
    this.#dots = irregular?.valences.length ? dotsAt(irregular) : null;
    if (this.#dots) this.group.add(this.#dots);
    this.showDots(this.#hasDots);
  }

  /** @param {boolean} isVisible */
  showDots(isVisible) {
    this.#hasDots = isVisible;
    if (this.#dots) this.#dots.visible = isVisible;
  }

  /** A ring around a place, seen through the surface; null: none.
   * @param {readonly [number, number, number] | null} point */
  setMark(point) {
    if (point && !this.#mark) {
      this.#mark = new Sprite(new SpriteMaterial({ map: ring(), depthTest: false,
        sizeAttenuation: false, transparent: true }));
      this.#mark.scale.setScalar(0.035);
      this.#mark.renderOrder = 3;
      this.group.add(this.#mark);
    }
    if (!this.#mark) return;
    this.#mark.visible = Boolean(point);
    if (point) this.#mark.position.set(...point);
  }

  /** Removes all overlays: their surface is gone. */
  clear() {
    for (const kind of [...this.#lines.keys()]) this.#remove(kind);
    this.setMark(null);
    this.setDots(null);
  }
}
