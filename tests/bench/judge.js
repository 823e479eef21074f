// SPDX-License-Identifier: MIT
// Judges a result by the native measuring tool. The tool shares only a tree of triangles, tested
// against brute force, with the remesher, and proves the largest distance.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { toObj } from './models.js';

const tool = join(dirname(fileURLToPath(import.meta.url)), '../../build/native/measure');

export function judge(original, result) {
  const folder = mkdtempSync(join(tmpdir(), 'remesher-bench-'));
  try {
    const paths = ['original.obj', 'result.obj'].map((name) => join(folder, name));
    writeFileSync(paths[0], toObj(original));
    writeFileSync(paths[1], toObj(result));
    return JSON.parse(execFileSync(tool, [...paths, '--json'], { encoding: 'utf8' }));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The broken promises that hold for every result, in words. */
export function brokenPromises(judgement, vertices) {
  const { original, result } = judgement;
  const broken = [];
  if (result.vertices !== vertices) broken.push(`${result.vertices} vertices, not ${vertices}`);
  for (const name of ['components', 'boundaryLoops', 'nonManifoldEdges', 'eulerCharacteristic']) {
    if (result[name] !== original[name]) {
      broken.push(`${name} ${result[name]}, was ${original[name]}`);
    }
  }
  if (original.selfIntersections === 0 && result.selfIntersections > 0) {
    broken.push(`${result.selfIntersections} triangles intersect others`);
  }
  return broken;
}
