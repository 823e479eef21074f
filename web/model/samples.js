// SPDX-License-Identifier: MIT
// The built-in models, in the public domain, that come from npm packages. The build turns them into
// files beside the page (sample_files.js), so they need no network.

/** vertices: a target that shows what remeshing does for it.
 * @typedef {{ id: string, title: string, file: string, vertices: number }} Sample */

/** @type {Sample[]} The first one greets the visitor. */
export const samples = [
  { id: 'bunny', title: 'Bunny', file: 'bunny.obj', vertices: 3000 },
  { id: 'teapot', title: 'Teapot', file: 'teapot.obj', vertices: 4000 },
];
