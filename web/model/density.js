// SPDX-License-Identifier: MIT
// Painted density: each dab of a round brush raises or lowers the level around a point. The density
// is two to the power of the level: level 1 means twice as many vertices as level 0.

/** radius: in model units; strength: in levels, at the centre; 0 erases towards level 0.
 * @typedef {{ point: [number, number, number], radius: number, strength: number }} Dab */

/** Levels are at most this far from 0. */
export const largestLevel = 3;

/** @param {any} dab @returns {dab is Dab} */
const isDab = (dab) => Array.isArray(dab?.point) && dab.point.length === 3
  && [...dab.point, dab.radius, dab.strength].every(Number.isFinite) && dab.radius > 0;

/** Whether a value is a list of dabs. @param {unknown} value @returns {value is Dab[]} */
export const areDabs = (value) => Array.isArray(value) && value.every(isDab);

/** The weight of a dab, falling smoothly from 1 at the centre to 0 at the rim.
 * @param {number} share squared distance over squared radius */
const falloff = (share) => (1 - share) ** 2;

/** @param {Float32Array} levels of the vertices, changed in place
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

/** The values for the option `density`. @param {Float32Array} levels */
export const densityOf = (levels) => levels.map((level) => 2 ** level);

/** The dab mirrored in the plane at x.
 * @param {Dab} dab @param {number} x @returns {Dab} */
export const mirrored = ({ point: [px, py, pz], ...rest }, x) =>
  ({ point: [2 * x - px, py, pz], ...rest });
