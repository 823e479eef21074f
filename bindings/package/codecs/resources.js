// SPDX-License-Identifier: MIT
// The names of the files that a file refers to: the command line reads these from beside its input.
// Files that cannot be understood refer to none; the core says what is wrong.

import { isGltf, isObj } from '../base/contents.js';
import { openContainer } from './gltf_container.js';

/** @param {Uint8Array} bytes @returns {string[]} */
function gltfReferences(bytes) {
  const { buffers = [], images = [] } = JSON.parse(openContainer(bytes).text);
  return [...buffers, ...images]
    .map(({ uri }) => uri)
    .filter((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
}

/**
 * The line without the blanks around it. A regular expression would take quadratic time.
 * @param {string} line
 */
function trimmed(line) {
  const isBlank = (/** @type {number} */ at) => ' \t\v\f'.includes(line.charAt(at));
  let [begin, end] = [0, line.length];
  while (begin < end && isBlank(begin)) begin += 1;
  while (end > begin && isBlank(end - 1)) end -= 1;
  return line.slice(begin, end);
}

/**
 * What stands behind mtllib is one name, which may have blanks, or several.
 * @param {string} text of an OBJ @returns {string[]}
 */
function librariesIn(text) {
  const references = Array.from(text.matchAll(/^[ \t]*mtllib[ \t](.*)$/gm),
    ([, rest]) => trimmed(rest));
  const names = references.flatMap((rest) => [rest, ...rest.split(/[ \t\v\f]+/)]);
  return [...new Set(names)].filter(Boolean);
}

const portion = 2 ** 20;

/**
 * The libraries of a long OBJ, which is not held as a whole.
 * @param {number} size
 * @param {import('../base/open_file.js').ReadBlock} read
 */
function librariesFar(size, read) {
  const decoder = new TextDecoder();
  const found = [];
  let rest = '';
  for (let at = 0; at < size; at += portion) {
    const bytes = new Uint8Array(Math.min(portion, size - at));
    if (!read(at, bytes)) return []; // the core says so
    const text = rest + decoder.decode(bytes, { stream: true });
    const end = Math.max(text.lastIndexOf('\n'), text.lastIndexOf('\r')) + 1;
    found.push(...librariesIn(text.slice(0, end)));
    rest = text.slice(end, end + portion);
  }
  return [...found, ...librariesIn(rest)];
}

/** The images that textures are painted from. @param {Uint8Array} bytes @returns {string[]} */
function mtlReferences(bytes) {
  const maps = new TextDecoder().decode(bytes)
    .matchAll(/^[ \t]*(?:map_Kd|map_Ke|map_Kn|norm)[ \t](.*)$/gm);
  return Array.from(maps, ([, rest]) => behindOptions(rest)).filter(Boolean);
}

/**
 * Offset, scale and turbulence have one to three numbers, -mm two words, other options one.
 * @param {string} statement
 */
function behindOptions(statement) {
  const isNumber = (/** @type {string | undefined} */ word) => /^[-+]*[.\d]/.test(word ?? '');
  let rest = trimmed(statement);
  const next = () => {
    const [word] = rest.split(/[ \t]/, 1);
    rest = trimmed(rest.slice(word.length));
    return word;
  };
  while (/^-[^ \t]/.test(rest)) {
    const option = next();
    if (!['-o', '-s', '-t'].includes(option)) {
      next();
      if (option === '-mm') next();
      continue;
    }
    for (let i = 0; i < 3 && isNumber(rest); i += 1) next();
  }
  return rest;
}

/**
 * What the bytes are decides, as in the core; libraries of materials are known by their names.
 * @param {string} name
 * @param {Uint8Array} bytes all of them, or the first
 * @param {{ size: number, read: import('../base/open_file.js').ReadBlock }} [blocks] the way to all
 * @returns {string[]}
 */
export function referencesOf(name, bytes, blocks) {
  try {
    if (/\.mtl$/i.test(name)) return mtlReferences(bytes);
    if (isGltf(bytes)) return gltfReferences(bytes);
    if (/\.obj$/i.test(name) || isObj(bytes)) {
      return blocks ? librariesFar(blocks.size, blocks.read)
        : librariesIn(new TextDecoder().decode(bytes));
    }
  } catch {
    return [];
  }
  return [];
}
