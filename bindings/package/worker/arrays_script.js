// SPDX-License-Identifier: MIT
// The JavaScript that the small engine calls.

export { default as createInstance } from '../remesher_arrays.mjs';
