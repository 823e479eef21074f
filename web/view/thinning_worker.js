// SPDX-License-Identifier: MIT
// The worker that thins out the picture of a very large model, and keeps the model's surfaces.
import { joined } from '../triangles/soup.js';
import { thinnedGlb } from './thinned_glb.js';

/** @type {import('./thinned_glb.js').Whole[]} */
let wholes = [];

/** @param {{ glb: Uint8Array | Blob, most: number }} request */
async function thin({ glb, most }) {
  const bytes = glb instanceof Blob ? new Uint8Array(await glb.arrayBuffer()) : glb;
  const { wholes: found, ...answer } = await thinnedGlb(bytes, most);
  wholes = found;
  const buffers = answer.parts.map(({ kept }) => kept.buffer);
  return { answer, transfer: [answer.bytes.buffer, ...buffers] };
}

/** @param {{ whole: number, matrix: number[] }[]} places */
function soup(places) {
  const answer = joined(places.map(({ whole, matrix }) => ({ ...wholes[whole], matrix })));
  return { answer, transfer: [answer.positions.buffer, answer.indices.buffer] };
}

addEventListener('message', async ({ data }) => {
  try {
    const { answer, transfer } = Array.isArray(data) ? soup(data) : await thin(data);
    postMessage({ answer }, { transfer });
  } catch (error) {
    postMessage({ error: String(error) });
  }
});
