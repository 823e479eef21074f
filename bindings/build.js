// SPDX-License-Identifier: MIT
// Installs what is missing, then builds what is asked for, one line per step:
//   node bindings/build.js package          the npm package in dist/
//   node bindings/build.js package tests    and the native unit tests
//   node bindings/build.js package integration   and the programs that the package works with, the
//                                           native library, the targets of the fuzzer
//   node bindings/build.js package lint     and what checks the sources without building them
//   node bindings/build.js package measure  and the native judge of the benchmark
//   node bindings/build.js sanitized        the unit tests again, with sanitizers
//   node bindings/build.js package fuzz     and the targets of libFuzzer
//   node bindings/build.js package bits     and the browsers that must give the same bytes
//   node bindings/build.js package profile  and the package once more, with names for the profiler
// Repeating it costs seconds. It needs nothing but Node; on Debian and Ubuntu, root or sudo where
// packages are missing. All output goes to standard error.

import { assemblePackage, assembleProfile } from './build/assemble.js';
import {
  buildFuzz, buildLibrary, buildMeasure, buildProfile, buildSanitized, buildUnitTests,
  buildWebAssembly, configureUnitTests,
} from './build/compile.js';
import { installNpmPackages, installTools } from './build/install.js';
import { BuildError, run, say } from './build/say.js';
import { thisSystem } from './build/system.js';

/** @typedef {import('./build/needs.js').Part} Part */

/** The unit tests, which remember what passed; failures are printed when it is their turn. */
function testAhead() {
  const words = ['--test', 'tests/house/unit.test.js'];
  return run(process.execPath, words, { givesWay: true }).catch(() => {});
}

/**
 * Side by side: linking the module as a whole keeps one core busy, and the tests the other: while
 * they are built and, where that took little, run. Compilers need nothing of npm.
 */
async function build(/** @type {readonly Part[]} */ parts) {
  const system = thisSystem();
  const installs = installNpmPackages();
  installs.catch(() => {});  // reported below, after missing tools
  await installTools(system, parts);
  let isPackageInWork = parts.includes('package');
  const steps = {
    package: () => Promise.all([buildWebAssembly(system), installs]).then(assemblePackage)
      .finally(() => { isPackageInWork = false; }),
    tests: async () => {
      await Promise.all([buildUnitTests(system), installs]);
      if (isPackageInWork) await testAhead();
    },
    integration: () => buildLibrary(system),
    lint: () => configureUnitTests(system),
    measure: () => buildMeasure(system),
    sanitized: () => buildSanitized(system),
    fuzz: () => buildFuzz(system),
    bits: async () => {},
    profile: () => buildProfile(system),
  };
  const ends = await Promise.allSettled([installs, ...parts.map((part) => steps[part]())]);
  const failed = ends.find((end) => end.status === 'rejected');
  if (failed) throw failed.reason;
  if (parts.includes('profile')) assembleProfile();
}

const parts = /** @type {Part[]} */ (process.argv.slice(2));
try {
  await build(parts);
} catch (error) {
  if (!(error instanceof BuildError)) throw error;
  say(error.message);
  process.exitCode = 1;
}
