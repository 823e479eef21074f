// SPDX-License-Identifier: MIT
// Cases of the laws "said is written" and "never worse": a surface as a file, one run of it, and
// what an independent reader finds in the written bytes.
import { remeshFile, repairFile } from 'remesher';

import { figuresOf } from '../support/independent/figures.js';
import { readFile } from '../support/independent/read.js';
import { lawsOfErrors } from '../support/laws.js';
import { lawsOfHarm } from '../support/trust/harm.js';
import { lawsOfWriting } from '../support/trust/said.js';
import { Dice } from './dice.js';
import { askew, faultyBody, openSheet, soundBody } from './made_bodies.js';
import { trustFiles } from './trust_files.js';

/**
 * @typedef {object} TrustCase
 * @property {string} description
 * @property {{ name: string, bytes: Uint8Array, resources?: Record<string, Uint8Array> }} file
 * @property {boolean} isRepair whether nothing but a repair is asked for
 * @property {Record<string, any>} options
 * @property {string} output its format
 */

const formatOf = (/** @type {string} */ name) => name.split('.').at(-1) ?? '';

function fileOf(dice, { name, shape }, kinds = Object.keys(trustFiles)) {
  const kind = dice.pick(kinds);
  const isAskew = dice.chance(0.4);
  return { file: trustFiles[kind](isAskew ? askew(shape, dice) : shape),
    description: `${name}${isAskew ? ', askew' : ''}, as ${kind}` };
}

const vertexCount = (dice, { shape }) =>
  Math.round(Math.max(20, Math.min(1200, shape.positions.length * 4 ** dice.number(-0.7, 0.7))));

/** Any surface, any run, any format. @param {number} seed @returns {TrustCase} */
export function makeSaidCase(seed) {
  const dice = new Dice(seed);
  const body = dice.pick([faultyBody, faultyBody, soundBody, openSheet])(dice);
  const { file, description } = fileOf(dice, body);
  const output = dice.chance(0.4) ? formatOf(file.name)
    : dice.pick(['obj', 'stl', 'ply', 'off', 'glb']);
  const isRepair = dice.chance(0.4);
  const options = isRepair ? { repair: dice.pick(['auto', 'auto', 'holes', 'solid']) }
    : { vertices: vertexCount(dice, body) };
  if (!isRepair && dice.chance(0.4)) options.quads = true;
  if (!isRepair && dice.chance(0.25)) options.repair = 'auto';
  return { description, file, isRepair, options, output };
}

/** Repairs into the same format, and open sheets that are remeshed. @param {number} seed
 * @returns {TrustCase} */
export function makeHarmCase(seed) {
  const dice = new Dice(seed);
  const isRepair = dice.chance(0.6);
  const body = isRepair ? faultyBody(dice) : openSheet(dice);
  const { file, description } = fileOf(dice, body, ['obj of numbers', 'obj of quads', 'stl', 'ply',
    'off', 'plain']);
  const options = isRepair ? { repair: 'auto' } : { vertices: vertexCount(dice, body) };
  if (!isRepair && dice.chance(0.5)) options.quads = true;
  return { description, file, isRepair, options, output: formatOf(file.name) };
}

/** The command line of a case, for its input as a file. @param {TrustCase} input */
export function commandOf({ file, isRepair, options, output }) {
  const flags = Object.entries(options).map(([name, value]) =>
    (value === true ? `--${name}` : `--${name} ${value}`)).join(' ');
  return `remesher ${isRepair ? 'repair ' : ''}${file.name} -o out.${output} ${flags}`;
}

/** Written bytes and their figures. @param {TrustCase} input @param {object} [how] of the call */
export async function runOf({ file, isRepair, options, output }, how = {}) {
  const { name, bytes, resources } = file;
  const run = isRepair ? repairFile : remeshFile;
  const result = await run(bytes, { ...options, name, resources, output, ...how });
  const others = Object.fromEntries(result.files.slice(1).map((one) => [one.name, one.bytes]));
  const read = readFile(result.bytes, { name: result.name, resources: others });
  return { ...result, read, written: figuresOf(read) };
}

const areEqual = (a, b) => Buffer.compare(Buffer.from(a), Buffer.from(b)) === 0;

/**
 * The broken laws. @param {TrustCase} input
 * @param {'said' | 'harm'} law @param {object} [how] of the call: signal, worker
 */
export async function runTrustCase(input, law, how = {}) {
  const before = figuresOf(readFile(input.file.bytes,
    { ...input.file, isShorter: input.options.quads === true }));
  try {
    const { bytes, name, report, written } = await runOf(input, how);
    const broken = law === 'said' ? lawsOfWriting(written, report, { name, before })
      : lawsOfHarm(before, written, { report, isRepair: input.isRepair,
        sameBytes: areEqual(bytes, input.file.bytes) });
    return { broken, size: written.vertices };
  } catch (error) {
    if (error?.name === 'AbortError') return { broken: ['it does not end'], size: 0 };
    return { broken: lawsOfErrors(error), size: 0, code: error.code };
  }
}
