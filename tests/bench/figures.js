// SPDX-License-Identifier: MIT
// Prints the sizes of the code: modules in each folder, engines of a kind, named constants in each
// folder of the core, and for each tree the longest files, the longest functions, and the most
// parameters.
//   npm run figures
import { constantsOfRooms } from '../support/constants.js';
import { engineList, houseSizes } from '../support/engines.js';
import { filesWithSizes, folderSizes, limits, shareOfLong } from '../support/figures.js';
import { markdownTable } from './table.js';

const trees = ['src', 'bindings', 'web', 'tests'];
const shown = 5;
const files = trees.flatMap(filesWithSizes);

const within = (top) => files.filter(({ path }) => path.startsWith(`${top}/`));
const functionsOf = (some) => some.flatMap(({ path, functions }) =>
  functions.map((one) => ({ ...one, path })));
const largest = (items, size) =>
  [...items].sort((a, b) => size(b) - size(a)).slice(0, shown);

/** @param {string} title @param {string[]} names @param {(string | number)[][]} rows */
function print(title, names, rows) {
  console.log(`${title}\n\n${markdownTable(names, rows)}\n`);
}

print(`Folders (at most ${limits.modules} modules)`, ['folder', 'modules', 'files'],
  [...folderSizes(files)].map(([folder, size]) => [folder, size.modules, size.files]));

console.log(`Engines of a kind\n\n${engineList()}\n`);
print('The core', ['size', 'at first', 'today'], houseSizes());

print('Named constants', ['folder of src', 'constants'], constantsOfRooms());

print('Trees', ['tree', 'files', 'lines', 'functions', 'median', 'longest', `% > ${limits.habit}`],
  trees.map((top) => {
    const all = functionsOf(within(top));
    const lengths = all.map(({ lines }) => lines).sort((a, b) => a - b);
    return [top, within(top).length, within(top).reduce((sum, { lines }) => sum + lines, 0),
      all.length, lengths[lengths.length >> 1], lengths.at(-1),
      (100 * shareOfLong(all)).toFixed(1)];
  }));

for (const top of trees) {
  print(`${top}: longest files (at most ${limits.fileLines} lines)`, ['file', 'lines'],
    largest(within(top), ({ lines }) => lines).map(({ path, lines }) => [path, lines]));
  const row = (one) => [`${one.path}:${one.line} ${one.name}`, one.lines, one.parameters];
  const names = ['function', 'lines', 'parameters'];
  const all = functionsOf(within(top));
  print(`${top}: longest functions (at most ${limits.functionLines} lines)`, names,
    largest(all, ({ lines }) => lines).map(row));
  print(`${top}: most parameters (at most ${limits.parameters})`, names,
    largest(all, ({ parameters }) => parameters).map(row));
}
