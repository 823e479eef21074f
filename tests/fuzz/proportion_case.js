// SPDX-License-Identifier: MIT
// The law "work in proportion": below 1,000 triangles no surface takes more than 30 times as long
// as a sphere of about 1,000 triangles with the same options, by processor time; and a file that
// claims more than its bytes can hold is refused at once.
import { inspect, remeshFile, repairFile } from 'remesher';

import { lawsOfErrors } from '../support/laws.js';
import { watch } from '../support/watch.js';
import { Dice } from './dice.js';
import { faultyBody, openSheet, soundBody } from './made_bodies.js';
import { shapes } from './made_shapes.js';
import { spoilShape } from './mutations.js';
import { trustFiles } from './trust_files.js';

const times = 30;

/** Seconds that no run needs a reason for. */
const floor = 2;

const optionSets = [
  { repair: 'auto' }, { repair: 'solid' }, { repair: 'wrap' }, { repair: 'holes' },
  { vertices: 300 }, { vertices: 300, repair: 'auto' }, { vertices: 300, scheme: 'rounds' },
  { vertices: 300, quads: true }, { quads: true, maxError: 1 }, { maxError: 0.1 },
  { vertices: 300, lods: [0.5, 0.25] }, { vertices: 300, textures: 'bake', textureSize: 64 },
  { vertices: 300, textures: 'bake', textureSize: 64, repair: 'solid' },
];

const isOnlyRepair = (/** @type {any} */ options) => Object.keys(options).join() === 'repair';

/** A surface of fewer than 1,000 triangles. @param {Dice} dice @param {string[]} said */
function smallShape(dice, said) {
  for (;;) {
    const { name, shape } = dice.pick([soundBody, openSheet, faultyBody, faultyBody])(dice);
    if (shape.triangles.length < 1000) {
      said.push(name);
      return shape;
    }
  }
}

/** @param {number} seed */
export function makeProportionCase(seed) {
  const dice = new Dice(seed);
  const said = [];
  let shape = smallShape(dice, said);
  for (let i = dice.whole(0, 2); i > 0; i -= 1) shape = spoilShape(shape, dice, said);
  const options = dice.pick(optionSets);
  const kind = options.textures ? 'textured' : 'obj of numbers';
  return { description: said.join(', '), options, kind, file: trustFiles[kind](shape) };
}

/** @param {any} file @param {any} options @param {number} limit in seconds */
async function secondsOf(file, options, limit) {
  const watched = watch(limit);
  const run = isOnlyRepair(options) ? repairFile : remeshFile;
  let broken = [];
  try {
    await run(file.bytes, { ...options, name: file.name, signal: watched.signal });
  } catch (error) {
    if (error?.name !== 'AbortError') broken = lawsOfErrors(error);
  }
  watched.stop();
  return { seconds: watched.seconds(), broken };
}

/** Seconds for the sphere, by its options. @type {Map<string, number>} */
const ofSphere = new Map();

async function sphereSeconds(options, kind) {
  const key = JSON.stringify(options);
  if (!ofSphere.has(key)) {
    const file = trustFiles[kind](shapes.ball(9));
    await secondsOf(file, options, 600); // compiles what the options need
    ofSphere.set(key, (await secondsOf(file, options, 600)).seconds);
  }
  return /** @type {number} */ (ofSphere.get(key));
}

/** The law of two times. @param {number} seconds @param {number} sphere of the sphere */
export function lawsOfTimes(seconds, sphere) {
  if (seconds <= Math.max(floor, times * sphere)) return [];
  return [`${seconds.toFixed(1)} s, ${(seconds / sphere).toFixed(0)} times as long as a sphere`];
}

/** The broken laws. @param {ReturnType<typeof makeProportionCase>} input */
export async function runProportionCase({ file, options, kind }) {
  const sphere = await sphereSeconds(options, kind);
  const { seconds, broken } = await secondsOf(file, options, Math.max(floor, times * sphere) + 1);
  return { broken: [...broken, ...lawsOfTimes(seconds, sphere)], size: file.bytes.length };
}

const text = (/** @type {string} */ words) => new TextEncoder().encode(words);

function stlClaiming(count) {
  const bytes = new Uint8Array(84 + 50);
  new DataView(bytes.buffer).setUint32(80, count, true);
  return bytes;
}

const gltfClaiming = (count) => JSON.stringify({ asset: { version: '2.0' },
  scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
  buffers: [{ byteLength: 36, uri: `data:;base64,${Buffer.alloc(36).toString('base64')}` }],
  bufferViews: [{ buffer: 0, byteLength: 36 }],
  accessors: [{ bufferView: 0, componentType: 5126, type: 'VEC3', count, min: [0, 0, 0],
    max: [0, 0, 0] }] });

const plyClaiming = (format, vertices, faces) => `ply\nformat ${format} 1.0\nelement vertex ${
  vertices}\nproperty float x\nproperty float y\nproperty float z\nelement face ${faces}\n`
  + 'property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';

/** Files that claim `count` of something and have three vertices. */
export const claims = {
  stl: (count) => ({ name: 'a.stl', bytes: stlClaiming(count) }),
  off: (count) => ({ name: 'a.off', bytes: text(`OFF\n${count} ${count} 0\n0 0 0\n`) }),
  'faces of off': (count) => ({ name: 'a.off', bytes:
    text(`OFF\n3 ${count} 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n`) }),
  'corners of off': (count) => ({ name: 'a.off', bytes:
    text(`OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n${count} 0 1 2\n`) }),
  ...Object.fromEntries(['ascii', 'binary_little_endian', 'binary_big_endian'].flatMap((format) => [
    [`vertices of ply, ${format}`,
      (count) => ({ name: 'a.ply', bytes: text(plyClaiming(format, count, 1)) })],
    [`faces of ply, ${format}`,
      (count) => ({ name: 'a.ply', bytes: text(plyClaiming(format, 3, count)) })]])),
  gltf: (count) => ({ name: 'a.gltf', bytes: text(gltfClaiming(count)) }),
};

/** Refused at once, as a fault of the file. @param {{ name: string, bytes: Uint8Array }} file */
export async function lawsOfClaim(file) {
  const watched = watch(floor);
  try {
    await inspect(file.bytes, { name: file.name, signal: watched.signal });
    return ['it is read as if it were whole'];
  } catch (error) {
    if (error?.name === 'AbortError') return [`not refused after ${floor} s`];
    return error.code === 'OUT_OF_MEMORY' ? [`OUT_OF_MEMORY: ${error.message}`]
      : lawsOfErrors(error);
  } finally {
    watched.stop();
  }
}
