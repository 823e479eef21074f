// SPDX-License-Identifier: MIT
// The figures that README.md prints of named models: runs each again, and says which are others
// now. Medians are over seven neighbouring numbers of vertices, as README says.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

import { remeshFile } from 'remesher';

import { readText } from '../support/tree.js';
import { markdownTable } from './table.js';
import { median } from './yardstick.js';

/** Thousandths of the number of vertices. */
const steps = [-15, -10, -5, 0, 5, 10, 15];

/** Of a run, in the order of README's columns, with their digits. @type {[(report: any) => number,
 * number][]} */
const columns = [
  [({ output }) => output.minAngle.histogram.at(-1), 1],
  [({ output }) => output.minAngle.mean, 1],
  [({ output }) => output.minAngle.worst, 1],
  [({ fidelity }) => fidelity.hausdorff, 3],
  [({ fidelity }) => fidelity.rms, 4],
  [({ output }) => output.valence6, 0],
];

/** The rows of README's table. @param {string} text
 * @returns {{ model: string, vertices: number, scheme: string, figures: string[] }[]} */
export function tableRows(text) {
  const rows = [];
  for (const line of text.match(/^\| (\S+ → \d+)? ?\| (best|rounds) \|.+$/gm) ?? []) {
    const [name, scheme, ...figures] = line.split('|').slice(1, -1).map((cell) => cell.trim());
    const [model, vertices] = name ? name.split(' → ')
      : [rows.at(-1).model, rows.at(-1).vertices];
    rows.push({ model, vertices: Number(vertices), scheme, figures });
  }
  return rows;
}

/** What README's first program prints, with what follows it. @param {string} text */
export function printedExample(text) {
  const [, lines, medians] = /prints\n\n((?: {4}.+\n)+)\n\(([^)]+)\)/.exec(text) ?? [];
  return { lines: lines.replace(/^ {4}/gm, '').trim().split('\n'),
    medians: medians.match(/\d+\.\d+/g) };
}

const fileOf = (folder, model) => ['.obj', '.off'].map((extension) =>
  join(folder, `${model}${extension}`)).find((path) => existsSync(path));

async function reportsOf(path, vertices, scheme) {
  const bytes = readFileSync(path);
  const reports = [];
  for (const step of steps) {
    const { report } = await remeshFile(bytes, { name: path, output: 'a.obj', scheme,
      vertices: Math.round(vertices * (1 + step / 1000)) });
    reports.push(report);
  }
  return reports;
}

async function exampleOf(path) {
  const { bytes, report } = await remeshFile(readFileSync(path),
    { name: 'horse.obj', output: 'horse.glb', vertices: 10000 });
  const { output: { vertices, minAngle }, fidelity } = report;
  return [`${vertices} vertices, ${bytes.length} bytes`,
    `minimum angle: mean ${minAngle.mean.toFixed(1)}°, worst ${minAngle.worst.toFixed(1)}°`,
    `distance to the original: ${fidelity.hausdorff.toFixed(3)} % of the diagonal`];
}

/** @param {string | undefined} folder of the models */
export async function runReadme(folder) {
  const text = readText('docs/javascript.md') + readText('docs/quality.md');
  const rows = [], broken = [];
  const compare = (what, printed, now) => {
    rows.push([what, printed.join(' '), now.join(' ')]);
    if (printed.join() !== now.join()) broken.push(`${what}: ${printed} printed, ${now} now`);
  };
  for (const { model, vertices, scheme, figures } of tableRows(text)) {
    const path = folder && fileOf(folder, model);
    if (!path) continue;
    const reports = await reportsOf(path, vertices, scheme);
    const medians = columns.map(([of, digits]) => median(reports.map(of)).toFixed(digits));
    compare(`${model} → ${vertices} ${scheme}`, figures, medians);
    if (model !== 'horse' || scheme !== 'best') continue;
    const { lines, medians: said } = printedExample(text);
    compare('the example', lines, await exampleOf(path));
    const largest = Math.max(...reports.map(({ fidelity }) => fidelity.hausdorff)).toFixed(3);
    compare('its neighbours', said, [medians[1], medians[2], medians[3], largest]);
  }
  return { table: markdownTable(['figures', 'printed', 'now'], rows), broken };
}
