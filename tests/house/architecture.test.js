// SPDX-License-Identifier: MIT
// The tree keeps its shape: arrows between rooms point down, nothing is circular, and every source
// file is built.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { dirname, join, normalize, relative } from 'node:path';
import { test } from 'node:test';

import { coreRooms, findCircle, packageRooms, pageRooms, wrongArrows } from '../support/rooms.js';
import { roomsPicture } from '../support/rooms_picture.js';
import { filesUnder, readText, root } from '../support/tree.js';

const cppFiles = filesUnder('src', /\.(h|cpp)$/);
const bindingFiles = filesUnder('bindings', /\.(h|cpp)$/);
const testFiles = filesUnder('tests/unit', /\.(h|cpp)$/);
const fuzzFiles = filesUnder('tests/fuzz', /\.(h|cpp)$/);
const packageFiles = filesUnder('bindings/package', /\.js$/);
const buildFiles = filesUnder('bindings', /^bindings\/build.*\.js$/);
const pageFiles = filesUnder('web', /\.js$/).filter((file) => !file.includes('/public/'));

const includesOf = (file) => [...readText(file).matchAll(/^#include "(.+)"/gm)].map(([, f]) => f);
const importsOf = (file) =>
  [...readText(file).matchAll(/(?:^import|^export|^\} from|\bimport\()[^'"\n;]*['"]([^'"]+)['"]/gm)]
    .map(([, name]) => name);

/** What a file imports of ours, by path from a folder. */
const importedFrom = (top, file) => importsOf(file).filter((name) => name.startsWith('.'))
  .map((name) => relative(top, join(dirname(file), name)))
  .filter((path) => !path.startsWith('..'));

test('an arrow up, one sideways and a circle are found where they are', () => {
  const rooms = { base: [], left: ['base'], right: ['base'], '': ['base', 'left', 'right'] };
  const arrows = [['main', ['left/a', 'base/b']], ['left/a', ['right/c', 'left/d', 'base/b']],
    ['base/b', ['left/a']]];
  assert.deepEqual(wrongArrows(rooms, arrows), ['left/a -> right/c', 'base/b -> left/a']);
  const circle = new Map([['a', ['b']], ['b', ['c']], ['c', ['b']]]);
  assert.deepEqual(findCircle(circle), ['b', 'c', 'b']);
  assert.equal(findCircle(new Map([['a', ['b', 'c']], ['b', ['c']], ['c', []]])), undefined);
});

test('rooms name only rooms before them, and all there are', () => {
  const trees = [[coreRooms, 'src', cppFiles], [packageRooms, 'bindings/package', packageFiles],
    [pageRooms, 'web', pageFiles]];
  for (const [rooms, top, files] of trees) {
    const names = Object.keys(rooms);
    names.forEach((name, i) => assert.deepEqual(
      rooms[name].filter((below) => !names.slice(0, i).includes(below)), [], name));
    const folders = new Set(files.map((file) => relative(top, dirname(file))));
    assert.deepEqual([...folders].sort(), [...names].sort());
  }
});

/** Types of ours by name, and the header of each. */
const definedIn = new Map(cppFiles.filter((file) => file.endsWith('.h')).flatMap((file) =>
  [...readText(file).matchAll(/^(?:struct|class) (\w+)[^;\n]*\{/gm)]
    .map(([, type]) => [type, relative('src', file)])));

/** The headers of the types that a file only names: a promise that somebody else defines them. */
const promisesOf = (file) => [...readText(file).matchAll(/^(?:struct|class) (\w+);/gm)]
  .flatMap(([, type]) => definedIn.get(type) ?? []);

test('the picture of the rooms is of these rooms: node tests/pictures/rooms.js', () => {
  assert.equal(readText('src/rooms.svg'), roomsPicture(coreRooms, 'remesher'));
});

test('includes and forward declarations in src point to lower rooms only', () => {
  const arrows = cppFiles.map((file) =>
    [relative('src', file), [...includesOf(file), ...promisesOf(file)]]);
  assert.ok(arrows.some(([, targets]) => targets.includes('original/surface/original_tree.h')));
  assert.deepEqual(wrongArrows(coreRooms, arrows), []);
});

test('imports in the package and in the page point to lower rooms only', () => {
  const trees = [[packageRooms, 'bindings/package', packageFiles], [pageRooms, 'web', pageFiles]];
  for (const [rooms, top, files] of trees) {
    const arrows = files.map((file) => [relative(top, file), importedFrom(top, file)
      .filter((target) => target.endsWith('.js'))]);
    assert.deepEqual(wrongArrows(rooms, arrows), []);
  }
});

test('includes in src name files that exist, from the root of src', () => {
  const missing = cppFiles.flatMap((file) => includesOf(file)
    .filter((included) => !cppFiles.includes(`src/${included}`))
    .map((included) => `${file} includes ${included}`));
  assert.deepEqual(missing, []);
});

test('no two headers define one type, which would be two things by one name', () => {
  const places = new Map();
  for (const file of cppFiles.filter((name) => name.endsWith('.h'))) {
    const text = readText(file);
    const [, space] = /^namespace (\S+) \{/m.exec(text) ?? [];
    for (const [, type] of text.matchAll(/^(?:struct|class|enum class|enum) (\w+)[^;]*?\{/gm)) {
      const name = `${space}::${type}`;
      places.set(name, [...places.get(name) ?? [], file]);
    }
  }
  assert.ok(places.size > 50, `${places.size} types`);
  assert.deepEqual([...places].filter(([, files]) => files.length > 1), []);
});

test('the bindings see only the public header', () => {
  const own = bindingFiles.map((file) => file.slice('bindings/'.length));
  const wrong = bindingFiles.flatMap((file) => includesOf(file)
    .filter((included) => included !== 'remesher.h' && !own.includes(included))
    .map((included) => `${file} includes ${included}`));
  assert.deepEqual(wrong, []);
});

test('no include is circular', () => {
  const graph = new Map(cppFiles.map((file) =>
    [file, includesOf(file).map((included) => `src/${included}`)]));
  assert.equal(findCircle(graph), undefined);
});

test('the package imports only itself, and Node only where it runs in Node', () => {
  const inAdapters =
    ['remesher/arrays', 'three', '@gltf-transform/core', '@gltf-transform/functions'];
  const inNode = /\/((cli|files)\/\w+|node|platform_node|(image_)?worker_node)\.js$/;
  const isCodec = (file, name) =>
    file.endsWith('/textures/bundled_packages.js') && name.startsWith('@jsquash/');
  const wrong = packageFiles.flatMap((file) => importsOf(file)
    .filter((name) => !(/^\.\.?\/[a-z_/]+\.m?js$/.test(name)
      || isCodec(file, name)
      || (name.startsWith('node:') && inNode.test(file))
      || (inAdapters.includes(name) && file.includes('/adapters/'))))
    .map((name) => `${file} imports ${name}`));
  assert.deepEqual(wrong, []);
});

test('what runs in browsers does not reach what runs in Node', () => {
  const reached = new Set();
  const visit = (file) => {
    if (reached.has(file)) return;
    reached.add(file);
    importedFrom('bindings/package', `bindings/package/${file}`)
      .filter((name) => packageFiles.includes(`bindings/package/${name}`))
      .forEach(visit);
  };
  ['index.js', 'arrays.js', 'worker.js'].forEach(visit);
  assert.ok(reached.size > 10, 'the walk goes through the package');
  assert.deepEqual([...reached].filter((file) => /(^|_)node\.js$|^(cli|files)\//.test(file)), []);
});

test('no import is circular', () => {
  const graph = new Map([...packageFiles, ...pageFiles, ...buildFiles].map((file) =>
    [file, importsOf(file).filter((name) => name.startsWith('.'))
      .map((name) => normalize(join(dirname(file), name)))]));
  assert.equal(findCircle(graph), undefined);
});

test('the page knows the package by its public name alone', () => {
  const wrong = pageFiles.flatMap((file) => importsOf(file)
    .filter((name) => /bindings|dist\/|^\.\.\/\.\.\//.test(name))
    .map((name) => `${file} imports ${name}`));
  assert.deepEqual(wrong, []);
});

test('CMake lists every source file, sorted', () => {
  const cmake = ['CMakeLists.txt', 'src/core.cmake', 'tests/programs.cmake'].map(readText).join('');
  const sources = [...cppFiles, ...bindingFiles, ...testFiles, ...fuzzFiles]
    .filter((f) => f.endsWith('.cpp'));
  assert.deepEqual(sources.filter((file) => !cmake.includes(`  ${file}\n`)), []);
  for (const [block] of cmake.matchAll(/(?:^ +(?:src|bindings|tests)\/\S+\.cpp\n)+/gm)) {
    const listed = block.trim().split(/\s+/);
    assert.deepEqual(listed, [...listed].sort());
  }
});

test('every unit test is named after the file it tests', () => {
  const wrong = testFiles.filter((file) => file.endsWith('_test.cpp')).filter((file) => {
    const name = file.replace('tests/unit/', 'src/').replace('_test.cpp', '');
    return !cppFiles.some((subject) => name.startsWith(subject.replace(/\.(h|cpp)$/, '')));
  });
  assert.deepEqual(wrong, []);
});

test('the top level holds what belongs there, and nothing that was left behind', (t) => {
  const { status, stdout } = spawnSync('git', ['ls-files', '-z'], { cwd: root, encoding: 'utf8' });
  if (status !== 0) {
    t.skip('not a checkout of git');
    return;
  }
  const folders = /^(\.[a-z-]+|bindings|docs|examples|src|tests|web)$/;
  const files = /^(CMakeLists\.txt|package(-lock)?\.json|LICENSE|CITATION\.cff|[A-Z]+\.md)$/;
  const entries = new Set(stdout.split('\0').filter(Boolean).map((path) => path.split('/')[0]));
  const wrong = [...entries].filter((name) => !folders.test(name) && !files.test(name));
  assert.deepEqual(wrong, []);
});

test('every file says its licence on top', () => {
  const files = [...cppFiles, ...bindingFiles, ...packageFiles, ...pageFiles,
    ...buildFiles, ...testFiles, ...fuzzFiles, ...filesUnder('tests', /\.js$/)];
  const without = files.filter((file) =>
    !readText(file).replace(/^#!.*\n/, '').startsWith('// SPDX-License-Identifier: MIT\n'));
  assert.deepEqual(without, []);
});
