// SPDX-License-Identifier: MIT
// The positions of a geometry's vertices, in whatever form the file stores them.

/** Three coordinates a vertex, in the geometry's own space. Callers must not change them.
 * @param {import('three').BufferGeometry} geometry @returns {Float32Array} */
export function positionsOf({ attributes: { position } }) {
  const isPlain = 'isBufferAttribute' in position && position.itemSize === 3;
  if (isPlain && position.array instanceof Float32Array) return position.array;
  const positions = new Float32Array(3 * position.count);
  for (let i = 0; i < position.count; ++i) {
    positions[3 * i] = position.getX(i);
    positions[3 * i + 1] = position.getY(i);
    positions[3 * i + 2] = position.getZ(i);
  }
  return positions;
}
