// SPDX-License-Identifier: MIT
// Builds the core with CMake and Ninja: the WebAssembly modules, the unit tests, the fuzzer and the
// measuring tools.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { findClang, findEmscripten, findSanitizingClang } from './needs.js';
import { ask, root, run, say } from './say.js';
import { includeFolders, isKnown } from './system.js';

/** @typedef {import('./system.js').System} System */

/**
 * The definitions that depend on the system: the folders of headers, and, for compilers that we do
 * not know, warnings that are no errors.
 * @param {System} system
 */
export function commonDefinitions(system) {
  return [
    `-DREMESHER_INCLUDE=${includeFolders(system).join(';')}`,
    '-DREMESHER_UNITY=ON', '-DREMESHER_PRECOMPILE=ON',
    ...(isKnown(system) ? [] : ['-DCMAKE_COMPILE_WARNING_AS_ERROR=OFF']),
  ];
}

/** @param {System} system */
export function wasmDefinitions(system) {
  return [`-DCMAKE_TOOLCHAIN_FILE=${findEmscripten(system)}`, '-DCMAKE_BUILD_TYPE=Release'];
}

/** @param {string | undefined} clang */
const nativeDefinitions = (clang) => [
  '-DCMAKE_BUILD_TYPE=Debug', ...(clang ? [`-DCMAKE_CXX_COMPILER=${clang}`] : [])];

/** Line numbers would take a seventh of the time to compile. @param {System} system */
export const testDefinitions = (system) => [...nativeDefinitions(findClang(system)),
  '-DREMESHER_CHECK=ON', '-DCMAKE_CXX_FLAGS_DEBUG='];

/** @param {System} system */
export const sanitizedDefinitions = (system) => [
  ...nativeDefinitions(findSanitizingClang(system)),
  '-DREMESHER_SANITIZE=ON', '-DCMAKE_CXX_FLAGS_DEBUG=-gline-tables-only'];

/**
 * @typedef {object} Target
 * @property {string} what
 * @property {string} folder
 * @property {readonly string[]} names
 * @property {readonly string[]} definitions
 * @property {boolean} [givesWay]
 */

/**
 * Configures a folder. With other definitions the folder begins anew, because CMake cannot change a
 * compiler in place.
 * @param {Target} target
 */
async function configure({ folder, definitions }) {
  const record = join(root, folder, 'configured');
  const words = definitions.join('\n');
  const isSame = existsSync(record) && readFileSync(record, 'utf8') === words;
  if (isSame && existsSync(join(root, folder, 'build.ninja'))) return;
  await run('cmake', ['--fresh', '-G', 'Ninja', '-S', '.', '-B', folder, ...definitions]);
  writeFileSync(record, words);
}

/** @param {Target} target */
async function buildTarget(target) {
  await configure(target);
  if (ask('ninja', ['-C', target.folder, '-n', ...target.names]).includes('no work to do')) return;
  say(`Building ${target.what}`);
  await run('ninja', ['-C', target.folder, ...target.names], { givesWay: target.givesWay });
}

/** @param {System} system */
export const buildWebAssembly = (system) => buildTarget({
  what: 'the WebAssembly modules', folder: 'build/wasm', names: ['remesher', 'remesher_arrays'],
  definitions: [...commonDefinitions(system), ...wasmDefinitions(system)],
});

/**
 * The steps after compiling the module, its linking and the package's types, use one core. They
 * begin as early as possible, and the unit tests, which give way, fill the other cores.
 * @param {System} system
 */
const unitTests = (system) => ({
  what: 'the unit tests, with checks', folder: 'build/test', names: ['unit_tests'], givesWay: true,
  definitions: [...commonDefinitions(system), ...testDefinitions(system)],
});

/** @param {System} system */
export const buildProfile = (system) => buildTarget({
  what: 'the WebAssembly module with names', folder: 'build/profile', names: ['remesher_arrays'],
  definitions: [...commonDefinitions(system), ...wasmDefinitions(system),
    '-DCMAKE_EXE_LINKER_FLAGS=--profiling-funcs'],
});

/** @param {System} system */
export const buildUnitTests = (system) => buildTarget(unitTests(system));

/** In the same folder, so not side by side with the unit tests. @param {System} system */
export const buildLibrary = (system) => buildTarget({
  ...unitTests(system), what: 'the native library and the targets of the fuzzer, with checks',
  names: ['fuzz_replay', 'remesher'],
});

/** The same programs, which say more of memory used wrongly. @param {System} system */
export const buildSanitized = (system) => buildTarget({
  ...unitTests(system), what: 'the unit tests, with sanitizers',
  folder: 'build/sanitized',
  definitions: [...commonDefinitions(system), ...sanitizedDefinitions(system)],
});

/** @param {System} system */
export const buildFuzz = (system) => buildTarget({
  what: 'the fuzzer, with sanitizers', folder: 'build/fuzz', names: ['fuzz'],
  definitions: [...commonDefinitions(system), ...sanitizedDefinitions(system),
    '-DREMESHER_FUZZ=ON'],
});

/** Finds the headers for tools that only read them. @param {System} system */
export const configureUnitTests = (system) => configure(unitTests(system));

/** @param {System} system */
export const buildMeasure = (system) => buildTarget({
  what: 'the measuring tools', folder: 'build/native',
  names: ['ablation', 'fires', 'measure', 'mended'],
  definitions: [...commonDefinitions(system), '-DCMAKE_BUILD_TYPE=Release'],
});
