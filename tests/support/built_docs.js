// SPDX-License-Identifier: MIT
// Builds the documentation once for all test files that look at it, one after the other.
import { execFileSync } from 'node:child_process';
import { mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';

import { root } from './tree.js';

const pause = () => Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 200);

/** Whether the lock was free, and is ours now. @param {string} lock a folder */
function isTaken(lock) {
  try {
    mkdirSync(lock);
    return true;
  } catch {
    return false;
  }
}

/** In build/docs. */
export function buildDocs() {
  const lock = join(root, 'build/docs.lock');
  // A run that was killed leaves its lock: it is waited for two minutes.
  for (let looks = 0; looks < 600 && !isTaken(lock); looks += 1) pause();
  try {
    execFileSync(process.execPath, ['bindings/build/docs.js'], { cwd: root, stdio: 'pipe' });
  } finally {
    rmSync(lock, { recursive: true, force: true });
  }
}
