// SPDX-License-Identifier: MIT
// Installs what is missing, then builds what is asked for, one line per step:
//   node bindings/build.js package          the npm package in dist/
//   node bindings/build.js package tests    and the native unit tests with the tools that check
//   node bindings/build.js package measure  and the native judge of the benchmark
// Repeating it costs seconds. It needs nothing but Node, and root or sudo where packages are
// missing. All output goes to standard error.

import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import {
  chmodSync, copyFileSync, cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync,
  writeFileSync,
} from 'node:fs';
import { basename, dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

import { optionDeclarations, withPlainImports } from './declarations.js';

const root = dirname(dirname(fileURLToPath(import.meta.url)));

const debianPackages = {
  package: ['g++', 'cmake', 'ninja-build', 'emscripten', 'libeigen3-dev', 'libfast-float-dev',
    'libtinygltf-dev', 'nlohmann-json3-dev'],
  tests: ['clang-format', 'clang-tidy', 'doctest-dev', 'chromium'],
};
const emscriptenToolchain = '/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake';

class BuildError extends Error {}

/** @param {string} text */
function say(text) {
  process.stderr.write(`${text}\n`);
}

/**
 * Runs quietly; what it printed is shown if it fails.
 * @param {string} command
 * @param {string[]} words
 */
function run(command, words) {
  const { status, error, stdout, stderr } = spawnSync(command, words,
    { cwd: root, encoding: 'utf8', maxBuffer: 2 ** 28 });
  if (error) throw new BuildError(`${command} cannot be started: ${error.message}`);
  if (status !== 0) throw new BuildError(`${command} ${words.join(' ')}\n${stdout}${stderr}`);
  return stdout;
}

/** @param {string} name */
function isInstalled(name) {
  const { stdout } = spawnSync('dpkg-query', ['-W', '-f=${db:Status-Status}', name],
    { encoding: 'utf8' });
  return stdout === 'installed';
}

/** @param {readonly string[]} names */
function installDebianPackages(names) {
  const missing = names.filter((name) => !isInstalled(name));
  if (missing.length === 0) return;
  say(`Installing Debian packages: ${missing.join(' ')}`);
  const isRoot = process.getuid?.() === 0;
  const [command, ...first] = [...(isRoot ? [] : ['sudo', '-n']), 'env',
    'DEBIAN_FRONTEND=noninteractive', 'apt-get'];
  const apt = (/** @type {string[]} */ ...words) => run(command, [...first, ...words]);
  apt('update', '-qq');
  apt('install', '-y', '-qq', '--no-install-recommends', ...missing);
}

/** Whether these contents are those of the last time; and from now on they are. */
class Stamp {
  /** @param {string} path @param {readonly string[]} files */
  constructor(path, files) {
    this.path = join(root, path);
    const hash = createHash('sha256');
    for (const file of files) hash.update(file).update(readFileSync(join(root, file)));
    this.value = hash.digest('hex');
  }

  isCurrent() {
    return existsSync(this.path) && readFileSync(this.path, 'utf8') === this.value;
  }

  set() {
    writeFileSync(this.path, this.value);
  }
}

function installNpmPackages() {
  const stamp = new Stamp('node_modules/.remesher-lock', ['package-lock.json']);
  if (stamp.isCurrent()) return;
  say('Installing npm packages');
  run('npm', ['ci', '--no-audit', '--no-fund']);
  stamp.set();
}

/**
 * @param {string} what
 * @param {string} folder
 * @param {string[]} definitions
 * @param {string} target
 */
function buildWithCMake(what, folder, definitions, target) {
  if (!existsSync(join(root, folder, 'build.ninja'))) {
    run('cmake', ['-G', 'Ninja', '-S', '.', '-B', folder, ...definitions]);
  }
  const { stdout } = spawnSync('ninja', ['-C', folder, '-n', target],
    { cwd: root, encoding: 'utf8' });
  if (stdout.includes('no work to do')) return;
  say(`Building ${what}`);
  run('ninja', ['-C', folder, target]);
}

function buildWebAssembly() {
  buildWithCMake('the WebAssembly module', 'build/wasm',
    [`-DCMAKE_TOOLCHAIN_FILE=${emscriptenToolchain}`, '-DCMAKE_BUILD_TYPE=Release'], 'remesher');
}

function buildUnitTests() {
  buildWithCMake('the unit tests, with sanitizers', 'build/test',
    ['-DCMAKE_BUILD_TYPE=Debug', '-DREMESHER_SANITIZE=ON', '-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1'],
    'unit_tests');
}

function buildMeasure() {
  buildWithCMake('the measuring tool', 'build/native', ['-DCMAKE_BUILD_TYPE=Release'], 'measure');
}

/**
 * Modules of our own around the decoders of compressed glTF, complete in themselves: they work
 * under any bundler and without one, and a user of the package installs nothing else.
 * @returns {Record<string, string>} contents by file name
 */
function decoderModules() {
  const read = (/** @type {string} */ file) => readFileSync(join(root, 'node_modules', file));
  const draco = 'draco3dgltf/draco_decoder_gltf';
  // Without `process` the script does not take Node for granted; without the names of CommonJS no
  // bundler takes it for a mixture of the two kinds of module, nor looks for Node's files.
  return {
    'meshopt_decoder.mjs': String(read('meshoptimizer/meshopt_decoder.mjs')),
    'draco_decoder.mjs': `// Draco, https://github.com/google/draco, Apache-2.0
const process = undefined, module = undefined, exports = undefined, require = undefined;
${read(`${draco}_nodejs.js`)}
const binary = '${read(`${draco}.wasm`).toString('base64')}';
export default () => DracoDecoderModule({
  wasmBinary: Uint8Array.from(atob(binary), (letter) => letter.charCodeAt(0)),
});
`,
  };
}

/** @param {string} folder @returns {string[]} the files below it, by their paths from the root */
function filesIn(folder) {
  return readdirSync(join(root, folder), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(root, join(entry.parentPath ?? entry.path, entry.name)))
    .sort();
}

function emitDeclarations() {
  writeFileSync(join(root, 'dist/base/remesh_options.d.ts'), optionDeclarations());
  run('node_modules/typescript-7/bin/tsc', ['-p', 'bindings/tsconfig.json']);
  for (const file of filesIn('dist').filter((name) => name.endsWith('.d.ts'))) {
    const path = join(root, file);
    writeFileSync(path, withPlainImports(readFileSync(path, 'utf8')));
  }
}

/** dist/: the sources as they are, the WebAssembly, and the types read from the comments. */
function assemblePackage() {
  const sources = filesIn('bindings/package');
  const declarations = readdirSync(join(root, 'bindings'))
    .filter((file) => file.endsWith('.d.mts')).map((file) => `bindings/${file}`);
  const inputs = [...sources, 'build/wasm/remesher.mjs', 'build/wasm/remesher.wasm',
    ...declarations, 'bindings/build.js', 'bindings/declarations.js', 'bindings/tsconfig.json',
    'package.json', 'package-lock.json'];
  mkdirSync(join(root, 'build'), { recursive: true });
  const stamp = new Stamp('build/dist.stamp', inputs);
  if (stamp.isCurrent() && existsSync(join(root, 'dist/index.d.ts'))) return;
  say('Assembling the package in dist/');
  rmSync(join(root, 'dist'), { recursive: true, force: true });
  cpSync(join(root, 'bindings/package'), join(root, 'dist'), { recursive: true });
  for (const file of ['build/wasm/remesher.mjs', 'build/wasm/remesher.wasm', ...declarations]) {
    copyFileSync(join(root, file), join(root, 'dist', basename(file)));
  }
  for (const [name, text] of Object.entries(decoderModules())) {
    writeFileSync(join(root, 'dist', name), text);
  }
  chmodSync(join(root, 'dist/remesher.wasm'), 0o644);
  chmodSync(join(root, 'dist/cli/cli.js'), 0o755);
  emitDeclarations();
  stamp.set();
}

/** @param {readonly string[]} parts */
function build(parts) {
  if (process.platform !== 'linux' || !existsSync('/usr/bin/dpkg-query')) {
    throw new BuildError('Building needs Debian 12 or Ubuntu; only to use remesher, a plain\n'
      + 'npm install remesher will do.');
  }
  const withTests = parts.includes('tests');
  installDebianPackages([...debianPackages.package, ...(withTests ? debianPackages.tests : [])]);
  installNpmPackages();
  buildWebAssembly();
  assemblePackage();
  if (withTests) buildUnitTests();
  if (parts.includes('measure')) buildMeasure();
}

try {
  build(process.argv.slice(2));
} catch (error) {
  if (!(error instanceof BuildError)) throw error;
  say(error.message);
  process.exitCode = 1;
}
