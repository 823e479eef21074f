// SPDX-License-Identifier: MIT
// How much faster a pool is than one worker, on a machine that has nothing else to do:
//   node tests/bench/pool.js [size]     after npm run build; size 2 if not given
// Eight equal jobs, all ways in turn three times, the least time of each.

import { Pool } from 'remesher/pool';

import { torus } from '../support/shapes.js';

const mesh = torus({ columns: 200, rows: 100 });
const jobs = Array.from({ length: 8 }, () => ({ vertices: 10000 }));

/** @param {Pool} pool @returns {Promise<number>} milliseconds */
async function timeOf(pool) {
  const start = performance.now();
  await Promise.all(jobs.map((options) => pool.remesh(mesh, options)));
  return performance.now() - start;
}

const pools = [1, Number(process.argv[2] ?? 2)].map((size) => new Pool({ size }));
const least = pools.map(() => Infinity);
await Promise.all(pools.map((pool) => pool.init()));
for (let round = 0; round < 3; round += 1) {
  for (const [i, pool] of pools.entries()) least[i] = Math.min(least[i], await timeOf(pool));
}
pools.forEach((pool) => pool.close());
const [one, many] = least.map((time) => time / 1000);
console.log(`one worker ${one.toFixed(2)} s, the pool ${many.toFixed(2)} s: `
  + `${(one / many).toFixed(2)} times as fast`);
