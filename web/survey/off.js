// SPDX-License-Identifier: MIT
// The vertices of an OFF file, in the file's order, which is the core's order.

/** @typedef {import('./surface.js').Point} Point */

/** @param {{ bytes: Uint8Array, origin: Point }} request bytes: with texture coordinates or
 *   without @returns {Float32Array} positions relative to `origin` */
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
