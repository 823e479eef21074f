// SPDX-License-Identifier: MIT
// One model on the stage: its own materials or plain clay, smooth, flat or coloured by angle, with
// or without its wireframe. Owns what it puts on the graphics card, and frees it.
import { Box3, Color, DoubleSide, Mesh, MeshBasicMaterial, MeshStandardMaterial } from 'three';
import { openSide } from './facing.js';
import { withNormals } from './normals.js';
import { colorByAngle } from './triangle_angles.js';

/** @typedef {'smooth' | 'flat' | 'angles'} Shading */
/** @typedef {import('three').BufferGeometry} BufferGeometry */
/** @typedef {Mesh<BufferGeometry, MeshStandardMaterial>} Surface */
/** The same triangles three times: as the file has them, as lines, and coloured when asked for.
 * @typedef {{ surface: Surface, wire: Mesh, angles: Mesh | null }} Part */

/** Pushes surfaces back a little, so that lines on them are drawn whole. */
const behindLines = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };

/** Whether a file gave the surface a look of its own; else clay shows the shape better.
 * @param {Surface} surface */
function hasOwnLook({ material, geometry }) {
  const { map, normalMap, emissiveMap, color } = material;
  const isWhite = !color || color.equals(new Color(0xffffff));
  return Boolean(map || normalMap || emissiveMap || geometry.getAttribute('color') || !isWhite);
}

/** @param {import('three').Object3D} scene @returns {Surface[]} */
function surfacesOf(scene) {
  /** @type {Surface[]} */
  const surfaces = [];
  scene.traverse((object) => {
    if (object instanceof Mesh) surfaces.push(/** @type {Surface} */ (object));
  });
  return surfaces;
}

/** A copy beside the original that follows the same node, skeleton and pose.
 * @param {Surface} surface @param {BufferGeometry} geometry
 * @param {import('three').Material} material */
function companion(surface, geometry, material) {
  const copy = /** @type {Mesh} */ (surface.clone(false));
  copy.geometry = geometry;
  copy.material = material;
  surface.parent?.add(copy);
  return copy;
}

/** @param {BufferGeometry} geometry */
const triangleCount = ({ index, attributes }) => (index ?? attributes.position).count / 3;

export class ModelView {
  /** @type {Part[]} */
  #parts;
  #clay;
  #wire = new MeshBasicMaterial({
    wireframe: true, transparent: true, depthWrite: false, color: 0x0b1f22,
  });

  /** @param {import('three').Group} scene as loaded @param {string} color of the clay */
  constructor(scene, color) {
    this.#clay = new MeshStandardMaterial(
      { color, roughness: 0.62, metalness: 0, side: DoubleSide, ...behindLines });
    this.group = scene;
    scene.updateMatrixWorld(true);
    this.bounds = new Box3().setFromObject(scene);
    this.#parts = surfacesOf(scene).map((surface) => this.#prepare(surface));
    this.isTextured = this.#parts.some(({ surface }) => surface.material !== this.#clay);
    this.edgeLength = this.#typicalEdgeLength();
    this.front = openSide(this.#parts.map(({ surface }) => surface));
  }

  /** @param {Surface} surface @returns {Part} */
  #prepare(surface) {
    surface.geometry = withNormals(surface.geometry);
    if (hasOwnLook(surface)) Object.assign(surface.material, behindLines);
    else surface.material = this.#clay;
    const wire = companion(surface, surface.geometry, this.#wire);
    wire.renderOrder = 1;
    return { surface, wire, angles: null };
  }

  /** A guess from the box, good enough to fade the lines of a mesh too fine to see. */
  #typicalEdgeLength() {
    const { x, y, z } = this.bounds.getSize(this.bounds.min.clone());
    let triangles = 1;
    for (const { surface } of this.#parts) triangles += triangleCount(surface.geometry);
    return Math.sqrt(3 * (x * y + y * z + z * x) / triangles);
  }

  /** @param {Surface} surface */
  #coloredByAngle(surface) {
    const { geometry } = surface;
    const corners = geometry.index ? geometry.toNonIndexed() : geometry.clone();
    colorByAngle(corners);
    const material = new MeshStandardMaterial({ roughness: 0.8, metalness: 0, side: DoubleSide,
      vertexColors: true, flatShading: true, ...behindLines });
    return companion(surface, corners, material);
  }

  /** @param {Shading} shading */
  setShading(shading) {
    for (const part of this.#parts) {
      const { surface } = part;
      if (shading === 'angles') part.angles ??= this.#coloredByAngle(surface);
      if (part.angles) part.angles.visible = shading === 'angles';
      surface.visible = shading !== 'angles';
      if (surface.material.flatShading === (shading === 'flat')) continue;
      surface.material.flatShading = shading === 'flat';
      surface.material.needsUpdate = true;
    }
  }

  /** @param {boolean} isVisible */
  setWireframe(isVisible) {
    for (const { wire } of this.#parts) wire.visible = isVisible;
  }

  /** @param {number} pixels the length of a typical edge on the screen */
  setEdgePixels(pixels) {
    this.#wire.opacity = 0.5 * Math.min(1, Math.max(0.06, (pixels - 1) / 11));
  }

  dispose() {
    for (const mesh of surfacesOf(this.group)) {
      mesh.geometry.dispose();
      for (const value of Object.values(mesh.material)) if (value?.isTexture) value.dispose();
      mesh.material.dispose();
    }
  }
}
