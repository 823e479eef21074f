// SPDX-License-Identifier: MIT
// What compilers say of C++ files without building them, one process per core. A file found clean
// is looked at again only when something that the tool reads has changed: the file, our headers in
// it, the rules, the flags, the tool, the libraries.
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
/** Of each library the header that holds its version. */
export const versions = ['Eigen/src/Core/util/Macros.h', 'fast_float/fast_float.h',
  'nlohmann/json.hpp', 'tiny_gltf.h', 'doctest/doctest.h']
  .map((header) => `${libraries}/${header}`);
const includes = [...includeFolders.map((name) => `-I${name}`), '-isystem', libraries];
/** The warnings are those of the build. */
const warnings = () => readText('CMakeLists.txt').match(/-Wall[^)]*/)[0].trim().split(/\s+/);

/**
 * @typedef {object} Tool
 * @property {string} command
 * @property {string[]} rules files that say what it looks for
 * @property {(file: string) => string[]} words how it is called
 * @property {(file: string) => string[]} within names in a file that are not its company's
 */

/** @type {Tool} */
export const clangTidy = {
  command: 'clang-tidy', rules: ['.clang-tidy'],
  words: (file) => ['--quiet', file, '--', '-std=c++20', ...includes],
  within: namesInHeaders,
};

/** Its garbage collector takes a fifth of the time. */
const unswept = ['--param', `ggc-min-heapsize=${4 * 2 ** 20}`];

/**
 * g++ warns of what clang++ does not; its code is built for the benchmark only. What one file of
 * several keeps to itself it takes for what all of them share.
 * @type {Tool}
 */
export const gcc = {
  command: 'g++', rules: [],
  words: (file) => [...unswept, '-std=c++20', '-fsyntax-only', '-Werror', ...warnings(),
    '-Wno-subobject-linkage', ...includes, file],
  within: (file) => [...namesInHeaders(file), ...innerConstants(readText(file))],
};

/** What all files have in common that a tool reads. @param {Tool} tool */
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

/** Where to include a file from that is in company: a copy if others may have names of its own. */
function placeInCompany(/** @type {string} */ file) {
  const text = textInCompany(file);
  if (text === readText(file)) return join(root, file);
  const copy = join(folder, 'company', file);
  mkdirSync(dirname(copy), { recursive: true });
  // Another run may be reading it: it is never empty for a moment.
  if (!existsSync(copy) || readFileSync(copy, 'utf8') !== text) writeFileSync(copy, text);
  return copy;
}

/**
 * Of files as one. If there are complaints each half is asked for by itself, down to single files,
 * so that none comes of the company.
 * @param {Tool} tool @param {string[]} files
 * @returns {Promise<{ clean: string[], said: string[] }>} clean files, what is said of the others
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
