// SPDX-License-Identifier: MIT
// The rows of the report's Table 1 beside ours: scheme rounds, with the fidelity of its program.
import { brokenPromises, judge } from './judge.js';
import { loadModel } from './models.js';
import { timeRemesh } from './run.js';
import { fixed, markdownTable } from './table.js';

const columns = ['name', 'vertex #', 'run time s', '0–10', '10–20', '20–30', '30–40', '40–50',
  '50–60', 'Hausdorff %'];

const below30 = (histogram) => histogram[0] + histogram[1] + histogram[2];

function optionsOf(row) {
  const options = { scheme: 'rounds', fidelity: 'loose', projection: row.projection ?? 'patches' };
  return row.splitObtuse ? { ...options, splitObtuse: true }
    : { ...options, vertices: row.vertices };
}

function brokenLimits(row, limits, { result, fidelity }) {
  const broken = [];
  const most = limits.below30Factor * below30(row.histogram) + limits.below30Slack;
  const least = row.histogram[5] - limits.above50Slack;
  if (result.below30 > most) broken.push(`${fixed(result.below30, 2)} % under 30°, not ${most}`);
  if (result.above50 < least) broken.push(`${fixed(result.above50, 2)} % in 50–60°, not ${least}`);
  if (fidelity.hausdorff > limits.hausdorff) broken.push(`Hausdorff ${fidelity.hausdorff} %`);
  if (Math.abs(result.vertices / row.vertices - 1) > limits.verticesSlack) {
    broken.push(`${result.vertices} vertices, not about ${row.vertices}`);
  }
  return broken;
}

/** Checks that with the current mesh as the reference the surface shrinks, and that patches cost
 * little more time. */
function brokenComparison(row, limits, own, other) {
  const broken = [];
  if (own.hausdorff <= other.hausdorff) broken.push(`no farther off than ${row.worseThan}`);
  if (other.seconds > limits.currentSlowdown * own.seconds) {
    broken.push(`${row.worseThan} takes ${fixed(other.seconds / own.seconds, 2)} × its time`);
  }
  return broken;
}

async function runRow(row, limits, folder) {
  const mesh = loadModel(row.model, folder);
  const { mesh: result, seconds } = await timeRemesh(mesh, optionsOf(row), 1);
  const judgement = judge(mesh, result);
  const vertices = row.splitObtuse ? judgement.result.vertices : row.vertices;
  const broken = brokenPromises(judgement, vertices);
  if (!row.worseThan) broken.push(...brokenLimits(row, limits, judgement));
  return { seconds, broken, ...judgement.result, hausdorff: judgement.fidelity.hausdorff };
}

export async function runTable1(limits, folder) {
  if (!folder) throw new Error('table1 needs the folder of the report’s models.');
  const rows = [];
  const broken = [];
  const outcomes = new Map();
  for (const [name, row] of Object.entries(limits.rows)) {
    const outcome = await runRow(row, limits, folder);
    outcomes.set(name, outcome);
    if (row.worseThan) {
      outcome.broken.push(...brokenComparison(row, limits, outcome, outcomes.get(row.worseThan)));
    }
    rows.push([`${name}, report`, row.vertices, fixed(row.seconds, 2),
      ...row.histogram.map((share) => fixed(share, 2)), undefined]);
    rows.push([`${name}, ours`, outcome.vertices, fixed(outcome.seconds, 2),
      ...outcome.histogram.map((share) => fixed(share, 2)), fixed(outcome.hausdorff, 3)]);
    console.log(rows.at(-1).join(' '));
    broken.push(...outcome.broken.map((what) => `${name}: ${what}`));
  }
  return { table: markdownTable(columns, rows), broken };
}
