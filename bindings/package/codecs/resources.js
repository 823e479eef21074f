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

/**
 * Without the blanks around it: a regular expression would take time squared.
 * @param {string} line
 */
function trimmed(line) {
  const isBlank = (/** @type {number} */ at) => ' \t\v\f'.includes(line.charAt(at));
  let [begin, end] = [0, line.length];
  while (begin < end && isBlank(begin)) begin += 1;
  while (end > begin && isBlank(end - 1)) end -= 1;
  return line.slice(begin, end);
}

/** @param {Uint8Array} bytes @returns {string[]} */
function objReferences(bytes) {
  const references = new TextDecoder().decode(bytes).matchAll(/^[ \t]*mtllib[ \t](.*)$/gm);
  return Array.from(references, ([, rest]) => trimmed(rest)).filter(Boolean);
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
