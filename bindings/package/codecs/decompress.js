// SPDX-License-Identifier: MIT
// Compressed glTF becomes plain glTF before the core sees it: EXT_meshopt_compression (and its
// successor KHR_meshopt_compression) and KHR_draco_mesh_compression. The decoders are loaded when
// the first file needs them. The result is a GLB whatever the file was: all its buffers in one.

import { joinBuffers, loadBuffers, slice } from './buffer_views.js';
import { requireDistinct, requireHolds, requireLength } from './claims.js';
import { settleAccessors } from './decoded_accessors.js';
import { decodeDracoPrimitives, dracoExtension } from './draco.js';
import { isGltf } from '../base/contents.js';
import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { openContainer, packGlb } from './gltf_container.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */

const meshoptExtensions = ['EXT_meshopt_compression', 'KHR_meshopt_compression'];
const compressions = [...meshoptExtensions, dracoExtension];

/** The sizes of elements that each mode and filter knows: the decoder itself trusts them. */
const isStride = /** @type {Record<string, (stride: number) => boolean>} */ ({
  ATTRIBUTES: (stride) => stride % 4 === 0 && stride <= 256,
  TRIANGLES: (stride) => stride === 2 || stride === 4,
  INDICES: (stride) => stride === 2 || stride === 4,
  NONE: () => true,
  OCTAHEDRAL: (stride) => stride === 4 || stride === 8,
  QUATERNION: (stride) => stride === 8,
  EXPONENTIAL: (stride) => stride % 4 === 0,
  COLOR: (stride) => stride === 4 || stride === 8,
});

/** @param {{ count: any, byteStride: any, mode: any, filter: any }} layout */
function checkLayout({ count, byteStride, mode, filter }) {
  const isKnown = [mode, filter].every((name) => Object.hasOwn(isStride, name));
  const areWhole = Number.isInteger(count) && count >= 0
    && Number.isInteger(byteStride) && byteStride > 0;
  const fits = isKnown && areWhole && isStride[mode](byteStride) && isStride[filter](byteStride);
  if (!fits || (mode === 'TRIANGLES' && count % 3 !== 0)) {
    throw new Error('a compressed range is laid out as none can be');
  }
}

/**
 * The bytes that each buffer view shows, decompressed.
 * @param {any} tree
 * @param {Uint8Array[]} buffers
 * @returns {Promise<Uint8Array[]>}
 */
async function loadBufferViews(tree, buffers) {
  const decoded = [];
  const given = buffers.reduce((sum, { length }) => sum + length, 0);
  let used = 0;
  for (const view of tree.bufferViews ?? []) {
    const name = meshoptExtensions.find((extension) => view.extensions?.[extension]);
    if (!name) {
      decoded.push(slice(buffers[view.buffer], view));
      continue;
    }
    const { buffer, count, byteStride, mode, filter = 'NONE', ...range } = view.extensions[name];
    checkLayout({ count, byteStride, mode, filter });
    const packed = slice(buffers[buffer], range);
    requireHolds({ count, byteStride, mode }, packed.length);
    used += packed.length;
    requireDistinct(used, given);
    const { MeshoptDecoder } = await import('../meshopt_decoder.mjs');
    await MeshoptDecoder.ready;
    const target = new Uint8Array(count * byteStride);
    MeshoptDecoder.decodeGltfBuffer(target, count, byteStride, packed, mode, filter);
    decoded.push(target);
    removeExtension(view, name);
  }
  return decoded;
}

/** Which buffer views are compressed. @param {any} tree @returns {Set<number>} */
function compressedViews({ bufferViews = [] }) {
  const isCompressed = (/** @type {any} */ { extensions }) =>
    meshoptExtensions.some((name) => extensions?.[name]);
  return new Set([...bufferViews.keys()].filter((i) => isCompressed(bufferViews[i])));
}

/** @param {any} object @param {string} name */
function removeExtension(object, name) {
  delete object.extensions[name];
  if (Object.keys(object.extensions).length === 0) delete object.extensions;
}

/** @param {any} tree */
function forgetCompressions(tree) {
  for (const list of ['extensionsUsed', 'extensionsRequired']) {
    if (!tree[list]) continue;
    tree[list] = tree[list].filter((/** @type {string} */ name) => !compressions.includes(name));
    if (tree[list].length === 0) delete tree[list];
  }
}

/**
 * Why decoding failed, for people: a TypeError speaks to programmers, and a number or a trap that a
 * decoder throws from its inside speaks to nobody.
 * @param {unknown} error
 */
function reason(error) {
  if (!(error instanceof Error) || error instanceof WebAssembly.RuntimeError) {
    return 'the decoder cannot make sense of it';
  }
  const isPlain = !(error instanceof TypeError || error instanceof RangeError);
  return isPlain
    ? legible(error.message.replace(/\.$/, '')) : 'the JSON does not say rightly what it is';
}

/**
 * @param {any} tree
 * @param {Uint8Array | undefined} chunk
 * @param {FileRequest} file
 */
async function decompressTree(tree, chunk, file) {
  try {
    const buffers = loadBuffers(tree, chunk, file);
    const decoded = compressedViews(tree);
    const contents = await loadBufferViews(tree, buffers);
    settleAccessors(tree, contents, decoded);
    await decodeDracoPrimitives(tree, contents);
    forgetCompressions(tree);
    requireLength(contents.reduce((sum, { length }) => sum + length, 0),
      buffers.reduce((sum, { length }) => sum + length, 0));
    return packGlb(tree, joinBuffers(tree, contents));
  } catch (error) {
    if (error instanceof RemeshError) throw error;
    throw new RemeshError('PARSE_ERROR',
      `${legible(file.name)}: its compressed data cannot be decoded: ${reason(error)}.`,
      'Was it copied completely?', { cause: error });
  }
}

/** The JSON pointer to a number of a tree that is not finite. @param {any} tree */
function endlessNumber(tree) {
  const waiting = [{ at: '', value: tree }];
  for (const { at, value } of waiting) {
    if (typeof value === 'number' && !Number.isFinite(value)) return at;
    if (typeof value !== 'object' || value === null) continue;
    for (const [key, part] of Object.entries(value))
      if (typeof part !== 'string') waiting.push({ at: `${at}/${key}`, value: part });
  }
  return undefined;
}

/**
 * Parses the text. A number beyond all that can be read becomes infinite, and would be written as
 * null.
 * @param {string} text @param {FileRequest} file
 */
function parseTree(text, { name }) {
  const tree = JSON.parse(text);
  const at = endlessNumber(tree);
  if (at === undefined) return tree;
  throw new RemeshError('PARSE_ERROR', `${legible(name)}: the glTF document is invalid: `
    + `${legible(at)} is a number beyond all that can be read.`, 'Correct that number.');
}

/**
 * The file without compression; the same object if it has none or cannot be understood.
 * @param {FileRequest} file
 * @returns {Promise<FileRequest>}
 */
export async function decompress(file) {
  if (!isGltf(file.bytes)) return file;
  const { text, chunk } = openContainer(file.bytes);
  if (!compressions.some((name) => text.includes(`"${name}"`))) return file;
  let tree;
  try {
    tree = parseTree(text, file);
  } catch (error) {
    if (error instanceof RemeshError) throw error;
    return file;
  }
  return { ...file, bytes: await decompressTree(tree, chunk, file) };
}
