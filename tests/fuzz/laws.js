// SPDX-License-Identifier: MIT
// Runs cases by their seeds, and prints the cases that break a law:
//   npm run laws -- [--law name] [--seed first] [--cases number] [--every nth]
// Laws of every run: runs (if not given), quads (--quads), repair (--repair). Laws of trust, judged
// by the written bytes: said, harm, invariance, continuity, proportion; trust is all five in turn.
// The same seed is the same case: --seed with --cases 1 runs a printed case again, and with --keep
// FOLDER writes its file there. Processor time only ends runs that do not end, tells which cases
// took longest for their size, and is what proportion is about.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';

import { watch } from '../support/watch.js';
import { makeCase } from './cases.js';
import { makeContinuityCase, runContinuityCase } from './continuity_case.js';
import { makeInvarianceCase, runInvarianceCase } from './invariance_case.js';
import { firstWithScenes } from './made_scenes.js';
import { makeProportionCase, runProportionCase } from './proportion_case.js';
import { makeQuadsCase } from './quads_case.js';
import { makeRepairCase, runRepairCase } from './repair_case.js';
import { runCase } from './run_case.js';
import { commandOf, makeHarmCase, makeSaidCase, runTrustCase } from './trust_case.js';

const everyRepeated = 8;
const timedAgain = 8;

/** @typedef {{ seed: number, size: number, seconds: number }} Timing */

/** The cases that took longest compared with others of their size. @param {Timing[]} timings */
function slowest(timings) {
  const classOf = (/** @type {number} */ size) => Math.floor(Math.log2(size));
  /** @type {Map<number, number[]>} */
  const bySize = new Map();
  for (const timing of timings) {
    const key = classOf(timing.size);
    bySize.set(key, [...bySize.get(key) ?? [], timing.seconds]);
  }
  const median = (/** @type {number[]} */ list) => list.sort((a, b) => a - b)[list.length >> 1];
  const medians = new Map([...bySize].map(([key, list]) => [key, median(list)]));
  return timings.map((timing) =>
    ({ ...timing, ratio: timing.seconds / medians.get(classOf(timing.size)) }))
    .sort((a, b) => b.ratio - a.ratio).slice(0, timedAgain);
}

/** @typedef {(seed: number) => import('./cases.js').Case} CaseMaker */

/** Times a case again, because V8's compilers may have been at work.
 * @param {Timing} timing @param {CaseMaker} caseOf */
async function timeAgain({ seed, size, seconds }, caseOf) {
  const { signal, seconds: again, stop } = watch();
  await runCase(caseOf(seed), { how: { signal } });
  stop();
  return { seed, size, seconds: Math.min(seconds, again()) };
}

const asked = (/** @type {any} */ { options, output }) =>
  `${JSON.stringify(options)}${output ? ` to ${output}` : ''}`;

/** Ten runs in one case. */
const continuityLimit = 300;

/**
 * For each law: makes a case, runs it, and says it in words.
 * @type {Record<string, { make: (seed: number) => any, words?: (input: any) => string,
 *   limit?: number, run: (input: any, how: object, seed: number) => Promise<any> }>}
 */
const laws = {
  runs: { make: makeCase,
    run: (input, how, seed) => runCase(input, { how, repeats: seed % everyRepeated === 0 }) },
  quads: { make: makeQuadsCase,
    run: (input, how, seed) => runCase(input, { how, repeats: seed % everyRepeated === 0 }) },
  repair: { make: makeRepairCase, run: runRepairCase,
    words: ({ options, count }) => `${JSON.stringify(options)}, ${count} vertices` },
  said: { make: makeSaidCase, run: (input, how) => runTrustCase(input, 'said', how),
    words: commandOf },
  harm: { make: makeHarmCase, run: (input, how) => runTrustCase(input, 'harm', how),
    words: commandOf },
  invariance: { make: makeInvarianceCase, run: runInvarianceCase },
  continuity: { make: makeContinuityCase, run: runContinuityCase, limit: continuityLimit,
    words: ({ options, counts }) => `${JSON.stringify(options)}, ${counts} vertices` },
  proportion: { make: makeProportionCase, run: runProportionCase },
};
const ofTrust = ['said', 'harm', 'invariance', 'continuity', 'proportion'];

/** @param {string} name of a law @param {number} seed @param {string} [folder] to keep the file */
async function runSeed(name, seed, folder) {
  const { make, run, words = asked, limit } = laws[name];
  const input = make(seed);
  if (folder && input.file) writeFileSync(join(folder, input.file.name), input.file.bytes);
  const { signal, seconds, stop } = watch(limit);
  const { broken, size, code = 'done' } = await run(input, { signal }, seed);
  stop();
  if (broken.length > 0) {
    console.log(`${name} ${seed} (${input.description}; ${words(input)})\n  `
      + broken.join('\n  '));
  }
  return { seed, broken, size, code, seconds: seconds() };
}

/** @param {any[]} outcomes @param {CaseMaker} caseOf */
async function printSlowest(outcomes, caseOf) {
  const timed = outcomes.filter(({ size }) => size > 0);
  for (const { seed } of slowest(timed)) {
    const at = timed.findIndex((timing) => timing.seed === seed);
    timed[at] = await timeAgain(timed[at], caseOf);
  }
  const [worst] = slowest(timed);
  if (!worst) return;
  console.log(`slowest for its size: ${worst.seed}, ${worst.size} vertices, `
    + `${worst.seconds.toFixed(2)} s, ${worst.ratio.toFixed(1)} × the median`);
}

/** @param {string} name of a law @param {number[]} seeds @param {string} [folder]
 * @returns {Promise<number>} the number of cases that break it */
async function runLaw(name, seeds, folder) {
  const outcomes = [];
  for (const seed of seeds) outcomes.push(await runSeed(name, seed, folder));
  /** @type {Record<string, number>} */
  const codes = {};
  for (const { code } of outcomes) codes[code] = (codes[code] ?? 0) + 1;
  const failures = outcomes.filter(({ broken }) => broken.length > 0).length;
  console.log(`${name}: ${seeds.length} cases, ${failures} break a law; ${JSON.stringify(codes)}`);
  if (['runs', 'quads'].includes(name)) await printSlowest(outcomes, laws[name].make);
  return failures;
}

/** @returns {Promise<number>} the exit status */
async function runLaws() {
  const { values } = parseArgs({ options: {
    law: { type: 'string' },
    seed: { type: 'string', default: String(firstWithScenes) },
    cases: { type: 'string', default: '1000' },
    every: { type: 'string', default: '1' },
    keep: { type: 'string' },
    quads: { type: 'boolean', default: false },
    repair: { type: 'boolean', default: false },
  } });
  const name = values.law ?? (values.repair ? 'repair' : values.quads ? 'quads' : 'runs');
  const names = name === 'trust' ? ofTrust : [name];
  if (!names.every((one) => one in laws)) {
    console.error(`No law is called ${name}: ${[...Object.keys(laws), 'trust'].join(', ')}.`);
    return 2;
  }
  const [first, count, step] = [values.seed, values.cases, values.every].map(Number);
  const seeds = Array.from({ length: count }, (_, i) => first + i * step);
  let failures = 0;
  for (const one of names) failures += await runLaw(one, seeds, values.keep);
  return failures > 0 ? 1 : 0;
}

process.exitCode = await runLaws();
