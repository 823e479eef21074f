// SPDX-License-Identifier: MIT
// Checks C++ files with compilers, without building them, one process per core. A clean file is
// checked again only if something that the tool reads has changed: the file, our headers in it, the
// rules, the flags, the tool, the libraries.
import { execFile, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { dirname, join } from 'node:path';
import { promisify } from 'node:util';

import { inCompany, innerConstants, namesInHeaders, textInCompany } from './company.js';
import { includeFolders, withIncludes } from './cpp_sources.js';
import { readText, root } from './tree.js';

const folder = join(root, 'build/checks');
const libraries = 'build/test/deps-include';
/** The header of each library that has its version. */
export const versions = ['Eigen/src/Core/util/Macros.h', 'fast_float/fast_float.h',
  'nlohmann/json.hpp', 'tiny_gltf.h', 'doctest/doctest.h']
  .map((header) => `${libraries}/${header}`);
const includes = [...includeFolders.map((name) => `-I${name}`), '-isystem', libraries];
/** The warning flags of the build. */
const warnings = () => readText('CMakeLists.txt').match(/-Wall[^)]*/)[0].trim().split(/\s+/);

/**
 * @typedef {object} Tool
 * @property {string} command
 * @property {string[]} rules files that configure its checks
 * @property {(file: string) => string[]} words its arguments
 * @property {(file: string) => string[]} within names in a file that its company may not define
 */

/** @type {Tool} */
export const clangTidy = {
  command: 'clang-tidy', rules: ['.clang-tidy'],
  words: (file) => ['--quiet', file, '--', '-std=c++20', ...includes],
  within: namesInHeaders,
};

/** Turns off g++'s garbage collector, which takes a fifth of the time. */
const unswept = ['--param', `ggc-min-heapsize=${4 * 2 ** 20}`];

/**
 * g++ has warnings that clang++ lacks; g++ builds the code for the benchmark only. In a file that
 * includes several others, g++ takes the private names of one for names that all of them share.
 * @type {Tool}
 */
export const gcc = {
  command: 'g++', rules: [],
  words: (file) => [...unswept, '-std=c++20', '-fsyntax-only', '-Werror', ...warnings(),
    '-Wno-subobject-linkage', ...includes, file],
  within: (file) => [...namesInHeaders(file), ...innerConstants(readText(file))],
};

/** A hash of everything that a tool reads for every file. @param {Tool} tool */
function surroundings(tool) {
  const hash = createHash('sha256').update(tool.words('').join(' '));
  for (const command of new Set([tool.command, 'g++'])) {
    hash.update(spawnSync(command, ['--version']).stdout);
  }
  for (const file of [...tool.rules, ...versions]) hash.update(readText(file));
  return hash.digest();
}

function keyOf(file, common) {
  const hash = createHash('sha256').update(common);
  for (const part of withIncludes(file)) hash.update(part).update(readText(part));
  return join(folder, hash.digest('hex'));
}

/** @param {Tool} tool @param {string} file @returns {Promise<string>} its complaints */
async function ask(tool, file) {
  try {
    await promisify(execFile)(tool.command, tool.words(file), { cwd: root, maxBuffer: 2 ** 28 });
    return '';
  } catch (error) {
    return error.stdout || error.stderr || String(error);
  }
}

/** The path by which to include a file in company: a copy if private names were changed. */
function placeInCompany(/** @type {string} */ file) {
  const text = textInCompany(file);
  if (text === readText(file)) return join(root, file);
  const copy = join(folder, 'company', file);
  mkdirSync(dirname(copy), { recursive: true });
  // Another run may be reading the copy: an unchanged copy is not written again, which would empty
  // it for a moment.
  if (!existsSync(copy) || readFileSync(copy, 'utf8') !== text) writeFileSync(copy, text);
  return copy;
}

/**
 * Checks files as one. If there are complaints, each half is checked alone, down to single files,
 * so that no complaint comes from the company.
 * @param {Tool} tool @param {string[]} files
 * @returns {Promise<{ clean: string[], said: string[] }>} clean files; complaints on the others
 */
async function askTogether(tool, files) {
  if (files.length === 1) {
    const said = await ask(tool, files[0]);
    return said ? { clean: [], said: [said] } : { clean: files, said: [] };
  }
  const name = createHash('sha256').update(files.join()).digest('hex').slice(0, 16);
  const whole = join(folder, `${name}.cpp`);
  const lines = files.map((file) => `#include "${placeInCompany(file)}"  // NOLINT\n`);
  writeFileSync(whole, lines.join(''));
  if (await ask(tool, whole) === '') return { clean: files, said: [] };
  const half = files.length / 2;
  const parts = [await askTogether(tool, files.slice(0, half)),
    await askTogether(tool, files.slice(half))];
  return { clean: parts.flatMap(({ clean }) => clean), said: parts.flatMap(({ said }) => said) };
}

/**
 * @param {Tool} tool
 * @param {readonly string[]} files
 * @returns {Promise<string>} complaints, as the tool words them; empty if there are none
 */
export async function complaintsOf(tool, files) {
  mkdirSync(folder, { recursive: true });
  const common = surroundings(tool);
  const keys = new Map(files.map((file) => [file, keyOf(file, common)]));
  const groups = inCompany(files.filter((file) => !existsSync(keys.get(file))),
    textInCompany, tool.within);
  const complaints = [];
  const worker = async () => {
    for (let group = groups.shift(); group; group = groups.shift()) {
      const { clean, said } = await askTogether(tool, group);
      clean.forEach((file) => writeFileSync(keys.get(file), ''));
      complaints.push(...said);
    }
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  return complaints.join('\n');
}
