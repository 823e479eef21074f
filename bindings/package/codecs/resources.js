// SPDX-License-Identifier: MIT
// Which files a file refers to, by the names it uses for them: what the command line reads from
// beside its input. Files that cannot be understood refer to none; the core says what is wrong.

import { openContainer } from './gltf_container.js';

/** @param {Uint8Array} bytes @returns {string[]} */
function gltfReferences(bytes) {
  const { buffers = [], images = [] } = JSON.parse(openContainer(bytes).text);
  return [...buffers, ...images]
    .map(({ uri }) => uri)
    .filter((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
}

/** @param {Uint8Array} bytes @returns {string[]} */
function objReferences(bytes) {
  const text = new TextDecoder().decode(bytes);
  const references = text.matchAll(/^[ \t]*mtllib[ \t]+(.+?)[ \t]*\r?$/gm);
  return [...references].map(([, name]) => name);
}

/**
 * @param {string} name
 * @param {Uint8Array} bytes
 * @returns {string[]}
 */
export function referencesOf(name, bytes) {
  try {
    if (/\.gl(b|tf)$/i.test(name)) return gltfReferences(bytes);
    if (/\.obj$/i.test(name)) return objReferences(bytes);
  } catch {
    return [];
  }
  return [];
}
