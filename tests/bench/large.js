// SPDX-License-Identifier: MIT
// Inputs of millions of triangles to 50,000 vertices, beside meshoptimizer's simplify on the same
// arrays, each in a process of its own. The peak is that of the process, with the input; the row
// without a program is what making the input takes.
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

import { fixed, markdownTable } from './table.js';

const one = fileURLToPath(new URL('large_one.js', import.meta.url));
const columns = ['input', 'million triangles', 'program', 'CPU s', '× meshoptimizer',
  'process MiB', 'WebAssembly MiB', 'vertices', 'Hausdorff %', 'refused'];

const mebibytes = (bytes) => (bytes === undefined ? '' : fixed(bytes / 2 ** 20, 0));

function measured(input, { triangles, vertices }, program) {
  const printed = execFileSync(process.execPath,
    [one, input, String(triangles), String(vertices), program], { encoding: 'utf8' });
  return JSON.parse(printed);
}

function rowOf({ input, program }, run, yardstick) {
  return [input, fixed(run.triangles / 1e6, 1), program, fixed(run.seconds, 1),
    fixed(run.seconds / yardstick, 1), mebibytes(run.peak), mebibytes(run.bytes),
    run.vertices ?? '', run.hausdorff === undefined ? '' : fixed(run.hausdorff, 4),
    run.message ?? ''];
}

function brokenIn(name, run, limits) {
  if (run.code && run.code !== 'OUT_OF_MEMORY') return [`${name}: ${run.code} ${run.message}`];
  if (run.code) return limits.mayBeRefused ? [] : [`${name}: refused`];
  const broken = [];
  if (run.vertices !== limits.vertices) broken.push(`${name}: ${run.vertices} vertices`);
  if (run.boundary !== (limits.input === 'openScan')) broken.push(`${name}: boundaries`);
  return broken;
}

/** @param {Record<string, any>} cases @param {string[]} names all if empty */
export function runLarge(cases, names) {
  const rows = [];
  const broken = [];
  for (const [name, limits] of Object.entries(cases)) {
    if (names.length > 0 && !names.some((wanted) => name.startsWith(wanted))) continue;
    const yardstick = measured(limits.input, limits, 'meshoptimizer');
    for (const program of ['none', 'remesher', 'meshoptimizer']) {
      const run = program === 'meshoptimizer' ? yardstick
        : measured(limits.input, limits, program);
      if (program === 'remesher') broken.push(...brokenIn(name, run, limits));
      rows.push(rowOf({ input: limits.input, program }, run, yardstick.seconds));
      console.log(rows.at(-1).join(' '));
    }
  }
  return { table: markdownTable(columns, rows), broken };
}
