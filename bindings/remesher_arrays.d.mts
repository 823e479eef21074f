// SPDX-License-Identifier: MIT
// The same of the engine for arrays.
export { default } from './remesher.mjs';
