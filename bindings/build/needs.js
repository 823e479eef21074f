// SPDX-License-Identifier: MIT
// The tools and libraries that the build needs, how to find them, and their names in each package
// manager.
import { dirname, join } from 'node:path';

import { findHeader, findProgram, isUbuntu, packageManager } from './system.js';

/** @typedef {import('./system.js').System} System */
/** @typedef {import('./system.js').Manager} Manager */
/**
 * @typedef {'package' | 'tests' | 'integration' | 'lint' | 'measure' | 'sanitized' | 'fuzz'
 *   | 'bits' | 'profile'} Part */

/**
 * @typedef {object} Need
 * @property {string} name
 * @property {Part[]} parts that need it
 * @property {(system: System) => string | undefined} find its place
 * @property {Partial<Record<Manager, string>>} packages
 * @property {string} [lighter] taken instead of the apt package if the archive has it, as Debian's
 * @property {string} [ubuntu] the command for Ubuntu, whose archive has no browsers
 * @property {string} [variable] the environment variable that tells its place; PATH if not given
 */

const platformFile = 'cmake/Modules/Platform/Emscripten.cmake';

/**
 * Emscripten's own toolchain file. It lies near the real emcc; in many systems the emcc on the path
 * is a link or a short script. em-config knows the folder, as does the variable that emsdk sets.
 * @param {System} system
 */
export function findEmscripten(system) {
  const { EMSDK } = system.environment;
  const emcc = findProgram(system, 'emcc');
  const home = emcc && dirname(system.realPath(emcc));
  const folders = [
    ...(EMSDK ? [join(EMSDK, 'upstream/emscripten')] : []),
    ...(home ? [home, join(home, '../libexec'), join(home, '../share/emscripten'),
      join(home, '../lib/emscripten')] : []),
    ...(emcc ? [system.ask('em-config', ['EMSCRIPTEN_ROOT'])].filter(Boolean) : []),
  ];
  return folders.map((folder) => join(folder, platformFile)).find(system.exists);
}

/**
 * A browser that tests can drive. A browser without windows comes first: its pages take a fifth
 * less time.
 * @param {System} system
 */
export function findChromium(system) {
  if (system.environment.REMESHER_CHROMIUM) return system.environment.REMESHER_CHROMIUM;
  const names = ['chromium-headless-shell', 'chrome-headless-shell', 'chromium', 'google-chrome',
    'google-chrome-stable', 'chromium-browser', 'chrome'];
  const onMac = ['Google Chrome', 'Chromium'].map((name) =>
    `/Applications/${name}.app/Contents/MacOS/${name}`);
  return names.map((name) => findProgram(system, name)).find(Boolean)
    ?? onMac.find((path) => system.exists(path));
}

/** A second JavaScript engine, which must give the same bytes. @param {System} system */
export function findFirefox(system) {
  if (system.environment.REMESHER_FIREFOX) return system.environment.REMESHER_FIREFOX;
  const onMac = '/Applications/Firefox.app/Contents/MacOS/firefox';
  return findProgram(system, 'firefox-esr') ?? findProgram(system, 'firefox')
    ?? (system.exists(onMac) ? onMac : undefined);
}

/** It compiles checks in less time than g++. @param {System} system */
export const findClang = (system) =>
  findProgram(system, 'clang++') ?? findProgram(system, 'clang++-14');

/**
 * A clang++ that has its sanitizers' libraries: it finds more than g++, in less time. Some versions
 * (Debian's from 17 on) print a folder named after the target, which does not exist, and use the
 * folder `linux` beside it.
 * @param {System} system
 */
export function findSanitizingClang(system) {
  const clang = findClang(system);
  if (!clang || system.platform === 'darwin') return clang;
  const named = system.ask(clang, ['-print-runtime-dir']);
  const folders = [named, join(dirname(named), 'linux')];
  const names = ['libclang_rt.asan-x86_64.a', 'libclang_rt.asan-aarch64.a', 'libclang_rt.asan.a'];
  return folders.some((folder) => names.some((name) => system.exists(join(folder, name))))
    ? clang : undefined;
}

/** @param {string} name */
const program = (name) => (/** @type {System} */ system) => findProgram(system, name);
/** @param {string} name */
const header = (name) => (/** @type {System} */ system) => findHeader(system, name);

const variable = 'REMESHER_INCLUDE';

/** @type {Part[]} */
const all = ['package', 'tests', 'lint', 'measure', 'sanitized', 'fuzz'];
/** @type {Part[]} */
const sanitizers = ['sanitized', 'fuzz'];

