// SPDX-License-Identifier: MIT
// Runs cases by their seeds, and prints the cases that break a law:
//   npm run laws -- [--seed first] [--cases number] [--every nth] [--quads] [--repair]
// With --quads, the same surfaces become quads. With --repair, other cases are run under the laws
// of repair.
// The same seed is the same case: --seed with --cases 1 runs a printed case again. Processor time
// only ends runs that do not end, and tells which cases took longest for their size.
import { parseArgs } from 'node:util';

import { makeCase } from './cases.js';
import { firstWithScenes } from './made_scenes.js';
import { makeQuadsCase } from './quads_case.js';
import { makeRepairCase, runRepairCase } from './repair_case.js';
import { runCase } from './run_case.js';

const longestRun = 60; // seconds of processor time
const everyRepeated = 8;
const timedAgain = 8;

/** A signal that aborts after `longestRun` of processor time; `stop` ends the watch. */
function watch() {
  const controller = new AbortController();
  const begin = process.cpuUsage();
  const seconds = () => {
    const { user, system } = process.cpuUsage(begin);
    return (user + system) / 1e6;
  };
  const timer = setInterval(() => {
    if (seconds() > longestRun) controller.abort();
  }, 1000);
  return { signal: controller.signal, seconds, stop: () => clearInterval(timer) };
}

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

/** @param {number} seed @param {CaseMaker} caseOf */
async function runSeed(seed, caseOf) {
  const input = caseOf(seed);
  const { signal, seconds, stop } = watch();
  const { broken, size, code = 'done' } =
    await runCase(input, { how: { signal }, repeats: seed % everyRepeated === 0 });
  stop();
  if (broken.length > 0) {
    console.log(`${seed} (${input.description}; ${JSON.stringify(input.options)}`
      + `${input.output ? ` to ${input.output}` : ''})\n  ${broken.join('\n  ')}`);
  }
  return { seed, broken, size, code, seconds: seconds() };
}

/** @param {number} seed */
async function repairSeed(seed) {
  const input = makeRepairCase(seed);
  const { signal, seconds, stop } = watch();
  const { broken, size, code = 'done' } = await runRepairCase(input, { signal });
  stop();
  if (broken.length > 0) {
    console.log(`${seed} (${input.description}; ${JSON.stringify(input.options)}, `
      + `${input.count} vertices)\n  ${broken.join('\n  ')}`);
  }
  return { seed, broken, size, code, seconds: seconds() };
}

/** @returns {Promise<number>} the exit status */
async function runLaws() {
  const { values } = parseArgs({ options: {
    seed: { type: 'string', default: String(firstWithScenes) },
    cases: { type: 'string', default: '1000' },
    every: { type: 'string', default: '1' },
    quads: { type: 'boolean', default: false },
    repair: { type: 'boolean', default: false },
  } });
  const [first, count, step] = [values.seed, values.cases, values.every].map(Number);
  const outcomes = [];
  const caseOf = values.quads ? makeQuadsCase : makeCase;
  const run = values.repair ? repairSeed : runSeed;
  for (let i = 0; i < count; i += 1) outcomes.push(await run(first + i * step, caseOf));
  /** @type {Record<string, number>} */
  const codes = {};
  for (const { code } of outcomes) codes[code] = (codes[code] ?? 0) + 1;
  const failures = outcomes.filter(({ broken }) => broken.length > 0).length;
  console.log(`${count} cases, ${failures} break a law; ${JSON.stringify(codes)}`);
  if (values.repair) return failures > 0 ? 1 : 0;
  const timed = outcomes.filter(({ size }) => size > 0);
  for (const { seed } of slowest(timed)) {
    const at = timed.findIndex((timing) => timing.seed === seed);
    timed[at] = await timeAgain(timed[at], caseOf);
  }
  const [worst] = slowest(timed);
  if (worst) {
    console.log(`slowest for its size: ${worst.seed}, ${worst.size} vertices, `
      + `${worst.seconds.toFixed(2)} s, ${worst.ratio.toFixed(1)} × the median`);
  }
  return failures > 0 ? 1 : 0;
}

process.exitCode = await runLaws();
