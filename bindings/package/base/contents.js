// SPDX-License-Identifier: MIT
// What a file is by its bytes, where that must be known before the core, which decides it in the
// same way (src/io/contents.h), sees the file: files are called by wrong names.

const beginOf = (/** @type {Uint8Array} */ bytes) =>
  new TextDecoder().decode(bytes.subarray(0, 65536)); // leaves out a byte order mark

/** Whether it may be glTF: a GLB, or JSON. @param {Uint8Array} bytes */
export function isGltf(bytes) {
  return /^(glTF|[ \t\r\n]*\{)/.test(beginOf(bytes));
}

/** Whether the first statement is one of OBJ's. @param {Uint8Array} bytes */
export function isObj(bytes) {
  const isEmpty = (/** @type {string} */ line) => /^[ \t\v\f]*(#|$)/.test(line);
  const statement = beginOf(bytes).split(/[\r\n]/).find((line) => !isEmpty(line)) ?? '';
  return /^[ \t\v\f]*(v|vt|vn|vp|f|l|p|o|g|s|mtllib|usemtl)[ \t]/.test(statement);
}
