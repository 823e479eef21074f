// SPDX-License-Identifier: MIT
// Rows of the benchmark as Markdown, aligned, so that a terminal and the README can show it.

/** @param {string[]} names @param {(string | number | undefined)[][]} rows */
export function markdownTable(names, rows) {
  const cells = [names, ...rows.map((row) => row.map((value) => String(value ?? '–')))];
  const widths = names.map((_, column) => Math.max(...cells.map((row) => row[column].length)));
  const line = (row) => `| ${row.map((text, column) => (column === 0
    ? text.padEnd(widths[column]) : text.padStart(widths[column]))).join(' | ')} |`;
  const rule = `|${widths.map((width, column) => (column === 0
    ? '-'.repeat(width + 2) : `${'-'.repeat(width + 1)}:`)).join('|')}|`;
  return [line(cells[0]), rule, ...cells.slice(1).map(line)].join('\n');
}

/** @param {number | undefined} value @param {number} digits */
export function fixed(value, digits) {
  return value === undefined ? undefined : value.toFixed(digits);
}
