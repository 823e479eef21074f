// SPDX-License-Identifier: MIT
// Runs both schemes on every case, each at seven neighbouring numbers of vertices. The medians and
// the worst figures of `best` must keep the limits.
import { brokenPromises, judge } from './judge.js';
import { loadModel } from './models.js';
import { neighboursOf, summed } from './neighbours.js';
import { phaseTable } from './phases.js';
import { timeRemesh } from './run.js';
import { fixed, markdownTable } from './table.js';
import { timeYardstick } from './yardstick.js';

const columns = ['case', 'scheme', 'vertices', 'time s', '× yardstick', 'memory MiB', 'worst °',
  '(worst)', 'mean °', '(worst)', '50–60° %', '(worst)', 'valence 6 %', 'Hausdorff %', '(worst)',
  'RMS %', '(worst)'];

const atLeast = ['above50', 'meanAngle', 'worstAngle', 'valence6'];
const atMost = ['hausdorff', 'rms'];

/**
 * @param {Record<string, number>} limits
 * @param {(name: string) => number} read
 * @param {string} of words for the message: the median or the worst of seven
 */
function brokenLimits(limits, read, of) {
  return [
    ...atLeast.filter((name) => read(name) < limits[name])
      .map((name) => `${name} ${of} ${read(name).toFixed(3)} < ${limits[name]}`),
    ...atMost.filter((name) => read(name) > limits[name])
      .map((name) => `${name} ${of} ${read(name).toFixed(4)} > ${limits[name]}`),
  ];
}

/** The broken limits of the medians, of the worst figures, and of the time. */
function brokenOfBest(limits, figures, timesYardstick) {
  return [
    ...brokenLimits(limits, (name) => figures[name].median, 'in the median'),
    ...brokenLimits(limits.worst ?? {}, (name) => figures[name].worst, 'in the worst'),
    ...(timesYardstick > limits.timesYardstick
      ? [`${timesYardstick.toFixed(1)} × the yardstick > ${limits.timesYardstick}`] : []),
  ];
}

/** Runs a number of vertices and its neighbours; only the number itself is timed. */
async function runScheme(mesh, limits, { scheme, runs, yardstick }) {
  const { vertices } = limits;
  const { report, seconds, bytes } = await timeRemesh(mesh, { vertices, scheme }, runs);
  const broken = [];
  const all = [];
  for (const wanted of neighboursOf(vertices)) {
    const run = await timeRemesh(mesh, { vertices: wanted, scheme }, 1);
    const judgement = judge(mesh, run.mesh);
    broken.push(...brokenPromises(judgement, wanted));
    all.push({ ...judgement.result, ...judgement.fidelity });
  }
  const figures = summed(all);
  if (scheme === 'best') {
    broken.push(...brokenOfBest(limits, figures, yardstick && seconds / yardstick));
  }
  if (scheme === 'rounds' && seconds > limits.roundsSeconds) {
    broken.push(`${seconds.toFixed(2)} s > ${limits.roundsSeconds}`);
  }
  const both = (/** @type {string} */ name, /** @type {number} */ digits) =>
    [fixed(figures[name].median, digits), fixed(figures[name].worst, digits)];
  const row = [scheme, vertices, fixed(seconds, 3), fixed(yardstick && seconds / yardstick, 1),
    fixed(bytes / 2 ** 20, 0), ...both('worstAngle', 1), ...both('meanAngle', 2),
    ...both('above50', 1), fixed(figures.valence6.median, 1), ...both('hausdorff', 3),
    ...both('rms', 4)];
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
