// SPDX-License-Identifier: MIT
// A tree of boxes around triangles: pairs whose boxes overlap, and the nearest point.

const leafSize = 4;

/** The closest point of a triangle, squared distance [Ericson 2005, "Real-Time Collision
 * Detection", 5.1.5]. Positions p and nine numbers from `at` on. */
export function squaredDistance(p, corners, at) {
  const a = [corners[at], corners[at + 1], corners[at + 2]];
  const ab = [corners[at + 3] - a[0], corners[at + 4] - a[1], corners[at + 5] - a[2]];
  const ac = [corners[at + 6] - a[0], corners[at + 7] - a[1], corners[at + 8] - a[2]];
  const ap = [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
  const d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return reach(ap, ab, ac, [0, 0]);
  const [aa, bb, cross] = [dot(ab, ab), dot(ac, ac), dot(ab, ac)];
  const d3 = d1 - aa, d4 = d2 - cross;
  if (d3 >= 0 && d4 <= d3) return reach(ap, ab, ac, [1, 0]);
  const vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return reach(ap, ab, ac, [d1 / (d1 - d3), 0]);
  const d5 = d1 - cross, d6 = d2 - bb;
  if (d6 >= 0 && d5 <= d6) return reach(ap, ab, ac, [0, 1]);
  const vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return reach(ap, ab, ac, [0, d2 / (d2 - d6)]);
  const va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return reach(ap, ab, ac, [1 - w, w]);
  }
  const sum = va + vb + vc;
  return reach(ap, ab, ac, [vb / sum, vc / sum]);
}

const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];

function reach(ap, ab, ac, [v, w]) {
  const x = ap[0] - v * ab[0] - w * ac[0], y = ap[1] - v * ab[1] - w * ac[1];
  const z = ap[2] - v * ab[2] - w * ac[2];
  return x * x + y * y + z * z;
}

function rayMeetsBox(start, direction, box) {
  let near = 0, far = Infinity;
  for (let k = 0; k < 3; k += 1) {
    const a = (box[k] - start[k]) / direction[k], b = (box[3 + k] - start[k]) / direction[k];
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near <= far * (1 + 1e-12) + 1e-300;
}

/** 1 if the ray comes out through the triangle, −1 if it goes in, 0 if it misses it
 * [Möller and Trumbore 1997]. */
function rayThrough(start, direction, c) {
  const u = [c[3] - c[0], c[4] - c[1], c[5] - c[2]];
  const v = [c[6] - c[0], c[7] - c[1], c[8] - c[2]];
  const p = cross(direction, v);
  const det = dot(u, p);
  if (det === 0) return 0;
  const s = [start[0] - c[0], start[1] - c[1], start[2] - c[2]];
  const a = dot(s, p) / det;
  const q = cross(s, u);
  const b = dot(direction, q) / det;
  if (a < 0 || b < 0 || a + b > 1 || dot(v, q) / det < 0) return 0;
  return det < 0 ? 1 : -1;
}

const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
  u[0] * v[1] - u[1] * v[0]];

export class BoxTree {
  /** @param {Float64Array} corners nine numbers for each triangle */
  constructor(corners) {
    this.corners = corners;
    const count = corners.length / 9;
    this.order = Uint32Array.from({ length: count }, (_, t) => t);
    this.boxes = [];
    this.nodes = [];
    this.centres = Float64Array.from({ length: 3 * count }, (_, i) => {
      const at = 9 * Math.floor(i / 3) + (i % 3);
      return corners[at] + corners[at + 3] + corners[at + 6];
    });
    if (count > 0) this.#build(0, count);
  }

