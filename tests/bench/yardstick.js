// SPDX-License-Identifier: MIT
// A unit of time that cancels the machine's speed: the time of meshoptimizer's simplify, which is
// also WebAssembly, to the same number of vertices in the same process.
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';

import { MeshoptSimplifier } from 'meshoptimizer';

/** @param {number[]} values */
export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

const warmUps = 5; // until V8's compilers are done

/** Elapsed milliseconds. */
export const wallClock = () => performance.now();

/** Milliseconds of this process's processor time: other programs slow it only by the caches. */
export function ownClock() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

setFlagsFromString('--expose-gc');

/** Collects the yardstick's garbage: during a run that would be up to a third of a draft's time. */
export const collectGarbage = runInNewContext('gc');

/** The median in seconds; undefined if the mesh has too few triangles to simplify. */
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
