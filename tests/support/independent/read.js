// SPDX-License-Identifier: MIT
// Reads the bytes of a written file, without the engine, so that a fault of the engine's own
// readers and figures cannot hide. Names decide about the format, for the files are our own.
import { gunzipSync } from 'node:zlib';

import { cutByEars } from './ears.js';
import { readPly, readStl } from './read_binary.js';
import { readGltf } from './read_gltf.js';
import { readObj, readOff } from './read_text.js';

/** @typedef {import('./read_text.js').FacePart} FacePart */

const textOf = (/** @type {Uint8Array} */ bytes) => new TextDecoder().decode(bytes);

/**
 * A face that begins at an end of its shorter diagonal, if it has four corners: no file says along
 * which of the two a bent one is to be cut.
 * @param {ArrayLike<number>} positions @param {number[]} face
 */
function fromShorter(positions, face) {
  if (face.length !== 4) return face;
  const square = (/** @type {number} */ a, /** @type {number} */ b) => [0, 1, 2].reduce((sum, k) =>
    sum + (positions[3 * face[a] + k] - positions[3 * face[b] + k]) ** 2, 0);
  return square(1, 3) < square(0, 2) * (1 - 1e-6) ? [...face.slice(1), face[0]] : face;
}

/**
 * A part with its faces as triangles too, and the numbers of its faces with four and more corners.
 * @param {FacePart} part @param {boolean} [isShorter] whether quads are cut along shorter diagonals
 */
export function triangulated(part, isShorter = false) {
  const triangles = [];
  const faces = isShorter ? part.faces.map((face) => fromShorter(part.positions, face))
    : part.faces;
  for (const face of faces) {
    if (face.length > 4) triangles.push(...cutByEars(part.positions, face));
    else for (let k = 2; k < face.length; k += 1) triangles.push(face[0], face[k - 1], face[k]);
  }
  return { ...part, triangles: Uint32Array.from(triangles),
    quads: part.faces.filter(({ length }) => length === 4).length,
    polygons: part.faces.filter(({ length }) => length > 4).length };
}

/**
 * @param {Uint8Array} bytes
 * @param {{ name: string, resources?: Record<string, Uint8Array>, isShorter?: boolean }} file
 *   isShorter: whether quads are cut along their shorter diagonals, as runs of quads do
 * @returns {{ parts: any[], levels: any[][], materials?: Set<string> }} parts with `positions`,
 *   `faces`, `triangles` and the number of `quads`, in the world
 */
export function readFile(bytes, { name, resources, isShorter }) {
  if (/\.gz$/i.test(name)) {
    return readFile(gunzipSync(bytes), { name: name.replace(/\.gz$/i, ''), resources, isShorter });
  }
  const extension = name.toLowerCase().split('.').at(-1);
  const readers = { obj: () => readObj(textOf(bytes)), off: () => readOff(textOf(bytes)),
    ply: () => readPly(bytes), stl: () => readStl(bytes), glb: () => readGltf(bytes, resources),
    gltf: () => readGltf(bytes, resources) };
  if (!readers[extension]) throw new Error(`no reader for .${extension}`);
  const { parts, levels = [], ...rest } = readers[extension]();
  const cut = (/** @type {FacePart} */ part) => triangulated(part, isShorter);
  return { ...rest, parts: parts.map(cut), levels: levels.map((level) => level.map(cut)) };
}
