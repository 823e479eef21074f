// SPDX-License-Identifier: MIT
// The surface that scenes show: a bumpy torus by formula, remeshed by the engine, seen from a side
// that one can turn.
import { remesh } from 'remesher/arrays';

/** @typedef {[number, number, number]} Vector */
/** @typedef {import('./stage.js').Point} Point */
/** quads: four indices each; without them the faces are the triangles.
 * @typedef {{ positions: ArrayLike<number>, indices: ArrayLike<number>,
 *   quads?: ArrayLike<number> }} Polygons */

const [around, across] = [96, 48];

export function bumpyTorus() {
  const positions = [], indices = [];
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      const [u, v] = [2 * Math.PI * i / around, 2 * Math.PI * j / across];
      const tube = 0.34 + 0.07 * Math.sin(3 * u) * Math.cos(2 * v);
      const ring = 0.78 + tube * Math.cos(v);
      positions.push(ring * Math.cos(u), ring * Math.sin(u), tube * Math.sin(v));
      const at = (/** @type {number} */ k, /** @type {number} */ l) =>
        (k % around) * across + l % across;
      const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      indices.push(a, b, c, a, c, d);
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

/** A mesh with its neighbours, turned to the reader. */
export class Solid {
  /** Radians: about the x axis, then about the vertical of the screen. */
  tilt = -0.9;
  turn = 0.5;

  /** @param {Polygons} mesh */
  constructor({ positions, indices, quads }) {
    /** @type {Vector[]} */
    this.points = Array.from({ length: positions.length / 3 }, (_, v) =>
      [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]]);
    /** @type {Vector[]} */
    this.triangles = Array.from({ length: indices.length / 3 }, (_, t) =>
      [indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]]);
    /** @type {number[][]} */
    this.faces = quads ? Array.from({ length: quads.length / 4 }, (_, i) =>
      [0, 1, 2, 3].map((k) => quads[4 * i + k])) : this.triangles;
  }

  /** @param {object} options of `remesh` */
  static async made(options) {
    return new Solid((await remesh(bumpyTorus(), options)).mesh);
  }

  /** The neighbours of a vertex, in order around it. @param {number} v */
  ring(v) {
    /** @type {Map<number, number>} */
    const next = new Map();
    for (const triangle of this.triangles) {
      const k = triangle.indexOf(v);
      if (k >= 0) next.set(triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
    }
    const ring = [next.keys().next().value ?? v];
    while (ring.length < next.size) ring.push(next.get(ring[ring.length - 1]) ?? v);
    return ring;
  }

  /** Follows a drag over so many pixels of a figure that is so wide.
   * @param {Point} by @param {number} width */
  drag([x, y], width) {
    this.turn += 3 * x / width;
    this.tilt += 3 * y / width;
  }

  /** @param {Vector} p @returns {Vector} to the right, up, and towards the reader */
  seen([x, y, z]) {
    const [up, near] = [y * Math.cos(this.tilt) - z * Math.sin(this.tilt),
      y * Math.sin(this.tilt) + z * Math.cos(this.tilt)];
    return [x * Math.cos(this.turn) + near * Math.sin(this.turn), up,
      near * Math.cos(this.turn) - x * Math.sin(this.turn)];
  }

  /** The vertex that is seen nearest to a point of the view. @param {Point} at */
  vertexAt(at) {
    const [, v] = this.points.map(this.seen, this).reduce((best, [x, y, z], i) => {
      const off = Math.hypot(x - at[0], y - at[1]) - 0.15 * z;
      return off < best[0] ? [off, i] : best;
    }, [Infinity, 0]);
    return v;
  }

  /** @param {ReturnType<import('./stage.js').Stage['view']>} view
   * @param {(triangle: Vector) => boolean} [isChosen] */
  draw(view, isChosen = () => false) {
    const seen = this.points.map(this.seen, this);
    const depth = (/** @type {Vector} */ [a, b, c]) => seen[a][2] + seen[b][2] + seen[c][2];
    for (const triangle of [...this.triangles].sort((s, t) => depth(s) - depth(t))) {
      const corners = triangle.map((v) => /** @type {Point} */ ([seen[v][0], seen[v][1]]));
      const [[ax, ay], [bx, by], [cx, cy]] = corners;
      if ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay) <= 0) continue;
      view.polygon(corners, isChosen(triangle) ? 'chosen' : 'face');
    }
  }

  /** Draws the faces as light from the reader shows them, far ones first; without lines where they
   * would be all that is seen. Through holes the inside is seen.
   * @param {ReturnType<import('./stage.js').Stage['view']>} view @param {boolean} isOpen */
  drawLit(view, isOpen) {
    const seen = this.points.map(this.seen, this), isDense = this.faces.length > 3000;
    const depth = (/** @type {number[]} */ face) =>
      face.reduce((sum, v) => sum + seen[v][2], 0) / face.length;
    for (const face of [...this.faces].sort((s, t) => depth(s) - depth(t))) {
      const slope = slopeOf(face.map((v) => seen[v]));
      if (slope <= 0 && !isOpen) continue;
      const light = Math.round(60 + 34 * Math.abs(slope));
      const fill = slope > 0 ? `hsl(212 38% ${light}%)` : `hsl(18 45% ${light - 20}%)`;
      view.polygon(face.map((v) => [seen[v][0], seen[v][1]]), fill, isDense ? fill : 'line');
    }
  }
}

/** The cosine of the angle between a face's normal and the way to the reader.
 * @param {Vector[]} corners */
function slopeOf([a, b, c]) {
  const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
  const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  return normal[2] / (Math.hypot(...normal) || 1);
}
