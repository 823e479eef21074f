// SPDX-License-Identifier: MIT
// An assembly as CAD systems export it, by formula: turned parts with sharp edges, long thin
// triangles on flat faces, and triangles without area where a row of points is a single point or
// two rows are the same circle.

const parts = 46;
const segments = 53;
// Radius and height along the outline of a part, from pole to pole; one point is listed twice.
const outline = [[0, 0], [4, 0], [9, 0], [9, 3], [6, 3], [6, 3], [6, 8], [6, 14], [7, 15], [7, 19],
  [5, 19], [5, 24], [3, 26], [1, 26.5], [0, 26.5]];

function turnedPart(scale) {
  const positions = outline.flatMap(([radius, height]) =>
    Array.from({ length: segments }, (_, k) => {
      const turn = (2 * Math.PI * k) / segments;
      return [scale * radius * Math.cos(turn), scale * radius * Math.sin(turn), scale * height];
    }).flat());
  const indices = outline.slice(1).flatMap((_, row) =>
    Array.from({ length: segments }, (__, k) => {
      const here = row * segments + k;
      const beside = row * segments + ((k + 1) % segments);
      return [here, beside, beside + segments, here, beside + segments, here + segments];
    }).flat());
  return { positions: new Float64Array(positions), indices: new Uint32Array(indices) };
}

/** A scene: parts of five sizes, each in its own place. */
export function assembly() {
  return Array.from({ length: parts }, (_, n) => ({
    mesh: turnedPart(1 + (n % 5) / 4),
    places: [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 50 * (n % 7), 50 * Math.floor(n / 7), 0, 1]],
  }));
}
