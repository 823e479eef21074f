// SPDX-License-Identifier: MIT
// The share of runs whose quads an artist keeps: valid, on count, unfolded, near, and along the
// sharp edges, and in time. Each run that misses says why.
import { writeFileSync } from 'node:fs';

import { remesh } from 'remesher';

import { sharpEdgesKept } from './quad_edges.js';
import { countTurnedAway } from './quad_folds.js';
import { quadModels } from './quad_models.js';
import { evaluate } from './quads.js';
import { fixed, markdownTable } from './table.js';
import { median } from './yardstick.js';

const counts = [1000, 2500, 5000];

/** Within this share of the number, or the second where the structure needs it and that is said. */
const [exact, free, slack] = [0.01, 0.04, 1e-9];
/** In percent: of the diagonal, of the sharp edges. */
const [farthest, leastEdges] = [1, 95];
/** So many times as long as the horse at that number. */
const longest = 10;

const columns = ['model', 'asked', 'got', 'irregular', 'mean °', 'Jacobian ≥', 'Hausdorff %',
  'edges %', 'rows %', 'paired', 's', 'misses'];

/** Quads of a mesh by the package, and the processor's seconds. */
async function byPackage(mesh, vertices) {
  const start = process.cpuUsage();
  const { mesh: made, report } = await remesh(mesh, { quads: true, vertices, worker: false });
  return { mesh: made, report, seconds: process.cpuUsage(start).user / 1e6 };
}

function brokenKind({ input, output }) {
  if (output.nonManifoldEdges > 0) return ['not manifold'];
  if (input.nonManifoldEdges > 0 || input.degenerateTriangles > 0) return [];
  return ['components', 'eulerCharacteristic'].filter((name) => input[name] !== output[name])
    .map((name) => `${name} ${output[name]}, was ${input[name]}`);
}

function brokenCount({ output, warnings }, vertices) {
  const off = Math.abs(output.vertices / vertices - 1);
  const isSaid = warnings.some(({ code }) => code === 'QUADS_NUMBER_MISSED');
  const most = (isSaid ? free : exact) + slack;
  return off > most ? [`count ${output.vertices}`] : [];
}

/** The figures of a run, and what it misses. */
export function verdict(original, { mesh, report, seconds }, vertices) {
  const edges = sharpEdgesKept(original, mesh);
  const turned = countTurnedAway(original, mesh);
  const figures = { ...evaluate(mesh), ...edges, seconds, vertices: report.output.vertices,
    hausdorff: report.fidelity.hausdorff,
    paired: report.warnings.some(({ code }) => code === 'QUADS_PAIRED') };
  const misses = [...brokenKind(report), ...brokenCount(report, vertices),
    ...(turned > 0 ? [`${turned} turned away`] : []),
    ...(figures.hausdorff > farthest ? [`far ${fixed(figures.hausdorff, 2)}`] : []),
    ...(edges.kept < leastEdges ? [`edges ${fixed(edges.kept, 1)}`] : []),
    ...report.warnings.filter(({ code }) => code === 'QUADS_OFF_BORDER').map(() => 'border')];
  return { figures, misses };
}

/** The verdict on a run, which may be refused. */
async function judged(original, asked, make, name) {
  try {
    return verdict(original, await make(original, asked, name), asked);
  } catch (error) {
    return { figures: {}, misses: [`refused: ${error.code ?? error.message}`] };
  }
}

const rowOf = ({ name, asked, figures: f, misses }) => [name, asked, f.vertices, f.irregular,
  fixed(f.mean, 1), fixed(f.jacobian, 2), fixed(f.hausdorff, 2), fixed(f.kept, 1),
  fixed(f.rows, 0), f.paired ? 'paired' : '', fixed(f.seconds, 1), misses.join('; ')];

/** Times are misses beside the horse's, which runs first. */
function judgeTimes(runs) {
  for (const asked of counts) {
    const horse = runs.find((run) => run.name === 'horse' && run.asked === asked);
    if (!horse) continue;
    for (const run of runs) {
      const times = run.figures.seconds / horse.figures.seconds;
      if (run.asked === asked && times > longest) run.misses.push(`${fixed(times, 0)} × a horse`);
    }
  }
}

function summaryOf(runs) {
  const kept = runs.filter(({ misses }) => misses.length === 0);
  const middle = (name) => fixed(median(runs.map(({ figures }) => figures[name])
    .filter((value) => value !== undefined)), 2);
  const share = (100 * kept.length) / runs.length;
  return [`${kept.length} of ${runs.length} runs (${fixed(share, 1)} %) miss nothing.`,
    `Medians: irregular ${middle('irregular')}, mean angle ${middle('mean')}°, Hausdorff ${
      middle('hausdorff')} %, ripple ${middle('ripple')} %, ${middle('seconds')} s.`];
}

/** @param {{ folders: string[], names: string[], json?: string, numbers?: number[] }} how
 * @param {typeof byPackage} [make] */
export async function runQuadShare({ folders, names, json, numbers = counts }, make = byPackage) {
  const runs = [];
  const models = [...quadModels(folders)].sort(([a], [b]) => (b === 'horse') - (a === 'horse'));
  for (const [name, load] of models) {
    if (names.length > 0 && !names.some((word) => name.startsWith(word))) continue;
    const original = await load();
    for (const asked of numbers) {
      const run = { name, asked, ...await judged(original, asked, make, name) };
      runs.push(run);
      console.log(rowOf(run).join(' | '));
      if (json) writeFileSync(json, JSON.stringify(runs));
    }
  }
  judgeTimes(runs);
  const missing = runs.filter(({ misses }) => misses.length > 0);
  return { table: `${markdownTable(columns, runs.map(rowOf))}\n\n${summaryOf(runs).join('\n')}`,
    broken: missing.map(({ name, asked, misses }) => `${name} ${asked}: ${misses.join('; ')}`) };
}
