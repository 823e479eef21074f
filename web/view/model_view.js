// SPDX-License-Identifier: MIT
// One model on the stage: its own materials, plain clay, flat, its normals, or coloured by a value,
// with or without its wireframe. It frees its graphics memory.
import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, MeshBasicMaterial,
  MeshNormalMaterial, MeshStandardMaterial,
} from 'three';
import { soupOf } from '../triangles/soup.js';
import { colorByAngle } from '../triangles/triangle_angles.js';

/** @typedef {'textured' | 'plain' | 'flat' | 'normals' | 'angles' | 'distance' | 'density'
 *   } Shading */
/** @typedef {Mesh<BufferGeometry, MeshStandardMaterial>} Surface */
/** The same triangles several times: as in the file, as lines, and coloured if needed.
 * relief: clay with the surface's normal map, if it has no other look.
 * @typedef {{ surface: Surface, own: import('three').Material | null, lines: Mesh,
 *   relief: MeshStandardMaterial | null,
 *   colored: Partial<Record<Shading, Mesh>> }} Part */

/** A scene ready to be shown. origin: the stage's, in the scene's world; bounds: relative to
 * `origin`; front: the direction in which the scene is open, null if closed.
 * @typedef {{ scene: import('three').Group, bounds: import('three').Box3,
 *   origin: import('three').Vector3, front: import('three').Vector3 | null }} Prepared */

/** Moves surfaces back a little, so that they do not hide lines on them. */
const behindLines = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };

// Materials shared by all models, so that their compiled shaders outlive each model.
const normals = new MeshNormalMaterial({ side: DoubleSide, ...behindLines });
const painted = new MeshStandardMaterial({ roughness: 0.85, metalness: 0, side: DoubleSide,
  vertexColors: true, ...behindLines });
const paintedFlat = new MeshStandardMaterial({ roughness: 0.85, metalness: 0, side: DoubleSide,
  vertexColors: true, flatShading: true, ...behindLines });
const wire = new MeshBasicMaterial({
  wireframe: true, transparent: true, depthWrite: false, color: 0x0b1f22,
});
/** @type {Map<string, { clay: MeshStandardMaterial, flat: MeshStandardMaterial }>} */
const clays = new Map();

/** @param {string} color */
function clayOf(color) {
  const look = { color, roughness: 0.62, metalness: 0, side: DoubleSide, ...behindLines };
  const made = clays.get(color) ?? { clay: new MeshStandardMaterial(look),
    flat: new MeshStandardMaterial({ ...look, flatShading: true }) };
  clays.set(color, made);
  return made;
}

/** Whether the file gives the surface textures or colours; else clay shows the shape better.
 * @param {Surface} surface */
function hasOwnLook({ material, geometry }) {
  const { map, normalMap, emissiveMap, color } = material;
  const isWhite = !color || color.equals(new Color(0xffffff));
  return Boolean(map || normalMap || emissiveMap || geometry.getAttribute('color') || !isWhite);
}

/** Whether a normal map is all that the file gives the surface, as what is baked from a model
 * without textures. @param {Surface} surface */
function hasReliefAlone({ material, geometry }) {
  const { map, normalMap, emissiveMap } = material;
  return Boolean(normalMap && !map && !emissiveMap && !geometry.getAttribute('color'));
}

/** @param {import('three').Object3D} scene @returns {Surface[]} */
export function surfacesOf(scene) {
  /** @type {Surface[]} */
  const surfaces = [];
  scene.traverse((object) => {
    if (object instanceof Mesh) surfaces.push(/** @type {Surface} */ (object));
  });
  return surfaces;
}

/** A hidden copy of a surface that follows the same node, skeleton and pose.
 * @param {Surface} surface @param {BufferGeometry} geometry
 * @param {import('three').Material} material */
function companion(surface, geometry, material) {
  const copy = /** @type {Mesh} */ (surface.clone(false));
  copy.geometry = geometry;
  copy.material = material;
  copy.visible = false;
  surface.parent?.add(copy);
  return copy;
}

/** The same vertices with separate colours, at first white. @param {BufferGeometry} geometry */
function recolored(geometry) {
  const copy = new BufferGeometry();
  for (const [name, attribute] of Object.entries(geometry.attributes)) {
    if (!name.startsWith('color')) copy.setAttribute(name, attribute);
  }
  copy.setIndex(geometry.index);
  copy.morphAttributes = geometry.morphAttributes;
  copy.boundingSphere = geometry.boundingSphere;
  const { count } = geometry.attributes.position;
  return copy.setAttribute('color', new BufferAttribute(new Float32Array(3 * count).fill(1), 3));
}

/** The geometry for the wireframe: the edges of polygons, without diagonals. A wireframe draws the
 * edges of triangles, and a triangle a, b, b draws the edge a–b, in any skin and pose.
 * @param {BufferGeometry} geometry */
function wires(geometry) {
  /** @type {{ outline?: Uint32Array }} */
  const { outline } = geometry.userData;
  if (!outline) return geometry;
  const { index, attributes, morphAttributes, boundingSphere, morphTargetsRelative } = geometry;
  const vertex = (/** @type {number} */ corner) => (index ? index.getX(corner) : corner);
  const corners = new Uint32Array(outline.length / 2 * 3);
  for (let edge = 0; 2 * edge < outline.length; ++edge) {
    const [a, b] = [vertex(outline[2 * edge]), vertex(outline[2 * edge + 1])];
    corners.set([a, b, b], 3 * edge);
  }
  const result = new BufferGeometry().setIndex(new BufferAttribute(corners, 1));
  return Object.assign(result,
    { attributes, morphAttributes, boundingSphere, morphTargetsRelative });
}

