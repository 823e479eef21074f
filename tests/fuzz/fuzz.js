// SPDX-License-Identifier: MIT
// Runs every fuzz target for a number of minutes, as many side by side as there are cores:
//   npm run fuzz -- [--minutes number] [--target name]
// Inputs that break a target are kept in build/fuzz/findings. To run such an input again, start
// build/fuzz/fuzz with the file, and with the target's name in REMESHER_FUZZ_TARGET. Interesting
// inputs stay in build/fuzz/corpus, and the next run begins with them.
import { spawn } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';

import { root } from '../support/tree.js';
import { runCompressedCase } from './compressed_case.js';
import { makeCorpora, writeInputs } from './corpora.js';

const folder = join(root, 'build/fuzz');
const longestInput = 120; // seconds for one input, enough on a busy machine
const grace = 300;

/** @typedef {{ name: string, executions: number, log: string, isFound: boolean }} Outcome */

/** The arguments of a libFuzzer run. */
function argumentsFor(name, { length, words, inputs }, seconds) {
  const [seeds, corpus] = ['seeds', 'corpus'].map((kind) => join(folder, kind, name));
  writeInputs(seeds, inputs);
  for (const made of [corpus, join(folder, 'findings')]) mkdirSync(made, { recursive: true });
  const dictionary = join(folder, 'seeds', `${name}.dict`);
  writeFileSync(dictionary, words.map((word) => `"${word}"\n`).join(''));
  return [`-max_total_time=${seconds}`, `-max_len=${length}`, `-timeout=${longestInput}`,
    `-artifact_prefix=${join(folder, 'findings', name)}-`,
    ...(words.length > 0 ? [`-dict=${dictionary}`] : []),
    '-print_final_stats=1', corpus, seeds];
}

/** @returns {Promise<Outcome>} */
function runNative(name, corpus, seconds) {
  const child = spawn(join(folder, 'fuzz'), argumentsFor(name, corpus, seconds), {
    env: { ...process.env, REMESHER_FUZZ_TARGET: name }, stdio: ['ignore', 'ignore', 'pipe'],
    timeout: (seconds + longestInput + grace) * 1000, killSignal: 'SIGKILL',
  });
  let log = '';
  child.stderr.setEncoding('utf8').on('data', (text) => { log = (log + text).slice(-20000); });
  return new Promise((resolve) => child.on('close', (status) => {
    const executions = Number(/number_of_executed_units: (\d+)/.exec(log)?.[1] ?? 0);
    resolve({ name, executions, log, isFound: status !== 0 });
  }));
}

/** Fuzzes the decoders of compressed glTF. @returns {Promise<Outcome>} */
async function runCompressed(seconds) {
  const end = Date.now() + 1000 * seconds;
  let executions = 0;
  const first = Math.floor(Math.random() * 1e9);
  while (Date.now() < end) {
    const broken = await runCompressedCase(first + executions);
    executions += 1;
    if (broken.length > 0) {
      return { name: 'compressed', executions, log: broken.join('\n'), isFound: true };
    }
  }
  return { name: 'compressed', executions, log: '', isFound: false };
}

function say({ name, executions, log, isFound }) {
  console.log(`${name}: ${executions} executions, ${isFound ? 'a finding' : '0 findings'}`);
  if (isFound) console.log(log);
}

/** @returns {Promise<number>} the exit status */
async function fuzz() {
  const { values } = parseArgs({ options: {
    minutes: { type: 'string', default: '1' }, target: { type: 'string' },
  } });
  const seconds = Math.round(60 * Number(values.minutes));
  const corpora = await makeCorpora();
  const all = [...Object.keys(corpora), 'compressed'];
  const waiting = all.filter((name) => values.target === undefined || values.target === name);
  if (waiting.length === 0 || !(seconds > 0)) {
    console.error(`--target is one of ${all.join(', ')}; --minutes is a number.`);
    return 2;
  }
  let found = 0;
  const work = async () => {
    for (let name = waiting.shift(); name; name = waiting.shift()) {
      const outcome = name === 'compressed' ? await runCompressed(seconds)
        : await runNative(name, corpora[name], seconds);
      say(outcome);
      found += Number(outcome.isFound);
    }
  };
  await Promise.all(Array.from({ length: availableParallelism() }, work));
  return found > 0 ? 1 : 0;
}

process.exitCode = await fuzz();
