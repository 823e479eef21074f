// SPDX-License-Identifier: MIT
// The WebAssembly as a file: bundlers' loaders for files make its address of it, for
// `init({ wasmUrl })`.
declare const url: string;
export default url;