/** @param {BufferGeometry} geometry */
const triangleCount = ({ index, attributes }) => (index ?? attributes.position).count / 3;

export class ModelView {
  /** @type {Part[]} */
  #parts;
  #clay;

  /** @param {Prepared} prepared @param {string} color of the clay
   * @param {import('./thinning.js').Thinning | null} thinning null: all triangles are drawn */
  constructor({ scene, bounds, front }, color, thinning) {
    this.thinning = thinning;
    this.#clay = clayOf(color);
    this.group = scene;
    this.bounds = bounds;
    this.front = front;
    this.#parts = surfacesOf(scene).map((surface) => this.#prepare(surface));
    this.isTextured = this.#parts.some(({ own }) => own);
    this.edgeLength = this.#typicalEdgeLength();
  }

  /** @param {Surface} surface @returns {Part} */
  #prepare(surface) {
    const own = hasOwnLook(surface) ? Object.assign(surface.material, behindLines) : null;
    const lines = companion(surface, wires(surface.geometry), wire);
    lines.renderOrder = 1;
    const { normalMap, normalScale } = surface.material;
    const relief = hasReliefAlone(surface)
      ? Object.assign(this.#clay.clay.clone(), { normalMap, normalScale }) : null;
    return { surface, own, lines, relief, colored: {} };
  }

  get #surfaces() {
    return this.#parts.map(({ surface }) => surface);
  }

  /** An estimate from the box, good enough to fade the lines of a mesh too fine to see. */
  #typicalEdgeLength() {
    const { x, y, z } = this.bounds.getSize(this.bounds.min.clone());
    let triangles = 1;
    for (const { geometry } of this.#surfaces) triangles += triangleCount(geometry);
    return Math.sqrt(3 * (x * y + y * z + z * x) / triangles);
  }

  /** Whether the file says which triangles are quads. */
  get hasQuads() {
    return this.#surfaces.some(({ geometry }) => geometry.userData.polygons);
  }

  /** All triangles of the model, drawn or not, in the stage's coordinates.
   * @returns {Promise<import('../triangles/soup.js').Soup>} */
  async soup() {
    return this.thinning ? { ...await this.thinning.soup(this.#surfaces), polygons: null }
      : soupOf(this.#surfaces);
  }

  /** @param {Part} part */
  #coloredByAngle({ surface }) {
    const { geometry } = surface;
    const corners = geometry.index ? geometry.toNonIndexed() : geometry.clone();
    colorByAngle(corners, geometry.userData.polygons ?? null);
    return companion(surface, corners, paintedFlat);
  }

  /** Colours the vertices, in the order of the soup.
   * @param {'distance' | 'density'} shading
   * @param {(vertex: number, color: Color) => void} paint sets the colour of a vertex */
  setColors(shading, paint) {
    const color = new Color();
    let first = 0;
    for (const part of this.#parts) {
      part.colored[shading] ??=
        companion(part.surface, recolored(part.surface.geometry), painted);
      const attribute = part.colored[shading].geometry.getAttribute('color');
      const drawn = this.thinning?.parts[part.surface.geometry.userData.whole];
      for (let i = 0; i < attribute.count; ++i) {
        paint(first + (drawn ? drawn.kept[i] : i), color);
        attribute.setXYZ(i, color.r, color.g, color.b);
      }
      first += drawn?.vertices ?? attribute.count;
      attribute.needsUpdate = true;
    }
  }

  /** A shading whose colours or materials the model does not have is shown as plain clay.
   * @param {Shading} shading */
  setShading(shading) {
    const materials = { flat: this.#clay.flat, normals };
    for (const part of this.#parts) {
      const { surface, colored, own, relief } = part;
      // The drawn triangles of a thinned model are not its own, so they have no angles to show.
      if (shading === 'angles' && !this.thinning) colored.angles ??= this.#coloredByAngle(part);
      surface.visible = !colored[shading];
      for (const [name, mesh] of Object.entries(colored)) mesh.visible = name === shading;
      surface.material = /** @type {MeshStandardMaterial} */ (shading === 'textured' && own
        || materials[/** @type {'flat'} */ (shading)] || relief || this.#clay.clay);
    }
  }

  /** @param {boolean} isVisible */
  setWireframe(isVisible) {
    for (const { lines } of this.#parts) lines.visible = isVisible;
  }

  /** Fades the lines of the next picture. @param {number} pixels the length of a typical edge */
  setEdgePixels(pixels) {
    wire.opacity = 0.5 * Math.min(1, Math.max(0.06, (pixels - 1) / 11));
  }

  dispose() {
    this.thinning?.close();
    for (const mesh of surfacesOf(this.group)) mesh.geometry.dispose();
    for (const { own, relief } of this.#parts) {
      relief?.dispose();
      for (const value of Object.values(own ?? {})) if (value?.isTexture) value.dispose();
      own?.dispose();
    }
  }
}
