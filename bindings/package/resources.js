// SPDX-License-Identifier: MIT
// Which files a file refers to, by the names it uses for them: what the command line reads from
// beside its input. Files that cannot be understood refer to none; the core says what is wrong.

const glbMagic = 0x46546c67;
const glbHeaderBytes = 12;
const chunkHeaderBytes = 8;

/** @param {Uint8Array} bytes */
function asText(bytes) {
  return new TextDecoder().decode(bytes);
}

/** The JSON of a glTF or GLB. @param {Uint8Array} bytes */
function gltfJson(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < glbHeaderBytes + chunkHeaderBytes || view.getUint32(0, true) !== glbMagic) {
    return asText(bytes);
  }
  const begin = glbHeaderBytes + chunkHeaderBytes;
  return asText(bytes.subarray(begin, begin + view.getUint32(glbHeaderBytes, true)));
}

/** @param {Uint8Array} bytes @returns {string[]} */
function gltfReferences(bytes) {
  const { buffers = [], images = [] } = JSON.parse(gltfJson(bytes));
  return [...buffers, ...images]
    .map(({ uri }) => uri)
    .filter((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
}

/** @param {Uint8Array} bytes @returns {string[]} */
function objReferences(bytes) {
  const references = asText(bytes).matchAll(/^[ \t]*mtllib[ \t]+(.+?)[ \t]*\r?$/gm);
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
