// SPDX-License-Identifier: MIT
// Cuts a polygon that need not be convex into triangles: an ear after the other goes, a corner that
// turns inwards and whose triangle holds no other corner.

/** The coordinates of corners in the two axes that the polygon's area is largest in.
 * @param {ArrayLike<number>} positions @param {number[]} face */
function flattened(positions, face) {
  const at = (/** @type {number} */ v, /** @type {number} */ k) => positions[3 * v + k % 3];
  const areas = [0, 1, 2].map((axis) => face.reduce((sum, v, i) => {
    const next = face[(i + 1) % face.length];
    return sum + at(v, axis + 1) * at(next, axis + 2) - at(v, axis + 2) * at(next, axis + 1);
  }, 0));
  const axis = [0, 1, 2].sort((a, b) => Math.abs(areas[b]) - Math.abs(areas[a]))[0];
  const side = Math.sign(areas[axis]) || 1;
  return face.map((v) => [side * at(v, axis + 1), at(v, axis + 2)]);
}

/** Twice the area of a triangle in the plane, positive if it turns left. */
const turn = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);

/**
 * @param {ArrayLike<number>} positions three numbers a vertex
 * @param {number[]} face its vertices in order
 * @returns {number[]} three vertices for each triangle
 */
export function cutByEars(positions, face) {
  const points = flattened(positions, face);
  const rest = face.map((_, i) => i);
  const triangles = [];
  const isEar = (/** @type {number} */ k) => {
    const corners = [k - 1, k, k + 1].map((i) => rest[(i + rest.length) % rest.length]);
    const [a, b, c] = corners.map((i) => points[i]);
    // A polygon with a hole goes to it and back: two corners are at one place.
    const isCorner = ([x, y]) => [a, b, c].some((point) => point[0] === x && point[1] === y);
    const isOutside = (point) => turn(a, b, point) < 0 || turn(b, c, point) < 0
      || turn(c, a, point) < 0;
    return turn(a, b, c) > 0
      && rest.every((i) => isCorner(points[i]) || isOutside(points[i]));
  };
  while (rest.length > 3) {
    const found = rest.findIndex((_, k) => isEar(k));
    const k = Math.max(0, found);
    triangles.push(...[k - 1, k, k + 1].map((i) => face[rest[(i + rest.length) % rest.length]]));
    rest.splice(k, 1);
  }
  return [...triangles, ...rest.map((i) => face[i])];
}
