// SPDX-License-Identifier: MIT
// The tree keeps its shape: arrows between layers point down, nothing is circular, every source
// file is built, and none has outgrown its reader.
import assert from 'node:assert/strict';
import { dirname, join, normalize } from 'node:path';
import { test } from 'node:test';

import { filesUnder, readText } from './support/tree.js';

/** For each folder of src, the folders it may include from besides its own. */
const below = {
  base: [],
  mesh: ['base'],
  geometry: ['base', 'mesh'],
  surface: ['base', 'mesh', 'geometry'],
  operators: ['base', 'mesh', 'geometry', 'surface'],
  schemes: ['base', 'mesh', 'geometry', 'surface', 'operators'],
  measure: ['base', 'mesh', 'geometry', 'surface'],
  io: ['base'],
};
const facade = ['base', 'io', 'measure', 'schemes'];

const cppFiles = filesUnder('src', /\.(h|cpp)$/);
const bindingFiles = filesUnder('bindings', /\.(h|cpp)$/);
const testFiles = filesUnder('tests/unit', /\.(h|cpp)$/);
const packageFiles = filesUnder('bindings/package', /\.js$/);
const pageFiles = filesUnder('web', /\.js$/).filter((file) => !file.includes('/public/'));

const includesOf = (file) => [...readText(file).matchAll(/^#include "(.+)"/gm)].map(([, f]) => f);
const importsOf = (file) =>
  [...readText(file).matchAll(/(?:^import|^export|^\} from|\bimport\()[^'"\n;]*['"]([^'"]+)['"]/gm)]
    .map(([, name]) => name);
const layerOf = (path) => (path.includes('/') ? path.split('/')[0] : 'facade');

/** The first circle in a graph of names, or none. */
function findCircle(graph) {
  const state = new Map();
  const visit = (node, path) => {
    if (state.get(node) === 'done') return undefined;
    if (state.get(node) === 'open') return [...path.slice(path.indexOf(node)), node];
    state.set(node, 'open');
    for (const next of graph.get(node) ?? []) {
      const circle = visit(next, [...path, node]);
      if (circle) return circle;
    }
    state.set(node, 'done');
    return undefined;
  };
  for (const node of graph.keys()) {
    const circle = visit(node, []);
    if (circle) return circle;
  }
  return undefined;
}

test('a circle is found where there is one', () => {
  const circle = new Map([['a', ['b']], ['b', ['c']], ['c', ['b']]]);
  assert.deepEqual(findCircle(circle), ['b', 'c', 'b']);
  assert.equal(findCircle(new Map([['a', ['b', 'c']], ['b', ['c']], ['c', []]])), undefined);
});

test('includes in src point to lower layers only', () => {
  const wrong = [];
  for (const file of cppFiles) {
    const from = layerOf(file.slice('src/'.length));
    const allowed = from === 'facade' ? [...facade, 'facade'] : [...below[from] ?? [], from];
    for (const included of includesOf(file)) {
      if (!allowed.includes(layerOf(included))) wrong.push(`${file} includes ${included}`);
    }
  }
  assert.deepEqual(wrong, []);
});

test('includes in src name files that exist, from the root of src', () => {
  const missing = cppFiles.flatMap((file) => includesOf(file)
    .filter((included) => !cppFiles.includes(`src/${included}`))
    .map((included) => `${file} includes ${included}`));
  assert.deepEqual(missing, []);
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
  const inNode = /\/(cli|cli_arguments|node|platform_node|worker_node)\.js$/;
  const wrong = packageFiles.flatMap((file) => importsOf(file)
    .filter((name) => !(/^\.\/[a-z_]+\.m?js$/.test(name)
      || (name.startsWith('node:') && inNode.test(file))))
    .map((name) => `${file} imports ${name}`));
  assert.deepEqual(wrong, []);
});

test('what runs in browsers does not reach what runs in Node', () => {
  const reached = new Set();
  const visit = (file) => {
    if (reached.has(file)) return;
    reached.add(file);
    importsOf(`bindings/package/${file}`)
      .filter((name) => name.endsWith('.js'))
      .forEach((name) => visit(name.slice(2)));
  };
  ['index.js', 'worker.js'].forEach(visit);
  assert.deepEqual([...reached].filter((file) => /(^|_)node\.js$|^cli[._]/.test(file)), []);
});

test('no import is circular', () => {
  const graph = new Map([...packageFiles, ...pageFiles].map((file) =>
    [file, importsOf(file).filter((name) => name.startsWith('.'))
      .map((name) => normalize(join(dirname(file), name)))]));
  assert.equal(findCircle(graph), undefined);
});

test('the page knows the package by its public name alone', () => {
  const wrong = pageFiles.flatMap((file) => importsOf(file)
    .filter((name) => /bindings|dist\/|^\.\.\//.test(name))
    .map((name) => `${file} imports ${name}`));
  assert.deepEqual(wrong, []);
});

test('CMakeLists.txt lists every source file, sorted', () => {
  const cmake = readText('CMakeLists.txt');
  const sources = [...cppFiles, ...bindingFiles, ...testFiles].filter((f) => f.endsWith('.cpp'));
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

test('no file has outgrown 400 lines', () => {
  const files = [...cppFiles, ...bindingFiles, ...packageFiles, ...pageFiles, ...testFiles,
    ...filesUnder('tests', /\.js$/)];
  const long = files.filter((file) => readText(file).split('\n').length > 401);
  assert.deepEqual(long, []);
});

test('every file says its licence on top', () => {
  const files = [...cppFiles, ...bindingFiles, ...packageFiles, ...pageFiles, ...testFiles,
    ...filesUnder('tests', /\.js$/)];
  const without = files.filter((file) =>
    !readText(file).replace(/^#!.*\n/, '').startsWith('// SPDX-License-Identifier: MIT\n'));
  assert.deepEqual(without, []);
});
