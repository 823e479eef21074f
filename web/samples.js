// SPDX-License-Identifier: MIT
// The built-in models: public domain scans that come from npm packages. The build turns them into
// files beside the page (sample_files.js), so they need no network.

/** @typedef {{ id: string, title: string, file: string }} Sample */

/** @type {Sample[]} The first one greets the visitor. */
export const samples = [
  { id: 'bunny', title: 'Bunny', file: 'bunny.obj' },
  { id: 'dragon', title: 'Dragon', file: 'dragon.obj' },
];
