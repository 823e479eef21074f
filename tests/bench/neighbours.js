// SPDX-License-Identifier: MIT
// How near and how even a result is changes with every vertex more: a figure of one number of
// vertices is chance. Figures here are of seven neighbouring numbers: their median, and the worst.
import { median } from './yardstick.js';

/** Neighbours are so many vertices of a thousand apart. */
const steps = [-9, -6, -3, 0, 3, 6, 9];

/** Seven numbers within 1 % of one. @param {number} vertices */
export const neighboursOf = (vertices) =>
  steps.map((step) => Math.round(vertices * (1 + step / 1000)));

/** Whether more of a figure is better. */
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
