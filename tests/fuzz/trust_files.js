// SPDX-License-Identifier: MIT
// Surfaces as files for the laws of trust: every format of the other cases, OBJ whose numbers are
// those of the surface to the last bit, OBJ of quads, and scenes.
import { files } from './made_files.js';
import { scenes } from './made_scenes.js';

/** @typedef {import('./made_shapes.js').Shape} Shape */

/** @param {string} name @param {string} text */
const written = (name, text) => ({ name, bytes: new TextEncoder().encode(text) });

/** Positions and faces, nothing else. @param {number[][]} positions @param {number[][]} faces */
export function objFile(positions, faces) {
  return written('made.obj', [...positions.map((p) => `v ${p.join(' ')}`),
    ...faces.map((face) => `f ${face.map((v) => v + 1).join(' ')}`), ''].join('\n'));
}

/** Quads where two successive triangles are halves of one, else triangles. @param {Shape} shape */
export function pairedFaces({ triangles }) {
  const faces = [];
  for (let i = 0; i < triangles.length; i += 1) {
    const [a, b, c] = triangles[i];
    const [d, e, f] = triangles[i + 1] ?? [];
    if (d === a && e === c && f !== b) {
      faces.push([a, b, c, f]);
      i += 1;
    } else faces.push([a, b, c]);
  }
  return faces;
}

/** For each kind: writes a surface as a file.
 * @type {Record<string, (shape: Shape) => any>} */
export const trustFiles = {
  'obj of numbers': ({ positions, triangles }) => objFile(positions, triangles),
  'obj of quads': (shape) => objFile(shape.positions, pairedFaces(shape)),
  ...Object.fromEntries(['plain', 'textured', 'quantized', 'instanced', 'obj', 'off', 'ply',
    'ply in text', 'ply of the other order', 'stl', 'stl in text'].map((kind) =>
    [kind, files[kind]])),
  ...Object.fromEntries(['uneven', 'halves'].map((kind) => [kind, scenes[kind]])),
};
