// SPDX-License-Identifier: MIT
// Sizes of the code: modules in a folder, lines of a file, lines and parameters of a function. A
// header and its source are one module; a function without a name counts as part of the function
// around it.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

import { Linter } from 'eslint';

import { cppFunctions } from './cpp_functions.js';
import { filesUnder, readText, root } from './tree.js';

/** @typedef {{ name: string, line: number, lines: number, parameters: number }} FunctionSize */

/** The limits; `longFunctions` is the share of functions with more than `habit` lines. */
export const limits = {
  modules: 25, fileLines: 500, functionLines: 80, habit: 30, longFunctions: 0.2, parameters: 6,
};

/** A function's name, if it has one. */
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

/** The hash of the code that finds functions. */
const parser = createHash('sha256').update(process.version).update(
  ['tests/support/figures.js', 'tests/support/cpp_functions.js',
    'node_modules/.package-lock.json'].map(readText).join()).digest('hex');

/**
 * The functions of each file. Parsing JavaScript takes seconds, so the functions of a text are
 * remembered by its hash.
 * @param {string} top a folder
 * @param {readonly { path: string, text: string }[]} files
 */
function functionsOf(top, files) {
  const memory = join(root, 'build/checks');
  const place = join(memory, `functions-${top}.json`);
  const known = existsSync(place) ? JSON.parse(readFileSync(place, 'utf8')) : {};
  const found = new Map(files.map(({ path, text }) => {
    const hash = createHash('sha256').update(`${parser}${path}\n${text}`);
    const key = hash.digest('hex');
    return [key, known[key] ?? (path.endsWith('.js') ? jsFunctions(text) : cppFunctions(text))];
  }));
  mkdirSync(memory, { recursive: true });
  writeFileSync(place, JSON.stringify(Object.fromEntries(found)));
  return [...found.values()];
}

/** @param {string} top a folder @returns the sizes of each source file below it */
export function filesWithSizes(top) {
  const files = filesUnder(top, /\.(h|cpp|js)$/).map((path) => ({ path, text: readText(path) }));
  const functions = functionsOf(top, files);
  return files.map(({ path, text }, at) =>
    ({ path, lines: text.trimEnd().split('\n').length, functions: functions[at] }));
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

/** The share of functions longer than `habit` lines. @param {readonly FunctionSize[]} all */
export function shareOfLong(all) {
  return all.filter(({ lines }) => lines > limits.habit).length / all.length;
}