  #boxOf(from, to) {
    const box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    for (let i = from; i < to; i += 1) {
      const at = 9 * this.order[i];
      for (let k = 0; k < 9; k += 1) {
        const value = this.corners[at + k];
        if (value < box[k % 3]) box[k % 3] = value;
        if (value > box[3 + (k % 3)]) box[3 + (k % 3)] = value;
      }
    }
    return box;
  }

  #build(from, to) {
    const box = this.#boxOf(from, to);
    const number = this.nodes.push({ box, from, to, left: -1, right: -1 }) - 1;
    if (to - from <= leafSize) return number;
    const sizes = [0, 1, 2].map((k) => box[3 + k] - box[k]);
    const axis = sizes.indexOf(Math.max(...sizes));
    this.order.subarray(from, to).sort((s, t) =>
      this.centres[3 * s + axis] - this.centres[3 * t + axis]);
    const middle = (from + to) >> 1;
    this.nodes[number].left = this.#build(from, middle);
    this.nodes[number].right = this.#build(middle, to);
    return number;
  }

  #overlap(p, q) {
    const [a, b] = [this.nodes[p].box, this.nodes[q].box];
    return a[0] <= b[3] && b[0] <= a[3] && a[1] <= b[4] && b[1] <= a[4]
      && a[2] <= b[5] && b[2] <= a[5];
  }

  /** Calls visit(s, t) for each two triangles in leaves whose boxes overlap.
   * @param {(s: number, t: number) => void} visit */
  visitPairs(visit) {
    const stack = this.nodes.length > 0 ? [[0, 0]] : [];
    while (stack.length > 0) {
      const [p, q] = stack.pop();
      const [one, other] = [this.nodes[p], this.nodes[q]];
      if (p !== q && !this.#overlap(p, q)) continue;
      if (one.left < 0 && other.left < 0) this.#visitLeaves(one, other, visit);
      else if (p === q) {
        stack.push([one.left, one.left], [one.right, one.right], [one.left, one.right]);
      } else if (other.left < 0 || (one.left >= 0 && one.to - one.from >= other.to - other.from)) {
        stack.push([one.left, q], [one.right, q]);
      } else stack.push([p, other.left], [p, other.right]);
    }
  }

  #visitLeaves(one, other, visit) {
    for (let i = one.from; i < one.to; i += 1) {
      for (let k = one === other ? i + 1 : other.from; k < other.to; k += 1) {
        const [s, t] = [this.order[i], this.order[k]];
        if (s < t) visit(s, t);
        else visit(t, s);
      }
    }
  }

  /** How often a ray goes in less often than it comes out, by the triangles' turn: the number of
   * closed surfaces around its start. @param {number[]} start @param {number[]} direction */
  winding(start, direction) {
    let sum = 0;
    const stack = this.nodes.length > 0 ? [0] : [];
    while (stack.length > 0) {
      const { box, left, right, from, to } = this.nodes[stack.pop()];
      if (!rayMeetsBox(start, direction, box)) continue;
      if (left >= 0) {
        stack.push(left, right);
        continue;
      }
      for (let i = from; i < to; i += 1) {
        sum += rayThrough(start, direction, this.corners.subarray(9 * this.order[i]));
      }
    }
    return sum;
  }

  /** Whether a ray meets any triangle. @param {number[]} start @param {number[]} direction */
  isMetBy(start, direction) {
    const stack = this.nodes.length > 0 ? [0] : [];
    while (stack.length > 0) {
      const { box, left, right, from, to } = this.nodes[stack.pop()];
      if (!rayMeetsBox(start, direction, box)) continue;
      if (left >= 0) {
        stack.push(left, right);
        continue;
      }
      for (let i = from; i < to; i += 1) {
        if (rayThrough(start, direction, this.corners.subarray(9 * this.order[i])) !== 0) {
          return true;
        }
      }
    }
    return false;
  }

  /** The distance from a point to the nearest triangle. @param {ArrayLike<number>} p */
  distance(p) {
    let best = Infinity;
    const stack = this.nodes.length > 0 ? [[0, 0]] : [];
    while (stack.length > 0) {
      const [number, bound] = stack.pop();
      if (bound >= best) continue;
      const { left, right, from, to } = this.nodes[number];
      if (left < 0) {
        for (let i = from; i < to; i += 1) {
          best = Math.min(best, squaredDistance(p, this.corners, 9 * this.order[i]));
        }
        continue;
      }
      const next = [[left, this.#beyond(p, left)], [right, this.#beyond(p, right)]];
      next.sort((a, b) => b[1] - a[1]);
      stack.push(...next);
    }
    return Math.sqrt(best);
  }

  #beyond(p, number) {
    const { box } = this.nodes[number];
    let sum = 0;
    for (let k = 0; k < 3; k += 1) {
      const out = Math.max(box[k] - p[k], 0, p[k] - box[3 + k]);
      sum += out * out;
    }
    return sum;
  }
}
