// SPDX-License-Identifier: MIT
// The vertices of an OFF file, in their order: the order in which the core counts them.

/** @typedef {import('./surface.js').Point} Point */

/** @param {{ bytes: Uint8Array, origin: Point }} request `bytes` with texture coordinates or
 *   without; from where the vertices are told @returns {Float32Array} */
export function offVertices({ bytes, origin }) {
  const lines = new TextDecoder().decode(bytes).split('\n');
  const count = Number(lines[1].split(' ')[0]);
  const positions = new Float32Array(3 * count);
  for (let v = 0; v < count; ++v) {
    const world = lines[2 + v].split(' ', 3).map(Number);
    positions.set(world.map((x, k) => x - origin[k]), 3 * v);
  }
  return positions;
}
