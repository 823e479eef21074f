// SPDX-License-Identifier: MIT
// Reads the bytes of a written file, without the engine, so that a fault of the engine's own
// readers and figures cannot hide. Names decide about the format, for the files are our own.
import { gunzipSync } from 'node:zlib';

import { readPly, readStl } from './read_binary.js';
import { readGltf } from './read_gltf.js';
import { readObj, readOff } from './read_text.js';

/** @typedef {import('./read_text.js').FacePart} FacePart */

const textOf = (/** @type {Uint8Array} */ bytes) => new TextDecoder().decode(bytes);

/**
 * A part with its faces as triangles too: polygons become fans.
 * @param {FacePart} part
 */
export function triangulated(part) {
  const triangles = [];
  for (const face of part.faces) {
    for (let k = 2; k < face.length; k += 1) triangles.push(face[0], face[k - 1], face[k]);
  }
  return { ...part, triangles: Uint32Array.from(triangles),
    quads: part.faces.filter(({ length }) => length === 4).length };
}

/**
 * @param {Uint8Array} bytes
 * @param {{ name: string, resources?: Record<string, Uint8Array> }} file
 * @returns {{ parts: any[], levels: any[][], materials?: Set<string> }} parts with `positions`,
 *   `faces`, `triangles` and the number of `quads`, in the world
 */
export function readFile(bytes, { name, resources }) {
  if (/\.gz$/i.test(name)) {
    return readFile(gunzipSync(bytes), { name: name.replace(/\.gz$/i, ''), resources });
  }
  const extension = name.toLowerCase().split('.').at(-1);
  const readers = { obj: () => readObj(textOf(bytes)), off: () => readOff(textOf(bytes)),
    ply: () => readPly(bytes), stl: () => readStl(bytes), glb: () => readGltf(bytes, resources),
    gltf: () => readGltf(bytes, resources) };
  if (!readers[extension]) throw new Error(`no reader for .${extension}`);
  const { parts, levels = [], ...rest } = readers[extension]();
  return { ...rest, parts: parts.map(triangulated),
    levels: levels.map((level) => level.map(triangulated)) };
}
