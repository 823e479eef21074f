// SPDX-License-Identifier: MIT
// The bytes of glTF's buffers and of the buffer views in them.

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';

/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */

/** @param {string} path */
const baseName = (path) => path.slice(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);

/** A malformed URI stays as it is. @param {string} uri */
export function percentDecoded(uri) {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

/**
 * A function that finds what a URI means among the files given: a file may name thousands.
 * @param {NamedBytes[]} resources
 */
function finderAmong(resources) {
  /** @type {Map<string, NamedBytes>} */
  const exact = new Map();
  /** @type {Map<string, NamedBytes | undefined>} */
  const alike = new Map();
  for (const file of resources) {
    if (!exact.has(file.name)) exact.set(file.name, file);
    const base = baseName(file.name);
    alike.set(base, alike.has(base) ? undefined : file);
  }
  return (/** @type {string} */ uri) => {
    const decoded = percentDecoded(uri);
    return exact.get(uri) ?? exact.get(decoded) ?? alike.get(baseName(decoded));
  };
}

/** @param {string} uri */
function decodeDataUri(uri) {
  const [head, data] = [uri.slice(0, uri.indexOf(',')), uri.slice(uri.indexOf(',') + 1)];
  if (!head.endsWith(';base64')) return new TextEncoder().encode(decodeURIComponent(data));
  return Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
}

/**
 * The bytes of each buffer; none for buffers that only stand in for compressed data.
 * @param {any} tree
 * @param {Uint8Array | undefined} chunk
 * @param {{ name: string, resources: NamedBytes[] }} file
 * @returns {Uint8Array[]}
 */
export function loadBuffers(tree, chunk, file) {
  const find = finderAmong(file.resources);
  return (tree.buffers ?? []).map((/** @type {any} */ { uri }, /** @type {number} */ i) => {
    if (uri === undefined) return i === 0 && chunk ? chunk : new Uint8Array();
    if (uri.startsWith('data:')) return decodeDataUri(uri);
    const resource = find(uri);
    if (!resource) {
      throw new RemeshError('MISSING_RESOURCE',
        `${legible(file.name)}: it needs ${legible(uri)}, which was not given.`,
        `Keep ${legible(uri)} beside the file, or give both together.`);
    }
    return resource.bytes;
  });
}

/**
 * @param {Uint8Array} bytes
 * @param {{ byteOffset?: number, byteLength: number }} view
 */
export function slice(bytes, { byteOffset = 0, byteLength }) {
  if (![byteOffset, byteLength].every(Number.isInteger)) throw new TypeError('not a range');
  const isInside = byteOffset >= 0 && byteLength >= 0 && byteOffset + byteLength <= bytes.length;
  if (!isInside) throw new Error('a range reaches beyond its buffer');
  return bytes.subarray(byteOffset, byteOffset + byteLength);
}

/**
 * All buffer views in one buffer.
 * @param {any} tree
 * @param {Uint8Array[]} contents per buffer view
 * @returns {Uint8Array}
 */
export function joinBuffers(tree, contents) {
  const alignment = 8;
  let length = 0;
  contents.forEach((bytes, i) => {
    Object.assign(tree.bufferViews[i],
      { buffer: 0, byteOffset: length, byteLength: bytes.length });
    length += Math.ceil(bytes.length / alignment) * alignment;
  });
  const joined = new Uint8Array(length);
  contents.forEach((bytes, i) => joined.set(bytes, tree.bufferViews[i].byteOffset));
  tree.buffers = [{ byteLength: length }];
  return joined;
}
