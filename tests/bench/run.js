// SPDX-License-Identifier: MIT
// Times a remesh.
import { remesh } from 'remesher';

import { median } from './yardstick.js';

/** The last result, the median of the times in seconds, and the peak of the memory in bytes. */
export async function timeRemesh(mesh, options, runs) {
  const seconds = [];
  let result;
  for (let k = 0; k < runs; k += 1) {
    const start = performance.now();
    result = await remesh(mesh, { ...options, worker: false });
    seconds.push((performance.now() - start) / 1000);
  }
  return { ...result, seconds: median(seconds), bytes: result.report.memory.peakBytes };
}
