// SPDX-License-Identifier: MIT
// Measures how long people wait, in a unit U that cancels the machine's speed. U is the time of
// meshoptimizer's simplify for a horse to 10000 vertices, warm, in the same process, before each
// run. Both are processor times, so that other programs on the machine do not count.
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

/** The run of a case, by formula, package or folder; undefined if its model is missing. */
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

/** The medians of the runs' milliseconds and of U before them, and the last report. */
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
    if (runs > 1) await run(); // a warm-up for V8's compilers
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
