// SPDX-License-Identifier: MIT
// Both schemes on every case, with the limits that `best` has to keep.
import { brokenPromises, judge } from './judge.js';
import { loadModel } from './models.js';
import { phaseTable } from './phases.js';
import { timeRemesh } from './run.js';
import { fixed, markdownTable } from './table.js';
import { timeYardstick } from './yardstick.js';

const columns = ['case', 'scheme', 'vertices', 'time s', '× yardstick', 'memory MiB', 'worst °',
  'mean °', '< 30° %', '50–60° %', 'valence 6 %', 'Hausdorff %', 'RMS %', 'intersecting'];

const atLeast = ['above50', 'meanAngle', 'worstAngle', 'valence6'];
const atMost = ['hausdorff', 'rms', 'timesYardstick'];

function brokenLimits(limits, values) {
  return [
    ...atLeast.filter((name) => values[name] < limits[name])
      .map((name) => `${name} ${values[name].toFixed(3)} < ${limits[name]}`),
    ...atMost.filter((name) => values[name] > limits[name])
      .map((name) => `${name} ${values[name].toFixed(4)} > ${limits[name]}`),
  ];
}

async function runScheme(mesh, limits, { scheme, runs, yardstick }) {
  const { mesh: result, report, seconds, bytes } =
    await timeRemesh(mesh, { vertices: limits.vertices, scheme }, runs);
  const judgement = judge(mesh, result);
  const values = { ...judgement.result, ...judgement.fidelity,
    timesYardstick: yardstick && seconds / yardstick };
  const broken = brokenPromises(judgement, limits.vertices);
  if (scheme === 'best') broken.push(...brokenLimits(limits, values));
  if (scheme === 'rounds' && seconds > limits.roundsSeconds) {
    broken.push(`${seconds.toFixed(2)} s > ${limits.roundsSeconds}`);
  }
  const row = [scheme, values.vertices, fixed(seconds, 3), fixed(values.timesYardstick, 1),
    fixed(bytes / 2 ** 20, 0), fixed(values.worstAngle, 1), fixed(values.meanAngle, 2),
    fixed(values.below30, 2), fixed(values.above50, 1), fixed(values.valence6, 1),
    fixed(values.hausdorff, 3), fixed(values.rms, 4), values.selfIntersections];
  return { row, broken, phases: report.phases };
}

/** @param {Record<string, any>} cases */
export async function runCases(cases, { folder, names, runs }) {
  const rows = [];
  const broken = [];
  const timed = [];
  for (const [name, limits] of Object.entries(cases)) {
    if (names.length > 0 && !names.some((wanted) => name.startsWith(wanted))) continue;
    const mesh = loadModel(limits.model, folder);
    if (!mesh) continue;
    const yardstick = await timeYardstick(mesh, limits.vertices, runs);
    for (const scheme of ['best', 'rounds']) {
      const outcome = await runScheme(mesh, limits, { scheme, runs, yardstick });
      rows.push([name, ...outcome.row]);
      timed.push({ name: `${name} ${scheme}`, phases: outcome.phases });
      broken.push(...outcome.broken.map((what) => `${name} ${scheme}: ${what}`));
      console.log(`${name} ${outcome.row.join(' ')}`);
    }
  }
  return { table: `${markdownTable(columns, rows)}\n\n${phaseTable(timed)}`, broken };
}
