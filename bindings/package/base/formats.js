// SPDX-License-Identifier: MIT
// The formats by their extensions: the same as in src/io/formats.cpp (a test compares them). Each
// that is read can be read from a `.gz` too.

export { isGltf, isObj } from './contents.js';

/** Those that are written; all but the last are read, too. */
export const formats = /** @type {const} */ ([
  'glb', 'gltf', 'obj', 'off', 'ply', 'stl', '3mf', 'msh', 'vtu', 'inp',
]);

export const readFormats = formats.slice(0, -1);

/** `a, b or c`. @param {readonly string[]} words */
export function inWords(words) {
  return `${words.slice(0, -1).join(', ')} or ${words[words.length - 1]}`;
}

/** The name of what is inside: `scan.ply` of `scan.ply.gz`. @param {string} name */
export function withoutGz(name) {
  return name.replace(/\.gz$/i, '');
}
