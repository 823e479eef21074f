// SPDX-License-Identifier: MIT
// Makes a main file call its companions by other names, for the moment in which they are somewhere
// else.

/** @param {string} reference */
function decoded(reference) {
  try {
    return decodeURIComponent(reference);
  } catch {
    return reference;
  }
}

/** @typedef {ReadonlyMap<string, string>} Names old → new, from the main file's folder */

/** @param {Uint8Array} bytes @param {Names} names */
function inGltf(bytes, names) {
  const tree = JSON.parse(new TextDecoder().decode(bytes));
  let count = 0;
  for (const holder of [...tree.buffers ?? [], ...tree.images ?? []]) {
    const name = names.get(decoded(holder.uri ?? ''));
    if (name === undefined) continue;
    holder.uri = encodeURIComponent(name);
    count += 1;
  }
  return count > 0 ? Buffer.from(JSON.stringify(tree)) : undefined;
}

/** Each name in a line of its own, after a word. @param {Uint8Array} bytes @param {Names} names */
function inLines(bytes, names) {
  const text = Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (const [old, name] of names) {
    for (const word of ['mtllib', 'comment TextureFile']) {
      const line = Buffer.from(`${word} ${old}\n`);
      const at = text.indexOf(line);
      if (at < 0) continue;
      return Buffer.concat([text.subarray(0, at), Buffer.from(`${word} ${name}\n`),
        text.subarray(at + line.length)]);
    }
  }
  return undefined;
}

/**
 * Undefined: it names none of them.
 * @param {{ place: string, bytes: Uint8Array }} main
 * @param {Names} names
 * @returns {Uint8Array | undefined}
 */
export function withOtherNames({ place, bytes }, names) {
  if (names.size === 0) return undefined;
  return /\.gltf$/i.test(place) ? inGltf(bytes, names) : inLines(bytes, names);
}
