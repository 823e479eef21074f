// SPDX-License-Identifier: MIT
// Measures whether many small runs leak memory: npm run memory [-- RUNS], 10000 if not given.
// One line for runs in the calling thread and one for runs in the worker. The first fifth of the
// runs is the warm-up; the next two fifths are compared with the last two: bytes that a run leaves
// in JavaScript's heap, and beside it; the size of the whole process in each; and the number of
// WebAssembly memories. V8's compilers keep code and data for a long time, so they are off.

import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

import { remesh } from 'remesher';

import { octahedron } from '../support/shapes.js';

/** The memory after garbage collection, done several times because finalizers free more. */
async function memoryNow() {
  for (let i = 0; i < 3; i += 1) {
    globalThis.gc?.();
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  return process.memoryUsage();
}

/** Counts the instances made from now on, in this thread. @returns {() => number} */
function countInstances() {
  const { instantiate } = WebAssembly;
  let count = 0;
  WebAssembly.instantiate = (/** @type {any[]} */ ...given) => {
    count += 1;
    return instantiate.apply(WebAssembly, given);
  };
  return () => count;
}

/** @param {number} runs @param {boolean} worker */
async function repeat(runs, worker) {
  for (let i = 0; i < runs; i += 1) {
    await remesh(octahedron(), { vertices: 20, quality: 'draft', worker });
  }
}

/**
 * The least of five measurements during the runs, because V8 at times holds some hundred kilobytes
 * for a moment.
 * @param {number} runs @param {boolean} worker
 */
async function leastAmong(runs, worker) {
  const moments = [];
  for (let i = 0; i < 5; i += 1) {
    await repeat(runs / 5, worker);
    moments.push(await memoryNow());
  }
  const least = (/** @type {'heapUsed' | 'external' | 'rss'} */ name) =>
    Math.min(...moments.map((moment) => moment[name]));
  return { heap: least('heapUsed'), external: least('external'), resident: least('rss') };
}

/** @param {number} runs @param {boolean} worker */
async function measure(runs, worker) {
  const instances = countInstances();
  await repeat(runs / 5, worker);
  const part = (2 / 5) * runs;
  const before = await leastAmong(part, worker);
  const after = await leastAmong(part, worker);
  return {
    worker, runs,
    heapPerRun: (after.heap - before.heap) / part,
    externalPerRun: (after.external - before.external) / part,
    residentBefore: before.resident, residentAfter: after.resident,
    ...(worker ? {} : { instances: instances() }),
  };
}

const [runs, where] = process.argv.slice(2);
if (where) {
  console.log(JSON.stringify(await measure(Number(runs), where === 'worker')));
} else {
  for (const place of ['here', 'worker']) {
    spawnSync(process.execPath, ['--expose-gc', '--no-opt', '--no-sparkplug',
      '--no-flush-bytecode', fileURLToPath(import.meta.url), runs ?? '10000', place],
    { stdio: ['ignore', 'inherit', 'inherit'] });
  }
}
