// SPDX-License-Identifier: MIT
// What the small engine needs of JavaScript.

export { default as createInstance } from '../remesher_arrays.mjs';
