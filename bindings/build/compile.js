// SPDX-License-Identifier: MIT
// What CMake and Ninja make of the core: the WebAssembly module, the unit tests, the judge.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { findEmscripten, findSanitizingClang } from './needs.js';
import { ask, root, run, say } from './say.js';
import { includeFolders, isKnown } from './system.js';

/** @typedef {import('./system.js').System} System */

/**
 * What of a build is the system's: where headers are; and the warnings of compilers that we do not
 * know are no errors.
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

/** @param {System} system */
export function testDefinitions(system) {
  const clang = findSanitizingClang(system);
  return ['-DCMAKE_BUILD_TYPE=Debug', '-DREMESHER_SANITIZE=ON',
    '-DCMAKE_CXX_FLAGS_DEBUG=-gline-tables-only',
    ...(clang ? [`-DCMAKE_CXX_COMPILER=${clang}`] : [])];
}

/**
 * @typedef {object} Target
 * @property {string} what
 * @property {string} folder
 * @property {readonly string[]} names
 * @property {readonly string[]} definitions
 * @property {boolean} [givesWay]
 */

/**
 * A folder configured otherwise begins anew: compilers cannot be changed in place.
 * @param {Target} target
 */
async function configure({ folder, definitions }) {
  const told = join(root, folder, 'configured');
  const words = definitions.join('\n');
  const isTold = existsSync(told) && readFileSync(told, 'utf8') === words;
  if (isTold && existsSync(join(root, folder, 'build.ninja'))) return;
  await run('cmake', ['--fresh', '-G', 'Ninja', '-S', '.', '-B', folder, ...definitions]);
  writeFileSync(told, words);
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
 * What comes after the module, its linking and the package's types, uses one core: it begins as
 * early as it can, and the tests fill the other. The fuzzer's one unit is not left for the end,
 * where it would have a core to itself and the other none.
 * @param {System} system
 */
const unitTests = (system) => ({
  what: 'the unit tests, with sanitizers', folder: 'build/test',
  names: ['fuzz_replay', 'remesher', 'unit_tests'], givesWay: true,
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

/** @param {System} system */
export const buildFuzz = (system) => buildTarget({
  what: 'the fuzzer, with sanitizers', folder: 'build/fuzz', names: ['fuzz'],
  definitions: [...commonDefinitions(system), ...testDefinitions(system), '-DREMESHER_FUZZ=ON'],
});

/** Finds the headers for those who only read them. @param {System} system */
export const configureUnitTests = (system) => configure(unitTests(system));

/** @param {System} system */
export const buildMeasure = (system) => buildTarget({
  what: 'the measuring tools', folder: 'build/native', names: ['ablation', 'measure'],
  definitions: [...commonDefinitions(system), '-DCMAKE_BUILD_TYPE=Release'],
});
