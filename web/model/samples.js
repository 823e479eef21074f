// SPDX-License-Identifier: MIT
// The built-in models. The build writes them as files beside the page (sample_files.js), so they
// need no network. Their titles and origins are sample.ID and origin.ID in the texts.

/** vertices: a target that shows well what remeshing does.
 * @typedef {{ id: 'bunny' | 'gear' | 'scan' | 'vase' | 'teapot', file: string,
 *   vertices: number }} Sample */

/** @type {Sample[]} The page opens the first sample if its address names no model. */
export const samples = [
  { id: 'bunny', file: 'bunny.obj', vertices: 3000 },
  { id: 'gear', file: 'gear.obj', vertices: 4000 },
  { id: 'scan', file: 'scan.obj', vertices: 2500 },
  { id: 'vase', file: 'vase.glb', vertices: 2000 },
  { id: 'teapot', file: 'teapot.obj', vertices: 4000 },
];

/** @param {string | null} id */
export const sampleOf = (id) => samples.find((sample) => sample.id === id);
