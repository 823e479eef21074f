// SPDX-License-Identifier: MIT
// Meshes by formula, for tests through the package's public functions.

/** A torus of 2 × columns × rows triangles: Euler characteristic 0, no boundary. */
export function torus({ columns = 48, rows = 24, radius = 2, tube = 0.8 } = {}) {
  const positions = [];
  const indices = [];
  for (let i = 0; i < columns; i += 1) {
    for (let j = 0; j < rows; j += 1) {
      const [u, v] = [(2 * Math.PI * i) / columns, (2 * Math.PI * j) / rows];
      const reach = radius + tube * Math.cos(v);
      positions.push(reach * Math.cos(u), reach * Math.sin(u), tube * Math.sin(v));
      const at = (a, b) => ((i + a) % columns) * rows + ((j + b) % rows);
      indices.push(at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1));
    }
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

/** A hollow torus with small shafts to its inner space, each through a cell of its grid. */
export function drilledTorus({ columns = 96, rows = 48, every = 8 } = {}) {
  const [outer, inner] = [0.8, 0.77].map((tube) => torus({ columns, rows, tube }));
  const beneath = columns * rows;
  const indices = [];
  for (let cell = 0; cell < beneath; cell += 1) {
    const triangles = outer.indices.subarray(6 * cell, 6 * cell + 6);
    const [a, b, c, , , d] = triangles;
    if (Math.floor(cell / rows) % every === 0 && cell % rows % every === 0) {
      for (const [p, q] of [[a, b], [b, c], [c, d], [d, a]]) {
        indices.push(p, q, q + beneath, p, q + beneath, p + beneath);
      }
    } else {
      indices.push(...triangles, ...[...triangles].reverse().map((v) => v + beneath));
    }
  }
  return {
    positions: new Float32Array([...outer.positions, ...inner.positions]),
    indices: new Uint32Array(indices),
  };
}

/** Eight triangles: a closed surface that takes a few milliseconds. */
export function octahedron() {
  return {
    positions: new Float32Array([1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1]),
    indices: new Uint32Array([0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5,
      0, 3, 5]),
  };
}

/** A ring whose tube is, on one side, an eighth as thick as on the other: it bends most there. */
export function signetRing() {
  const [columns, rows, thick] = [160, 48, 0.8];
  const { positions, indices } = torus({ columns, rows, tube: thick });
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y] = [positions[i], positions[i + 1]];
    const turn = Math.atan2(y, x);
    const share = 9 / 16 + (7 / 16) * Math.cos(turn);
    const reach = 2 + share * (Math.hypot(x, y) - 2);
    positions[i] = reach * Math.cos(turn);
    positions[i + 1] = reach * Math.sin(turn);
    positions[i + 2] *= share;
  }
  return { positions, indices };
}

/** A square with `cells` cells along a side, two triangles each. @param {number} cells
 * @param {(row: number, column: number) => number[]} placeAt */
export function sheetOf(cells, placeAt) {
  const positions = [];
  const indices = [];
  for (let i = 0; i <= cells; i += 1) {
    for (let j = 0; j <= cells; j += 1) {
      positions.push(...placeAt(i, j));
      if (i === cells || j === cells) continue;
      const at = (a, b) => (i + a) * (cells + 1) + j + b;
      indices.push(at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1));
    }
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

/** A wavy square sheet of side 1: one boundary loop, Euler characteristic 1. */
export const sheet = (n = 24) => sheetOf(n, (i, j) =>
  [i / n, j / n, 0.1 * Math.sin((4 * i) / n) * Math.cos((3 * j) / n)]);

/** The mesh as the text of a PLY file. */
export function plyText({ positions, indices }) {
  const [, , ...rows] = offText({ positions, indices }).split('\n');
  return ['ply', 'format ascii 1.0', `element vertex ${positions.length / 3}`, 'property float x',
    'property float y', 'property float z', `element face ${indices.length / 3}`,
    'property list uchar int vertex_indices', 'end_header', ...rows].join('\n');
}

/** The mesh as a binary STL. */
export function stl({ positions, indices }) {
  const bytes = new Uint8Array(84 + (50 * indices.length) / 3);
  const view = new DataView(bytes.buffer);
  view.setUint32(80, indices.length / 3, true);
  indices.forEach((vertex, i) => {
    const at = 84 + 50 * Math.floor(i / 3) + 12 + 12 * (i % 3);
    for (let k = 0; k < 3; k += 1) view.setFloat32(at + 4 * k, positions[3 * vertex + k], true);
  });
  return bytes;
}

/** The mesh as the text of an OFF file. */
export function offText({ positions, indices }) {
  const lines = ['OFF', `${positions.length / 3} ${indices.length / 3} 0`];
  for (let i = 0; i < positions.length; i += 3) {
    lines.push(Array.from(positions.subarray(i, i + 3)).join(' '));
  }
  for (let i = 0; i < indices.length; i += 3) {
    lines.push(`3 ${Array.from(indices.subarray(i, i + 3)).join(' ')}`);
  }
  return `${lines.join('\n')}\n`;
}

/** Number of different positions of the vertices. */
export function distinctPositions(positions) {
  const seen = new Set();
  for (let i = 0; i < positions.length; i += 3) {
    seen.add(positions.slice(i, i + 3).join());
  }
  return seen.size;
}

/** Vertices − edges + triangles of a mesh without repeated positions. */
export function eulerCharacteristic({ positions, indices }) {
  const edges = new Set();
  for (let i = 0; i < indices.length; i += 3) {
    for (let k = 0; k < 3; k += 1) {
      const [a, b] = [indices[i + k], indices[i + ((k + 1) % 3)]];
      edges.add(Math.min(a, b) * 2 ** 26 + Math.max(a, b));
    }
  }
  return positions.length / 3 - edges.size + indices.length / 3;
}

/** x⁶ + y⁶ + z⁶ = 1: a cube of flat sides whose edges and corners are rounded. */
export function pillow(cells) {
  const [positions, indices] = [[], []];
  for (let side = 0; side < 6; side += 1) {
    const flat = sheetOf(cells, (i, k) => {
      const [u, v] = [2 * i / cells - 1, 2 * k / cells - 1];
      const around = side < 3 ? [1, u, v] : [-1, v, u];
      const [x, y, z] = [0, 1, 2].map((axis) => around[(axis + side) % 3]);
      const reach = (x ** 6 + y ** 6 + z ** 6) ** (1 / 6);
      return [x / reach, y / reach, z / reach];
    });
    const first = positions.length / 3;
    positions.push(...flat.positions);
    indices.push(...flat.indices.map((v) => first + v));
  }
  return { positions: new Float64Array(positions), indices: new Uint32Array(indices) };
}
