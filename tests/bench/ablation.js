// SPDX-License-Identifier: MIT
// Measures the worth of each step of the scheme `best`. Every case is remeshed without each step in
// turn, to seven numbers of vertices within 1 % of the target. The table shows how far the medians
// move; a step that moves none has no effect and should go.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { loadModel, toObj } from './models.js';
import { fixed, markdownTable } from './table.js';
import { median } from './yardstick.js';

const builtTool = join(dirname(fileURLToPath(import.meta.url)), '../../build/native/ablation');

export const columns = ['case', 'without', 'same', 'time ×', '50–60° pts', 'mean °', 'worst °',
  'least worst °', 'Hausdorff ×', 'RMS ×', 'valence 6 pts'];

/** @typedef {Record<string, number>} Figures of one run */

/**
 * The figures of seven numbers of vertices: of the whole scheme, and without each step.
 * @param {{ model: string, folder?: string, vertices: number }} wanted
 * @param {string[]} steps the empty one: only the whole scheme
 * @param {string} tool
 * @returns {Record<string, Figures[]> | undefined} by step, '' the whole; nothing without the model
 */
export function runsBy({ model, folder, vertices }, steps, tool = builtTool) {
  const mesh = loadModel(model, folder);
  if (!mesh) return undefined;
  const place = mkdtempSync(join(tmpdir(), 'remesher-ablation-'));
  try {
    const path = join(place, 'model.obj');
    writeFileSync(path, toObj(mesh));
    const words = [path, String(vertices), ...steps];
    return JSON.parse(execFileSync(tool, words, { encoding: 'utf8', maxBuffer: 2 ** 26 }));
  } finally {
    rmSync(place, { recursive: true });
  }
}

const isSame = (/** @type {Figures} */ a, /** @type {Figures} */ b) =>
  Object.keys(a).every((name) => name === 'milliseconds' || a[name] === b[name]);

/**
 * @param {string} name
 * @param {string} change
 * @param {Figures[]} whole
 * @param {Figures[]} without with the change
 */
export function rowOf(name, change, whole, without) {
  const middle = (/** @type {Figures[]} */ runs, /** @type {string} */ figure) =>
    median(runs.map((run) => run[figure]));
  const worst = (/** @type {Figures[]} */ runs) => Math.min(...runs.map((run) => run.worstAngle));
  const more = (/** @type {string} */ figure) => middle(without, figure) - middle(whole, figure);
  const times = (/** @type {string} */ figure) => middle(without, figure) / middle(whole, figure);
  const same = whole.filter((run, k) => isSame(run, without[k])).length;
  return [name, change, `${same} of ${whole.length}`, fixed(times('milliseconds'), 2),
    fixed(more('above50'), 2), fixed(more('meanAngle'), 3), fixed(more('worstAngle'), 2),
    fixed(worst(without) - worst(whole), 2), fixed(times('hausdorff'), 3), fixed(times('rms'), 3),
    fixed(more('valence6'), 2)];
}

/**
 * @param {Record<string, any>} cases
 * @param {{ folder?: string, names: string[], steps: string[] }} wanted
 */
export function runAblation(cases, { folder, names, steps }) {
  const rows = [];
  for (const [name, { model, vertices }] of Object.entries(cases)) {
    if (names.length > 0 && !names.some((wanted) => name.startsWith(wanted))) continue;
    const { '': whole, ...left } = runsBy({ model, folder, vertices }, steps) ?? {};
    if (!whole) continue;
    for (const [step, runs] of Object.entries(left)) {
      rows.push(rowOf(name, step, whole, /** @type {Figures[]} */ (runs)));
      console.log(rows.at(-1)?.join(' '));
    }
  }
  return { table: markdownTable(columns, rows), broken: [] };
}
