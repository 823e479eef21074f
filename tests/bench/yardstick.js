// SPDX-License-Identifier: MIT
// A time that cancels the machine's speed: what meshoptimizer's simplify, WebAssembly too, takes to
// the same number of vertices in the same process.
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';

import { MeshoptSimplifier } from 'meshoptimizer';

/** @param {number[]} values */
export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

const warmUps = 5; // until the engine's compilers have done their work

/** Milliseconds that go by. */
export const wallClock = () => performance.now();

/** Milliseconds that this process computes: a busy machine counts only by its caches. */
export function ownClock() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

setFlagsFromString('--expose-gc');

/** Collected beside a run, what the yardstick left would be up to a third of a draft's time. */
export const collectGarbage = runInNewContext('gc');

/** The median of seconds, or nothing where there is nothing to simplify. */
export async function timeYardstick({ positions, indices }, vertices, runs, clock = wallClock) {
  if (2 * vertices * 3 >= indices.length) return undefined;
  await MeshoptSimplifier.ready;
  const floats = Float32Array.from(positions);
  const seconds = [];
  for (let k = -warmUps; k < runs; k += 1) {
    const start = clock();
    MeshoptSimplifier.simplify(indices, floats, 3, 2 * vertices * 3, 1);
    if (k >= 0) seconds.push((clock() - start) / 1000);
  }
  return median(seconds);
}
