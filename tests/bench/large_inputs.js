// SPDX-License-Identifier: MIT
// Large meshes by formula, in the arrays of a scan: single precision, vertices shared.

/** A number from -1 to 1 that looks like chance. @param {number} number */
function noise(number) {
  let bits = Math.imul(number ^ (number >>> 16), 0x45d9f3b);
  bits = Math.imul(bits ^ (bits >>> 16), 0x45d9f3b);
  return ((bits ^ (bits >>> 16)) >>> 0) / 2 ** 31 - 1;
}

/** A torus with bumps of a tenth of its tube. @param {number} u @param {number} v angles */
function onBumpyTorus(u, v, outwards = 0) {
  const tube = 0.4 * (1 + 0.1 * Math.sin(13 * u) * Math.sin(5 * v)) + outwards;
  const radius = 1 + tube * Math.cos(v);
  return [radius * Math.cos(u), radius * Math.sin(u), tube * Math.sin(v)];
}

/** Triangles of a grid of cells that closes in both directions; without the first rows.
 * @param {{ columns: number, rows: number }} grid @param {number} leftOut rows */
function cells({ columns, rows }, leftOut) {
  const indices = new Uint32Array(6 * columns * (rows - leftOut));
  for (let row = leftOut, i = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1, i += 6) {
      const [here, up] = [row * columns, ((row + 1) % rows) * columns];
      const right = (column + 1) % columns;
      indices.set([here + column, here + right, up + right,
        here + column, up + right, up + column], i);
    }
  }
  return indices;
}

/** @param {number} triangles about so many */
function gridFor(triangles) {
  const rows = Math.round(Math.sqrt(triangles / 4));
  return { rows, columns: 2 * rows };
}

/** The places of the grid's vertices. @param {(vertex: number) => number} outwards */
function places({ columns, rows }, outwards) {
  const positions = new Float32Array(3 * columns * rows);
  for (let v = 0; v < columns * rows; v += 1) {
    const [row, column] = [Math.floor(v / columns), v % columns];
    positions.set(onBumpyTorus(2 * Math.PI * column / columns, 2 * Math.PI * row / rows,
      outwards(v)), 3 * v);
  }
  return positions;
}

/** A closed surface without noise. @param {number} triangles */
export function bumpyTorus(triangles) {
  const grid = gridFor(triangles);
  return { positions: places(grid, () => 0), indices: cells(grid, 0) };
}

/** A scan of it: noise of a fifth of the edges, a strip that nobody saw.
 * @param {number} triangles */
export function openScan(triangles) {
  const grid = gridFor(triangles);
  const edge = 2 * Math.PI * 0.4 / grid.rows;
  const positions = places(grid, (v) => 0.2 * edge * noise(v));
  return { positions, indices: cells(grid, Math.ceil(grid.rows / 20)) };
}
