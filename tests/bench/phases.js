// SPDX-License-Identifier: MIT
// The time of runs by the phases of their reports.
import { fixed, markdownTable } from './table.js';

/** Milliseconds, and their share of the run. */
function cell(phases, name) {
  const total = phases.reduce((sum, { milliseconds }) => sum + milliseconds, 0);
  const phase = phases.find((one) => one.name === name);
  return phase
    && `${fixed(phase.milliseconds, 0)} (${fixed(100 * phase.milliseconds / total, 0)} %)`;
}

/**
 * A row for each phase, a column for each run.
 * @param {{ name: string, phases: { name: string, milliseconds: number }[] }[]} runs
 */
export function phaseTable(runs) {
  const names = [...new Set(runs.flatMap(({ phases }) => phases.map(({ name }) => name)))];
  return markdownTable(['ms in', ...runs.map(({ name }) => name)],
    names.map((name) => [name, ...runs.map(({ phases }) => cell(phases, name))]));
}
