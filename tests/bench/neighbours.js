// SPDX-License-Identifier: MIT
// A result's distances and angles change with every vertex more, so figures at a single number of
// vertices are chance. Here figures are the median and the worst of seven neighbouring numbers.
import { median } from './yardstick.js';

/** Differences of the neighbours, in thousandths of the number of vertices. */
const steps = [-9, -6, -3, 0, 3, 6, 9];

/** Seven numbers within 1 % of `vertices`. @param {number} vertices */
export const neighboursOf = (vertices) =>
  steps.map((step) => Math.round(vertices * (1 + step / 1000)));

/** The figures of which more is better. */
const moreIsBetter = new Set(['above50', 'meanAngle', 'worstAngle', 'valence6']);

/**
 * @param {Record<string, number>[]} all figures, by name, of each of several results
 * @returns {Record<string, { median: number, worst: number }>}
 */
export function summed(all) {
  return Object.fromEntries(Object.keys(all[0]).map((name) => {
    const values = all.map((figures) => figures[name]);
    const worst = moreIsBetter.has(name) ? Math.min(...values) : Math.max(...values);
    return [name, { median: median(values), worst }];
  }));
}
