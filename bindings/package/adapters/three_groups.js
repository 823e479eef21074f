// SPDX-License-Identifier: MIT
// The groups of a geometry in three.js are ranges of its index, each with a material; they may
// overlap, and leave triangles out. Here a triangle is in one set: that of the materials it is
// drawn with. The border between two sets is kept.

/** @import { BufferGeometry } from 'three' */

/**
 * @typedef {object} MaterialSet
 * @property {number[]} materials of its triangles, as the geometry numbers them; empty: in no group
 * @property {[number, number][]} ranges of the index: the first and the one after the last
 */

/**
 * Sets in the order of their first triangles, within the range that is drawn.
 * @param {BufferGeometry} geometry
 * @param {number} length of its index
 * @returns {MaterialSet[]}
 */
export function materialSets({ groups, drawRange }, length) {
  const first = Math.min(Math.max(drawRange.start, 0), length);
  const count = Math.floor((Math.min(first + drawRange.count, length) - first) / 3) * 3;
  const last = first + Math.max(count, 0);
  /** @param {number} at */
  const wholeTriangles = (at) =>
    first + 3 * Math.round((Math.min(Math.max(at, first), last) - first) / 3);
  const ranges = groups.map(({ start, count: size, materialIndex = 0 }) =>
    ({ from: wholeTriangles(start), to: wholeTriangles(start + size), materialIndex }));
  const cuts = [...new Set([first, last, ...ranges.flatMap(({ from, to }) => [from, to])])]
    .sort((a, b) => a - b);
  /** @type {Map<string, MaterialSet>} */
  const sets = new Map();
  for (let i = 0; i + 1 < cuts.length; i += 1) {
    const materials = ranges.filter(({ from, to }) => from <= cuts[i] && to >= cuts[i + 1])
      .map(({ materialIndex }) => materialIndex);
    const known = sets.get(materials.join()) ?? { materials, ranges: [] };
    known.ranges.push([cuts[i], cuts[i + 1]]);
    sets.set(materials.join(), known);
  }
  return [...sets.values()];
}

/**
 * Gives a geometry the groups of sets whose triangles lie one behind another in its index.
 * @param {BufferGeometry} geometry
 * @param {{ materials: number[], length: number }[]} runs
 */
export function addGroups(geometry, runs) {
  let start = 0;
  for (const { materials, length } of runs) {
    for (const material of length > 0 ? materials : []) {
      const before = geometry.groups.find((group) =>
        group.materialIndex === material && group.start + group.count === start);
      if (before) before.count += length;
      else geometry.addGroup(start, length, material);
    }
    start += length;
  }
}
