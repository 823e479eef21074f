// SPDX-License-Identifier: MIT
// Cases of spoilt compressed glTF. The decoders are JavaScript and WebAssembly of others, so they
// are fuzzed here and not by a native target.
import { RemeshError } from 'remesher';

import { decompress } from '../../dist/codecs/decompress.js';
import { dracoCompressed, meshoptCompressed } from '../support/compressed.js';
import { Dice } from './dice.js';
import { files, meshOf } from './made_files.js';
import { shapes } from './made_shapes.js';
import { spoilFile } from './mutations.js';

const shape = shapes.ball(2);
const { positions, indices, attributes } = meshOf(shape);

export const meshopt = await meshoptCompressed(files.textured(shape));
export const draco =
  await dracoCompressed({ positions, indices, texcoords: attributes.TEXCOORD_0.array });

/** The broken laws of a case: a file must be decoded, or refused in a sentence of our own. */
export async function runCompressedCase(/** @type {number} */ seed) {
  const dice = new Dice(seed);
  let file = dice.pick([meshopt, draco]);
  for (let times = dice.whole(1, 3); times > 0; times -= 1) file = spoilFile(file, dice, []);
  try {
    await decompress({ ...file, resources: [] });
  } catch (error) {
    const isOurs = error instanceof RemeshError && /\.$/.test(error.message)
      && !/undefined|memory access|divide by zero|Cannot/.test(error.message);
    if (!isOurs) return [`${seed}: ${error.stack}`];
  }
  return [];
}
