// SPDX-License-Identifier: MIT
// CGAL beside our own judge of repaired surfaces, and its alpha wrap beside our repair.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { offText } from '../support/shapes.js';
import { cgalProgram } from './cgal.js';
import { readOff } from './models.js';

/** Alpha is the diagonal over this: as the coarsest wrap that keeps what is seen. */
const share = 200;
const mostSeconds = 120;

/** @param {any} mesh @param {(program: string, folder: string, path: string) => any} act */
function withProgram(mesh, act) {
  const program = cgalProgram('cgal_repair_main.cpp');
  if (!program) return undefined;
  const folder = mkdtempSync(join(tmpdir(), 'remesher-cgal-'));
  try {
    const path = join(folder, 'mesh.off');
    writeFileSync(path, offText(mesh));
    return act(program, folder, path);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** What CGAL finds wrong with a surface, in words; undefined without CGAL.
 * @returns {string[] | undefined} */
export function wrongByCgal(mesh) {
  return withProgram(mesh, (program, _, path) => {
    const { stdout, status, signal } = spawnSync(program, ['judge', path], { encoding: 'utf8' });
    if (status !== 0) return [`no verdict (${signal ?? status})`];
    const found = JSON.parse(stdout);
    if (!found.isManifold) return ['not manifold'];
    return [...(found.isClosed ? [] : ['open']),
      ...(found.pairs > 0 ? [`${found.pairs} crossing pairs`] : []),
      ...(found.boundsVolume ? [] : ['bounds no volume'])];
  });
}

/** CGAL's alpha wrap; undefined without CGAL, or if it takes too long. */
export function alphaWrap(mesh) {
  return withProgram(mesh, (program, folder, path) => {
    const result = join(folder, 'wrap.off');
    const start = performance.now();
    try {
      execFileSync(program, ['wrap', path, String(share), result],
        { stdio: 'ignore', timeout: 1000 * mostSeconds });
    } catch {
      return undefined;
    }
    const seconds = (performance.now() - start) / 1000;
    return { seconds, mesh: readOff(readFileSync(result, 'utf8')) };
  });
}
