// SPDX-License-Identifier: MIT
// The build finds its tools where each system keeps them, and names what is missing as that
// system's package manager does. The systems are made up.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  commonDefinitions, testDefinitions, wasmDefinitions,
} from '../../bindings/build/compile.js';
import {
  advice, findChromium, findEmscripten, findSanitizingClang, missingNeeds, needs,
} from '../../bindings/build/needs.js';
import { findHeader, packageManager } from '../../bindings/build/system.js';

const headers = ['fast_float/fast_float.h', 'nlohmann/json.hpp', 'tiny_gltf.h',
  'doctest/doctest.h'];
const toolchain = 'cmake/Modules/Platform/Emscripten.cmake';

/** A system that has these files, links by their targets, and answers by command. */
function system({ files = [], links = {}, answers = {}, environment = {}, ...rest }) {
  const there = new Set([...files, ...Object.keys(links)]);
  return {
    platform: 'linux', osRelease: '', isRoot: false, ...rest,
    environment: { PATH: '/usr/bin', ...environment },
    exists: (path) => there.has(path),
    realPath: (path) => links[path] ?? path,
    ask: (command) => answers[command] ?? '',
  };
}

const programs = (folder, names) => names.map((name) => `${folder}/${name}`);
const headersIn = (folder) => headers.map((header) => `${folder}/${header}`);
const runtime = '/lib/clang/linux';

const debian = system({
  osRelease: 'PRETTY_NAME="Debian GNU/Linux 12"\nID=debian\n',
  files: [...programs('/usr/bin', ['cmake', 'ninja', 'g++', 'clang++', 'clang-format',
    'clang-tidy', 'chromium', 'redis-server', 'parallel',
    'assimp']), ...headersIn('/usr/include'), '/usr/include/eigen3/Eigen/Core',
  `${runtime}/libclang_rt.asan-x86_64.a`, `/usr/share/emscripten/${toolchain}`],
  links: { '/usr/bin/emcc': '/usr/share/emscripten/emcc' },
  answers: { '/usr/bin/clang++': runtime },
});

test('the package manager follows from the system', () => {
  const managers = [['ID=ubuntu\nID_LIKE=debian', 'apt'], ['ID="fedora"', 'dnf'],
    ['ID=manjaro\nID_LIKE=arch', 'pacman'], ['ID="rocky"\nID_LIKE="rhel centos fedora"', 'dnf'],
    ['ID=alpine', 'apk'], ['ID=nixos', 'nix'], ['ID=haiku', 'none']];
  for (const [osRelease, manager] of managers) {
    assert.equal(packageManager(system({ osRelease })), manager);
  }
  assert.equal(packageManager(system({ platform: 'darwin' })), 'brew');
  assert.equal(packageManager(system({ platform: 'win32' })), 'none');
  assert.equal(packageManager(system({ osRelease: 'ID=debian',
    environment: { IN_NIX_SHELL: 'pure' } })), 'nix');
});

test('a Debian that has it all misses nothing', () => {
  assert.deepEqual(missingNeeds(debian,
    ['package', 'tests', 'integration', 'lint', 'measure', 'sanitized']), []);
  assert.deepEqual(wasmDefinitions(debian)[0],
    `-DCMAKE_TOOLCHAIN_FILE=/usr/share/emscripten/${toolchain}`);
  assert.ok(testDefinitions(debian).includes('-DCMAKE_CXX_COMPILER=/usr/bin/clang++'));
});

test('Emscripten’s toolchain file is found wherever emcc really is', () => {
  const places = [
    { path: '/usr/lib/emscripten', links: { '/usr/bin/emcc': '/usr/lib/emscripten/emcc' } },
    { path: '/brew/Cellar/emscripten/4.0.1/libexec',
      links: { '/usr/bin/emcc': '/brew/Cellar/emscripten/4.0.1/bin/emcc' } },
    { path: '/nix/store/x-emscripten/share/emscripten',
      links: { '/usr/bin/emcc': '/nix/store/x-emscripten/bin/emcc' } },
    { path: '/odd/place', files: ['/usr/bin/emcc'], answers: { 'em-config': '/odd/place' } },
    { path: '/emsdk/upstream/emscripten', environment: { EMSDK: '/emsdk' } },
  ];
  for (const { path, files = [], ...rest } of places) {
    const file = `${path}/${toolchain}`;
    assert.equal(findEmscripten(system({ files: [...files, file], ...rest })), file);
  }
  assert.equal(findEmscripten(system({ files: ['/usr/bin/emcc'] })), undefined);
});

