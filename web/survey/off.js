// SPDX-License-Identifier: MIT
// The vertices of an OFF file, in their order: the order in which the core counts them.

/** @param {Uint8Array} bytes with texture coordinates or without @returns {Float32Array} */
export function offVertices(bytes) {
  const lines = new TextDecoder().decode(bytes).split('\n');
  const count = Number(lines[1].split(' ')[0]);
  const positions = new Float32Array(3 * count);
  for (let v = 0; v < count; ++v) {
    positions.set(lines[2 + v].split(' ', 3).map(Number), 3 * v);
  }
  return positions;
}
