// SPDX-License-Identifier: MIT
// Makes a case from a seed: a surface as arrays or as a file, with options. Surface and file may be
// spoilt. The same seed is always the same case.
import { Dice } from './dice.js';
import { files, meshOf } from './made_files.js';
import { firstWithScenes, scenes } from './made_scenes.js';
import { shapes } from './made_shapes.js';
import { spoilFile, spoilShape } from './mutations.js';

/**
 * @typedef {object} Case
 * @property {number} seed
 * @property {string} description
 * @property {any} [mesh] arrays; a case has either `mesh` or `file`
 * @property {{ name: string, bytes: Uint8Array, resources?: Record<string, Uint8Array> }} [file]
 * @property {Record<string, any>} options
 * @property {string} [output] the format asked for
 */

/** @param {Dice} dice @param {number} count vertices of the surface */
function randomOptions(dice, count) {
  /** @type {Record<string, any>} */
  const options = {};
  const maybe = (share, name, value) => {
    if (dice.chance(share)) options[name] = value();
  };
  if (dice.chance(0.8)) options.vertices = Math.max(4, Math.round(count * 4 ** dice.number(-1, 1)));
  else maybe(0.5, 'ratio', () => dice.number(0.2, 3));
  maybe(0.3, 'scheme', () => 'rounds');
  maybe(0.15, 'projection', () => 'current');
  maybe(0.2, 'fidelity', () => dice.pick(['strict', 'loose', 'fold']));
  maybe(0.2, 'adaptivity', () => dice.number());
  maybe(0.1, 'gradation', () => dice.number(1.01, 4));
  maybe(0.2, 'featureAngle', () => dice.pick(['off', dice.number(0, 180)]));
  maybe(0.2, 'boundary', () => 'keep');
  maybe(0.1, 'maxError', () => 10 ** dice.number(-2, 1));
  maybe(0.05, 'splitObtuse', () => true);
  return options;
}

/** @param {number} seed @returns {Case} */
export function makeCase(seed) {
  const dice = new Dice(seed);
  const name = dice.pick(Object.keys(shapes));
  const said = [name];
  let shape = shapes[name](dice.whole(1, 4));
  if (dice.chance(0.4)) {
    for (let times = dice.whole(1, 3); times > 0; times -= 1) shape = spoilShape(shape, dice, said);
  }
  const options = randomOptions(dice, shape.positions.length);
  if (dice.chance(0.2)) {
    return { seed, mesh: meshOf(shape), options, description: said.join(', ') };
  }
  const kinds = seed < firstWithScenes ? files : { ...files, ...scenes };
  const kind = dice.pick(Object.keys(kinds));
  said.push(`as ${kind}`);
  let file = kinds[kind](shape);
  if (dice.chance(0.5)) {
    for (let times = dice.whole(1, 3); times > 0; times -= 1) file = spoilFile(file, dice, said);
  }
  const output = dice.chance(0.2) ? dice.pick(['glb', 'gltf', 'obj', 'off']) : undefined;
  return { seed, file, options, output, description: said.join(', ') };
}