test('headers are found where the user, the shell or Homebrew says, in this order', () => {
  const files = ['/mine', '/cpath', '/nix/e', '/brew/include', '/usr/include']
    .flatMap((folder) => [`${folder}/tiny_gltf.h`, `${folder}/eigen3/Eigen/Core`]);
  const environment = { REMESHER_INCLUDE: '/none:/mine', CPATH: '/cpath',
    NIX_CFLAGS_COMPILE: '-frandom-seed=1 -isystem /nix/e', HOMEBREW_PREFIX: '/brew' };
  const order = [['REMESHER_INCLUDE', '/mine'], ['CPATH', '/cpath'],
    ['NIX_CFLAGS_COMPILE', '/nix/e'], ['HOMEBREW_PREFIX', '/brew/include']];
  for (const [variable, folder] of order) {
    assert.equal(findHeader(system({ files, environment }), 'tiny_gltf.h'), folder);
    assert.equal(findHeader(system({ files, environment }), 'Eigen/Core'), `${folder}/eigen3`);
    delete environment[variable];
  }
  assert.equal(findHeader(system({ files }), 'tiny_gltf.h'), '/usr/include');
  assert.ok(commonDefinitions(system({ environment: { REMESHER_INCLUDE: '/mine' } }))[0]
    .startsWith('-DREMESHER_INCLUDE=/mine;'));
});

test('what is missing is named in a line each, as the package manager calls it', () => {
  const mac = system({ platform: 'darwin', files: programs('/usr/bin', ['cmake', 'ninja']) });
  assert.deepEqual(advice(mac, missingNeeds(mac, ['package'])), [
    'Emscripten (emcc) is missing: brew install emscripten',
    'Eigen is missing: brew install eigen',
    'fast_float is missing: brew install fast_float',
    'nlohmann JSON is missing: brew install nlohmann-json',
    'tinygltf 2 is missing: install it, or name its place in REMESHER_INCLUDE',
  ]);
  const fedora = system({ ...debian, osRelease: 'ID=fedora' });
  const [clang] = needs.filter(({ name }) => name.startsWith('clang++ with'));
  assert.deepEqual(advice(fedora, [clang]),
    ['clang++ with sanitizers is missing: sudo dnf install clang compiler-rt']);
  const windows = system({ platform: 'win32', environment: { PATH: 'C:\\bin' } });
  assert.deepEqual(advice(windows, missingNeeds(windows, ['measure'])).map((line) =>
    line.replace(/ is missing.* in /, ': ')), ['CMake: PATH', 'Ninja: PATH',
    'Eigen: REMESHER_INCLUDE', 'fast_float: REMESHER_INCLUDE', 'nlohmann JSON: REMESHER_INCLUDE',
    'tinygltf 2: REMESHER_INCLUDE', 'g++: PATH']);
});

test('Ubuntu has no browsers in its archive: they are named as snaps', () => {
  const ubuntu = system({ ...debian, osRelease: 'ID=ubuntu\nID_LIKE=debian' });
  const [chromium] = needs.filter(({ name }) => name === 'Chromium');
  assert.deepEqual(advice(ubuntu, [chromium]),
    ['Chromium is missing: sudo snap install chromium']);
  assert.deepEqual(advice(debian, [chromium]),
    ['Chromium is missing: sudo apt-get install chromium']);
});

test('warnings are errors where the compilers are known', () => {
  const areErrors = (/** @type {string} */ osRelease) =>
    !commonDefinitions(system({ osRelease })).some((word) => word.includes('AS_ERROR=OFF'));
  assert.deepEqual(['ID=debian\nVERSION_ID="12"', 'ID=debian\nVERSION_ID="13"',
    'ID=debian', 'ID=debian\nVERSION_ID="14"', 'ID=ubuntu\nVERSION_ID="24.04"', 'ID=fedora']
    .map(areErrors), [true, true, false, false, false, false]);
});

test('every need can be had from apt, and only tests need what only checks', () => {
  assert.deepEqual(needs.filter(({ packages }) => !packages.apt), []);
  const bare = system({ osRelease: 'ID=ubuntu' });
  const names = missingNeeds(bare, ['package']).map(({ name }) => name);
  assert.equal(names.includes('doctest'), false);
  assert.equal(names.includes('Chromium'), false);
});

test('a clang without the libraries of its sanitizers is enough for tests only', () => {
  const bare = system({ files: ['/usr/bin/clang++'] });
  assert.ok(testDefinitions(bare).includes('-DCMAKE_CXX_COMPILER=/usr/bin/clang++'));
  assert.equal(findSanitizingClang(system({ files: ['/usr/bin/clang++'],
    answers: { '/usr/bin/clang++': runtime } })), undefined);
});

test('a clang that names a folder of its target has its libraries beside it', () => {
  const of = (/** @type {string[]} */ libraries) => findSanitizingClang(system({
    files: ['/usr/bin/clang++', ...libraries],
    answers: { '/usr/bin/clang++': '/lib/clang/x86_64-pc-linux-gnu' } }));
  assert.equal(of([`${runtime}/libclang_rt.asan-x86_64.a`]), '/usr/bin/clang++');
  assert.equal(of([]), undefined);
});

test('any Chromium will do, the named one before all, then the one without windows', () => {
  const chrome = { files: ['/usr/bin/google-chrome'] };
  assert.equal(findChromium(system(chrome)), '/usr/bin/google-chrome');
  const shell = '/usr/bin/chromium-headless-shell';
  assert.equal(findChromium(system({ files: ['/usr/bin/chromium', shell] })), shell);
  assert.equal(findChromium(system({ ...chrome,
    environment: { REMESHER_CHROMIUM: '/my/chrome' } })), '/my/chrome');
});
