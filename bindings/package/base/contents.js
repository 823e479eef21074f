// SPDX-License-Identifier: MIT
// The format of a file by its bytes, where it must be known before the core sees the file: names
// may be wrong. The core decides it in the same way (src/io/contents.h).

/** So many bytes at the beginning of a file show its format. */
export const bytesLooked = 65536;

const beginOf = (/** @type {Uint8Array} */ bytes) =>
  new TextDecoder().decode(bytes.subarray(0, bytesLooked)); // leaves out a byte order mark

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

const viewOf = (/** @type {Uint8Array} */ { buffer, byteOffset, byteLength }) =>
  new DataView(buffer, byteOffset, byteLength);

/** Where the JSON of a GLB ends; 0 in other files. @param {Uint8Array} begin */
const jsonEnd = (begin) => (begin.length >= 20 && beginOf(begin).startsWith('glTF')
  ? 20 + viewOf(begin).getUint32(12, true) : 0);

/** How many bytes at the beginning of a file JavaScript looks at: of a GLB all of its JSON, and the
 * head of the chunk behind it. @param {Uint8Array} begin */
export const bytesAsked = (begin) => Math.max(bytesLooked, jsonEnd(begin) + 8);

/** Whether JavaScript needs nothing of a GLB but its JSON: no data to decompress, and no images in
 * it. @param {Uint8Array} begin */
function isPlainGlb(begin) {
  const end = jsonEnd(begin);
  if (end === 0 || begin.length < end) return false;
  try {
    const { images = [], extensionsUsed = [] } =
      JSON.parse(new TextDecoder().decode(begin.subarray(20, end)));
    return !/meshopt|draco/.test(String(extensionsUsed))
      && images.every((/** @type {any} */ { bufferView }) => bufferView === undefined);
  } catch {
    return false;
  }
}

/** Whether nothing but the core needs more of a file than its beginning: JavaScript unpacks ZIP
 * (3MF) and gzip, and reads what of glTF is compressed or an image. @param {Uint8Array} begin */
export function isLeftToCore(begin) {
  const isZip = begin[0] === 0x50 && begin[1] === 0x4b;
  const isGzip = begin[0] === 0x1f && begin[1] === 0x8b;
  return !isZip && !isGzip && (!isGltf(begin) || isPlainGlb(begin));
}

/** Whether the core reads a file in blocks, without ever holding all of it: an OBJ, a binary STL,
 * as long as its number of facets says, a binary PLY, or a GLB without images.
 * @param {Uint8Array} begin @param {number} size */
export function isReadInBlocks(begin, size) {
  if (isObj(begin) || isPlainGlb(begin)) return true;
  if (begin.length <= 84 || isGltf(begin)) return false;
  const facets = viewOf(begin).getUint32(80, true);
  if (size === 84 + 50 * facets) return true;
  return /^ply\n(?:[^]*?\n)?format[ \t]+binary_[^]*?\nend_header\n/.test(
    beginOf(begin).replaceAll('\r\n', '\n').replaceAll('\r', '\n'));
}
