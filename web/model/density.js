// SPDX-License-Identifier: MIT
// Density as it is painted: dabs of a round brush, each adding to or taking from the level around a
// point. A level is a power of two: at level 1 twice as many vertices as at level 0.

/** radius in model units; strength in levels, at the middle; 0 wipes towards level 0.
 * @typedef {{ point: [number, number, number], radius: number, strength: number }} Dab */

/** Levels are at most this far from 0. */
export const largestLevel = 3;

/** How much of a dab arrives, from 1 in the middle smoothly to 0 at the rim.
 * @param {number} share squared distance over squared radius */
const falloff = (share) => (1 - share) ** 2;

/** @param {Float32Array} levels for each vertex: they are changed
 * @param {Float32Array} positions @param {Dab} dab */
export function applyDab(levels, positions, { point: [x, y, z], radius, strength }) {
  const squared = radius * radius;
  for (let v = 0; v < levels.length; ++v) {
    const [dx, dy, dz] = [positions[3 * v] - x, positions[3 * v + 1] - y, positions[3 * v + 2] - z];
    const share = (dx * dx + dy * dy + dz * dz) / squared;
    if (share >= 1) continue;
    const level = strength ? levels[v] + strength * falloff(share)
      : levels[v] * (1 - falloff(share));
    levels[v] = Math.max(-largestLevel, Math.min(largestLevel, level));
  }
}

/** The level at each vertex. @param {Float32Array} positions @param {readonly Dab[]} dabs */
export function levelsOf(positions, dabs) {
  const levels = new Float32Array(positions.length / 3);
  for (const dab of dabs) applyDab(levels, positions, dab);
  return levels;
}

/** What the option `density` takes. @param {Float32Array} levels */
export const densityOf = (levels) => levels.map((level) => 2 ** level);

/** The same dab on the other side of the plane at x.
 * @param {Dab} dab @param {number} x @returns {Dab} */
export const mirrored = ({ point: [px, py, pz], ...rest }, x) =>
  ({ point: [2 * x - px, py, pz], ...rest });
