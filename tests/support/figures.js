// SPDX-License-Identifier: MIT
// Sizes: modules in a folder, lines of a file, lines and parameters of a function. A header and its
// source are one module; a function that has no name is part of the one it stands in.
import { dirname } from 'node:path';

import { Linter } from 'eslint';

import { cppFunctions } from './cpp_functions.js';
import { filesUnder, readText } from './tree.js';

/** @typedef {{ name: string, line: number, lines: number, parameters: number }} FunctionSize */

/** What the house allows; `longFunctions` is a share, of more than `habit` lines. */
export const limits = {
  modules: 15, fileLines: 400, functionLines: 60, habit: 30, longFunctions: 0.1, parameters: 4,
};

/** The name under which a function is known, if it has one. */
function nameOf({ id, parent }) {
  const given = id ?? (parent.type === 'VariableDeclarator' ? parent.id : parent.key);
  return given?.name;
}

/** @param {string} text @returns {FunctionSize[]} in their order */
export function jsFunctions(text) {
  const found = [];
  const note = (node) => {
    const name = nameOf(node);
    if (!name) return;
    const { start, end } = node.loc;
    found.push({ name, line: start.line, lines: end.line - start.line + 1,
      parameters: node.params.length });
  };
  const plugin = { rules: { note: { create: () => ({ ':function': note }) } } };
  const messages = new Linter().verify(text.replace(/^#!/, '//'),
    { plugins: { figures: plugin }, rules: { 'figures/note': 'error' } });
  const [fatal] = messages.filter((message) => message.fatal);
  if (fatal) throw new Error(`line ${fatal.line}: ${fatal.message}`);
  return found;
}

/** @param {string} top a folder @returns the sizes of each source file below it */
export function filesWithSizes(top) {
  return filesUnder(top, /\.(h|cpp|js)$/).map((path) => {
    const text = readText(path);
    return {
      path,
      lines: text.trimEnd().split('\n').length,
      functions: path.endsWith('.js') ? jsFunctions(text) : cppFunctions(text),
    };
  });
}

/**
 * @param {readonly { path: string }[]} files
 * @returns {Map<string, { files: number, modules: number }>} by folder
 */
export function folderSizes(files) {
  const sizes = new Map();
  for (const folder of new Set(files.map(({ path }) => dirname(path)))) {
    const own = files.map(({ path }) => path).filter((path) => dirname(path) === folder);
    const modules = new Set(own.map((path) => path.replace(/\.(h|cpp)$/, '')));
    sizes.set(folder, { files: own.length, modules: modules.size });
  }
  return sizes;
}

/** The share of functions that are longer than the habit. @param {readonly FunctionSize[]} all */
export function shareOfLong(all) {
  return all.filter(({ lines }) => lines > limits.habit).length / all.length;
}
