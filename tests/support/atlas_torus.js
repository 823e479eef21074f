// SPDX-License-Identifier: MIT
// A torus whose texture is an atlas of charts, each a block of the torus's columns and rows.

export const [columns, rows] = [64, 32];
export const texels = 512;
export const gutter = 8;  // texels around a chart

/** The charts' first and last columns and rows on the torus. */
export const wide = { around: [0, 20, 40, 64], across: [0, 12, 32] };
/** The second chart of either kind is narrower than half an edge of a mesh of 400 vertices. */
export const narrow = { around: [0, 31, 32, 64], across: [0, 15, 16, 32] };

const spans = (cuts) => cuts.slice(1).map((end, i) => [cuts[i], end]);

/** The charts, each in a separate cell of a texture divided into rows and columns. */
export function layOut({ around, across }) {
  const cell = [texels / (around.length - 1), texels / (across.length - 1)];
  return spans(around).flatMap(([i0, i1], a) => spans(across).map(([j0, j1], b) => ({
    i0, i1, j0, j1,
    left: a * cell[0] + gutter, top: b * cell[1] + gutter,
    width: cell[0] - 2 * gutter, height: cell[1] - 2 * gutter,
  })));
}

/** The point at a column and a row, which need not be whole numbers. */
export function place(i, j) {
  const [u, v] = [(2 * Math.PI * (i % columns)) / columns, (2 * Math.PI * (j % rows)) / rows];
  const reach = 2 + 0.8 * Math.cos(v);
  return [reach * Math.cos(u), reach * Math.sin(u), 0.8 * Math.sin(v)];
}

/** Adds a chart as a separate grid: points on a seam are repeated in each chart. */
export function addChart(mesh, { i0, i1, j0, j1, left, top, width, height }) {
  const first = mesh.positions.length / 3;
  for (let i = i0; i <= i1; i += 1) {
    for (let j = j0; j <= j1; j += 1) {
      mesh.positions.push(...place(i, j));
      mesh.texcoords.push((left + (width * (i - i0)) / (i1 - i0)) / texels,
        (top + (height * (j - j0)) / (j1 - j0)) / texels);
      if (i === i1 || j === j1) continue;
      const at = (a, b) => first + (i + a - i0) * (j1 - j0 + 1) + j + b - j0;
      mesh.indices.push(at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1));
    }
  }
}