/** @type {readonly Need[]} */
export const needs = [
  { name: 'CMake', parts: all, find: program('cmake'),
    packages: { apt: 'cmake', dnf: 'cmake', pacman: 'cmake', apk: 'cmake', brew: 'cmake',
      nix: 'cmake' } },
  { name: 'Ninja', parts: all, find: program('ninja'),
    packages: { apt: 'ninja-build', dnf: 'ninja-build', pacman: 'ninja', apk: 'samurai',
      brew: 'ninja', nix: 'ninja' } },
  { name: 'Emscripten (emcc)', parts: ['package'], find: findEmscripten,
    packages: { apt: 'emscripten', dnf: 'emscripten', pacman: 'emscripten', apk: 'emscripten',
      brew: 'emscripten', nix: 'emscripten' } },
  { name: 'Eigen', parts: all, find: header('Eigen/Core'), variable,
    packages: { apt: 'libeigen3-dev', dnf: 'eigen3-devel', pacman: 'eigen', apk: 'eigen-dev',
      brew: 'eigen', nix: 'eigen' } },
  { name: 'fast_float', parts: all, find: header('fast_float/fast_float.h'), variable,
    packages: { apt: 'libfast-float-dev', dnf: 'fast_float-devel', pacman: 'fast_float',
      apk: 'fast_float', brew: 'fast_float', nix: 'fast-float' } },
  { name: 'nlohmann JSON', parts: all, find: header('nlohmann/json.hpp'), variable,
    packages: { apt: 'nlohmann-json3-dev', dnf: 'json-devel', pacman: 'nlohmann-json',
      apk: 'nlohmann-json', brew: 'nlohmann-json', nix: 'nlohmann_json' } },
  { name: 'tinygltf 2', parts: all, find: header('tiny_gltf.h'), variable,
    packages: { apt: 'libtinygltf-dev', dnf: 'tinygltf-devel', apk: 'tinygltf-dev',
      nix: 'tinygltf' } },
  { name: 'g++', parts: ['tests', 'integration', 'lint', 'measure'],
    find: (system) => findProgram(system, system.platform === 'darwin' ? 'c++' : 'g++'),
    packages: { apt: 'g++', dnf: 'gcc-c++', pacman: 'gcc', apk: 'g++', brew: 'gcc', nix: 'gcc' } },
  { name: 'clang++', parts: ['tests', 'integration', 'lint'], find: findClang,
    packages: { apt: 'clang', dnf: 'clang', pacman: 'clang', apk: 'clang', brew: 'llvm',
      nix: 'clang' } },
  { name: 'clang++ with sanitizers', parts: sanitizers, find: findSanitizingClang,
    packages: { apt: 'clang libclang-rt-dev', dnf: 'clang compiler-rt', pacman: 'clang compiler-rt',
      apk: 'clang compiler-rt', brew: 'llvm', nix: 'clang' } },
  { name: 'clang-format', parts: ['lint'], find: program('clang-format'),
    packages: { apt: 'clang-format', dnf: 'clang-tools-extra', pacman: 'clang',
      apk: 'clang-extra-tools', brew: 'clang-format', nix: 'clang-tools' } },
  { name: 'clang-tidy', parts: ['lint'], find: program('clang-tidy'),
    packages: { apt: 'clang-tidy', dnf: 'clang-tools-extra', pacman: 'clang',
      apk: 'clang-extra-tools', brew: 'llvm', nix: 'clang-tools' } },
  { name: 'doctest', parts: ['tests', 'lint', 'sanitized'],
    find: header('doctest/doctest.h'), variable,
    packages: { apt: 'doctest-dev', dnf: 'doctest-devel', pacman: 'doctest', apk: 'doctest-dev',
      brew: 'doctest', nix: 'doctest' } },
  { name: 'Chromium', parts: ['tests', 'integration', 'bits'], find: findChromium,
    variable: 'REMESHER_CHROMIUM', lighter: 'chromium-headless-shell',
    ubuntu: 'sudo snap install chromium',
    packages: { apt: 'chromium', dnf: 'chromium', pacman: 'chromium', apk: 'chromium',
      brew: '--cask chromium', nix: 'chromium' } },
  { name: 'Redis', parts: ['integration'], find: program('redis-server'),
    packages: { apt: 'redis-server', dnf: 'valkey-compat-redis', pacman: 'valkey', apk: 'redis',
      brew: 'redis', nix: 'redis' } },
  { name: 'GNU parallel', parts: ['integration'], find: program('parallel'),
    packages: { apt: 'parallel', dnf: 'parallel', pacman: 'parallel', apk: 'parallel',
      brew: 'parallel', nix: 'parallel' } },
  { name: 'Assimp', parts: ['tests'], find: program('assimp'),
    packages: { apt: 'assimp-utils', dnf: 'assimp', pacman: 'assimp', brew: 'assimp',
      nix: 'assimp' } },
  { name: 'Firefox', parts: ['bits'], find: findFirefox, variable: 'REMESHER_FIREFOX',
    ubuntu: 'sudo snap install firefox',
    packages: { apt: 'firefox-esr', dnf: 'firefox', pacman: 'firefox', apk: 'firefox-esr',
      brew: '--cask firefox', nix: 'firefox-esr' } },
];

/**
 * The needs of these parts that are not found.
 * @param {System} system
 * @param {readonly Part[]} parts
 */
export function missingNeeds(system, parts) {
  return needs.filter((need) => need.parts.some((part) => parts.includes(part))
    && !need.find(system));
}

/** Each manager's command to install a package. @type {Record<string, string>} */
const installing = {
  apt: 'sudo apt-get install', dnf: 'sudo dnf install', pacman: 'sudo pacman -S',
  apk: 'sudo apk add', brew: 'brew install', nix: 'nix-shell -p',
};

/**
 * One line per missing need, with the command that installs it.
 * @param {System} system
 * @param {readonly Need[]} missing
 */
export function advice(system, missing) {
  const manager = packageManager(system);
  return missing.map(({ name, packages, ubuntu, variable: place = 'PATH' }) => {
    if (ubuntu && isUbuntu(system)) return `${name} is missing: ${ubuntu}`;
    const words = packages[manager];
    if (words) return `${name} is missing: ${installing[manager]} ${words}`;
    if (name.startsWith('Emscripten')) {
      return `${name} is missing: https://emscripten.org/docs/getting_started/downloads.html`;
    }
    return `${name} is missing: install it, or name its place in ${place}`;
  });
}
