// SPDX-License-Identifier: MIT
// Remeshes a large model to larger ones, once each: time per vertex, and memory.
import { loadModel } from './models.js';
import { phaseTable } from './phases.js';
import { timeRemesh } from './run.js';
import { fixed, markdownTable } from './table.js';

const columns = ['case', 'vertices', 'time s', 'µs per vertex', 'memory MiB', 'worst °', 'mean °',
  '50–60° %', 'Hausdorff %', 'RMS %'];

/** @param {Record<string, any>} cases */
export async function runScale(cases) {
  const rows = [];
  const broken = [];
  const timed = [];
  for (const [name, limits] of Object.entries(cases)) {
    const { report, seconds, bytes } =
      await timeRemesh(loadModel(limits.model), { vertices: limits.vertices }, 1);
    const { vertices, minAngle } = report.output;
    rows.push([name, vertices, fixed(seconds, 2), fixed(1e6 * seconds / vertices, 1),
      fixed(bytes / 2 ** 20, 0), fixed(minAngle.worst, 1), fixed(minAngle.mean, 2),
      fixed(minAngle.histogram[5], 1), fixed(report.fidelity.hausdorff, 4),
      fixed(report.fidelity.rms, 5)]);
    timed.push({ name, phases: report.phases });
    console.log(rows.at(-1).join(' '));
    if (vertices !== limits.vertices) broken.push(`${name}: ${vertices} vertices`);
    if (seconds > limits.seconds) broken.push(`${name}: ${seconds.toFixed(2)} s`);
    if (bytes > limits.bytes) broken.push(`${name}: ${bytes} bytes`);
  }
  return { table: `${markdownTable(columns, rows)}\n\n${phaseTable(timed)}`, broken };
}
