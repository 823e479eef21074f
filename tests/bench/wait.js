// SPDX-License-Identifier: MIT
// How long people wait, in units that cancel the machine's speed: U is what meshoptimizer's
// simplify takes for a horse to 10000 vertices in the same process, warm, measured before each run.
// Both are times that the process computes, so that a busy machine does not count.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

import { remesh, remeshFile, remeshScene } from 'remesher';

import { assembly } from './assembly.js';
import { loadModel } from './models.js';
import { phaseTable } from './phases.js';
import { fixed, markdownTable } from './table.js';
import { collectGarbage, median, ownClock, timeYardstick } from './yardstick.js';

const columns = ['case', 'U', 'at most', 'ms', 'memory MiB', 'worst °', 'mean °', '50–60° %',
  'Hausdorff %', 'RMS %'];
const horse = { model: 'horse.obj', vertices: 10000 };

/** What a case runs: of a formula, a package or a folder; nothing where its model is missing. */
function runnable({ model, vertices, quality, ...rest }, folder) {
  const options = { vertices, quality, worker: false };
  if (model === 'assembly') {
    const scene = assembly();
    return () => remeshScene(scene, options);
  }
  if (rest.file) {
    const path = folder && join(folder, model);
    if (!path || !existsSync(path)) return undefined;
    const bytes = readFileSync(path);
    return () => remeshFile(bytes, { ...options, name: model, output: model });
  }
  const mesh = loadModel(model, folder);
  return mesh && (() => remesh(mesh, options));
}

/** The medians of milliseconds of runs and of U between them, and the last report. */
async function timeInUnits(run, yardstick, runs) {
  const [times, units] = [[], []];
  let report;
  for (let k = 0; k < runs; k += 1) {
    units.push(1000 * await timeYardstick(yardstick, horse.vertices, 3, ownClock));
    collectGarbage();
    const start = ownClock();
    ({ report } = await run());
    times.push(ownClock() - start);
  }
  return { time: median(times), unit: median(units), report };
}

/** @param {Record<string, any>} cases */
export async function runWait(cases, { folder, names, runs }) {
  if (!folder) throw new Error('The unit is a horse: which folder of models (--models)?');
  const yardstick = loadModel(horse.model, folder);
  const [rows, broken, timed] = [[], [], []];
  for (const [name, limits] of Object.entries(cases)) {
    if (names.length > 0 && !names.some((wanted) => name.startsWith(wanted))) continue;
    const run = runnable(limits, folder);
    if (!run) continue;
    if (runs > 1) await run(); // the engine's compilers have done their work
    const { time, unit, report } = await timeInUnits(run, yardstick, runs);
    const { output: { minAngle }, fidelity, memory } = report;
    rows.push([name, fixed(time / unit, 1), limits.units, fixed(time, 0),
      fixed(memory.peakBytes / 2 ** 20, 0), fixed(minAngle.worst, 1), fixed(minAngle.mean, 2),
      fixed(minAngle.histogram[5], 1), fixed(fidelity.hausdorff, 4), fixed(fidelity.rms, 5)]);
    timed.push({ name, phases: report.phases });
    console.log(rows.at(-1).join(' '));
    if (time > limits.units * unit) {
      broken.push(`${name}: ${(time / unit).toFixed(1)} U > ${limits.units}`);
    }
    if (memory.peakBytes > limits.bytes) broken.push(`${name}: ${memory.peakBytes} bytes`);
  }
  return { table: `${markdownTable(columns, rows)}\n\n${phaseTable(timed)}`, broken };
}
