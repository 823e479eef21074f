// SPDX-License-Identifier: MIT
// Machine parts at multiples of their own number of vertices, beside other programs, and at the
// numbers that limits are for. How near and how even a result is changes with every vertex more, so
// that each row is of seven neighbouring numbers: the median, and the worst.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import { convertFile, inspect } from 'remesher';

import * as made from '../support/machine_parts.js';
import { judge } from './judge.js';
import { readOff } from './models.js';
import { neighboursOf, summed } from './neighbours.js';
import { meshoptimizer, peers } from './peers.js';
import { timeRemesh } from './run.js';
import { fixed, markdownTable } from './table.js';
import { median } from './yardstick.js';

const columns = ['part', 'by', 'vertices', 'mean °', '(worst)', 'smallest °', '(worst)',
  'Hausdorff %', '(worst)', 'RMS %', 's'];

const multiples = [0.5, 1, 3, 10];

const stem = (path) => basename(path).replace(/\.[^.]*$/, '');

/** Paths of files below a folder of models. @param {string | undefined} folder */
function filesOf(folder) {
  if (!folder) return [];
  const inside = existsSync(join(folder, 'parts')) ? readdirSync(join(folder, 'parts')) : [];
  const paths = [...inside.sort().map((name) => join('parts', name)), 'fandisk.obj'];
  return paths.map((path) => join(folder, path)).filter((path) => existsSync(path));
}

/** All parts by their names. @param {string | undefined} folder */
async function partsOf(folder) {
  const parts = Object.entries(made).map(([name, make]) => [name, make()]);
  for (const path of filesOf(folder)) {
    const { bytes } = await convertFile(readFileSync(path),
      { name: basename(path), output: 'off' });
    parts.push([stem(path), readOff(new TextDecoder().decode(bytes))]);
  }
  return new Map(parts);
}

/** The figures of a result, or of several. @param {{ result: any, fidelity: any }[]} all */
const figuresOf = (all) => summed(all.map(({ result, fidelity }) => ({ ...result, ...fidelity })));

function rowOf(name, by, { vertices, meanAngle, worstAngle, hausdorff, rms }, seconds) {
  return [name, by, vertices.median, ...[meanAngle, worstAngle].flatMap((angle) =>
    [fixed(angle.median, 1), fixed(angle.worst, 1)]), fixed(hausdorff.median, 3),
  fixed(hausdorff.worst, 3), fixed(rms.median, 4), fixed(seconds, 2)];
}

/** Ours, at the number and its neighbours. */
async function atNeighbours(mesh, { vertices, ...options }) {
  const runs = [];
  for (const wanted of neighboursOf(vertices)) {
    runs.push(await timeRemesh(mesh, { vertices: wanted, ...options }, 1));
  }
  return { summary: figuresOf(runs.map((run) => judge(mesh, run.mesh))),
    seconds: median(runs.map(({ seconds }) => seconds)) };
}

/** What is not as much better than meshoptimizer's of as many triangles as it should be. */
function brokenBeside(ours, other, limits) {
  return ['hausdorff', 'rms', 'meanAngle'].filter((name) => {
    const times = ours[name].median / other[name].median;
    return name === 'meanAngle' ? times < limits[name] : times > limits[name];
  }).map((name) => `${name} ${(ours[name].median / other[name].median).toFixed(2)} × its`);
}

/** Vertices where shape needs them, beside what meshoptimizer makes of as many triangles. */
async function rowsOfShape(name, mesh, { vertices, limits }) {
  const run = await timeRemesh(mesh, { vertices, prefer: 'shape' }, 1);
  const other = await meshoptimizer(mesh, run.mesh.indices.length / 3);
  const [ours, theirs] = [run.mesh, other.mesh].map((result) => figuresOf([judge(mesh, result)]));
  return {
    rows: [rowOf(name, 'remesher prefer shape', ours, run.seconds),
      rowOf(name, 'meshoptimizer', theirs, other.seconds)],
    broken: brokenBeside(ours, theirs, limits).map((what) => `${name}, meshoptimizer: ${what}`),
  };
}

function rowsOfPeers(name, mesh, vertices) {
  const found = Object.entries(peers).map(([by, make]) => [by, make(mesh, vertices)]);
  return found.filter(([, result]) => result).map(([by, result]) =>
    rowOf(name, by, figuresOf([judge(mesh, result.mesh)]), result.seconds));
}

function brokenLimits({ meanAngle, worstAngle, hausdorff }, limits) {
  const broken = [];
  const least = { meanAngle, worstAngle };
  for (const [name, value] of Object.entries(least)) {
    if (value.median < limits[name]) {
      broken.push(`${name} ${value.median.toFixed(2)}, not ${limits[name]}`);
    }
  }
  if (hausdorff.median > limits.hausdorff) {
    broken.push(`Hausdorff ${hausdorff.median.toFixed(4)} %, not ${limits.hausdorff}`);
  }
  return broken;
}

/** Everything on the way is printed, for all of it takes long.
 * @param {Record<string, any>} limits @param {{ folder?: string, names: string[] }} how */
export async function runParts(limits, { folder, names }) {
  const rows = [];
  const broken = [];
  const parts = await partsOf(folder);
  const isWanted = (name) => names.length === 0 || names.some((word) => name.startsWith(word));
  const add = (more) => {
    rows.push(...more);
    for (const row of more) console.log(row.join(' '));
  };
  const measure = async (name, mesh, { vertices, ...row }) => {
    const { summary, seconds } = await atNeighbours(mesh, { vertices, ...row.options });
    const by = Object.entries(row.options ?? {}).flat().join(' ');
    add([rowOf(name, `remesher ${by}`, summary, seconds)]);
    broken.push(...brokenLimits(summary, row).map((what) => `${name}: ${what}`));
  };
  for (const [name, row] of Object.entries(limits.rows)) {
    const mesh = parts.get(row.part);
    if (mesh && isWanted(name)) await measure(name, mesh, row);
  }
  for (const [part, mesh] of parts) {
    const { input } = await inspect(mesh, { worker: false });
    for (const times of multiples) {
      const name = `${part} × ${times}`;
      if (!isWanted(name)) continue;
      const vertices = Math.round(times * input.vertices);
      const row = times === 1 ? limits.own[part] : {};
      await measure(name, mesh, { vertices, ...row });
      if (times < 1) {
        const shape = await rowsOfShape(name, mesh, { vertices, limits: limits.beside });
        add(shape.rows);
        broken.push(...shape.broken);
      }
      add(rowsOfPeers(name, mesh, vertices));
    }
  }
  return { table: markdownTable(columns, rows), broken };
}
