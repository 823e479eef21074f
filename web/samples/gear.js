// SPDX-License-Identifier: MIT
// A mechanical part by formula: a gear with a hub and a bore. Its edges are sharp, and its
// triangles are long and thin, as CAD programs export them.

/** @typedef {{ positions: number[][], cells: number[][] }} PolygonMesh */

const teeth = 14;
/** Points of a tooth's outline: angle as a share of the pitch, and radius. */
const tooth = [[0, 1], [0.18, 1.22], [0.42, 1.22], [0.6, 1]];
const [bore, hub, halfPlate, halfHub] = [0.34, 0.58, 0.14, 0.27];

/** The closed section at one angle: radius and height of each corner. @param {number} outline */
const section = (outline) => [
  [bore, -halfHub], [hub, -halfHub], [hub, -halfPlate], [outline, -halfPlate],
  [outline, halfPlate], [hub, halfPlate], [hub, halfHub], [bore, halfHub],
];

/** @returns {PolygonMesh} */
export function gear() {
  const positions = [], cells = [];
  const angles = Array.from({ length: teeth }, (_, i) => tooth.map(([turn, radius]) =>
    ({ angle: 2 * Math.PI * (i + turn) / teeth, radius }))).flat();
  const around = section(1).length;
  for (const [i, { angle, radius }] of angles.entries()) {
    for (const [j, [r, height]] of section(radius).entries()) {
      positions.push([r * Math.cos(angle), r * Math.sin(angle), height]);
      const [k, next] = [(i + 1) % angles.length * around, (j + 1) % around];
      const [a, b, c, d] = [i * around + j, k + j, k + next, i * around + next];
      cells.push([a, b, c], [a, c, d]);
    }
  }
  return { positions, cells };
}
