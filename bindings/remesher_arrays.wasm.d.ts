// SPDX-License-Identifier: MIT
// The engine for arrays as a file: bundlers' loaders for files make its address of it, for
// `init({ arrays: { wasmUrl } })`.
declare const url: string;
export default url;
