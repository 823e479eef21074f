// SPDX-License-Identifier: MIT
// Measures how much faster a pool is than one worker, on an idle machine, and how much faster as
// many separate processes are:
//   node tests/bench/pool.js [size]     after npm run build; size 2 if not given
// Each way does 4 × size equal jobs. All ways run in turn three times; the least time of each
// counts.

import { fork } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';

import { remesh } from 'remesher';
import { Pool } from 'remesher/pool';

import { torus } from '../support/shapes.js';

const mesh = torus({ columns: 200, rows: 100 });
const options = { vertices: 10000 };
const rounds = 3;

/** @param {() => Promise<unknown>} work @returns {Promise<number>} milliseconds */
async function timeOf(work) {
  const start = performance.now();
  await work();
  return performance.now() - start;
}

const inPool = (/** @type {Pool} */ pool, /** @type {number} */ jobs) =>
  Promise.all(Array.from({ length: jobs }, () => pool.remesh(mesh, options)));

/** A separate process, told how many jobs to do. */
async function whenAsked() {
  process.on('message', async (/** @type {number} */ count) => {
    for (let i = 0; i < count; i += 1) await remesh(mesh, { ...options, worker: false });
    process.send?.('done');
  });
  await remesh(mesh, { ...options, worker: false });
  process.send?.('ready');
}

/**
 * @param {readonly import('node:child_process').ChildProcess[]} children
 * @param {number} jobs
 */
const inProcesses = (children, jobs) => Promise.all(children.map((child) => {
  child.send(jobs / children.length);
  return once(child, 'message');
}));

async function compare(/** @type {number} */ size) {
  const pools = [1, size].map((count) => new Pool({ size: count }));
  await Promise.all(pools.map((pool) => pool.init()));
  const self = fileURLToPath(import.meta.url);
  const children = Array.from({ length: size }, () => fork(self, ['job']));
  await Promise.all(children.map((child) => once(child, 'message')));
  const jobs = 4 * size;
  const ways = [() => inPool(pools[0], jobs), () => inPool(pools[1], jobs),
    () => inProcesses(children.slice(0, 1), jobs), () => inProcesses(children, jobs)];
  const least = ways.map(() => Infinity);
  for (let round = 0; round < rounds; round += 1) {
    for (const [i, way] of ways.entries()) least[i] = Math.min(least[i], await timeOf(way));
  }
  pools.forEach((pool) => pool.close());
  children.forEach((child) => child.kill());
  const [one, many, alone, beside] = least.map((time) => time / 1000);
  const row = (/** @type {string} */ what, /** @type {number} */ a, /** @type {number} */ b) =>
    `${what}: ${a.toFixed(2)} s, ${size}: ${b.toFixed(2)} s, ${(a / b).toFixed(2)} times as fast`;
  console.log(`${row('one worker', one, many)}\n${row('one process', alone, beside)}`);
}

const word = process.argv[2] ?? '2';
await (word === 'job' ? whenAsked() : compare(Number(word)));
