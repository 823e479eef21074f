// SPDX-License-Identifier: MIT
// What a test file can read is found out from its text: too much costs time, too little would leave
// a test asleep that should have failed.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { readings } from '../support/readings.js';
import { filesUnder, readText } from '../support/tree.js';

const manifest = { name: 'soup', exports: { './salt': './dist/salt.js',
  '.': { types: './dist/web.d.ts', node: './dist/node.js', default: './dist/web.js' } } };
const sources = {
  'package.json': JSON.stringify(manifest),
  'dist/node.js': "import './base/errors.js';\nnew URL('./core.wasm', import.meta.url);\n",
  'dist/web.js': '', 'dist/web.d.ts': "import './base/errors.js';\n", 'dist/salt.js': '',
  'dist/base/errors.d.ts': '', 'dist/core.wasm': '', 'dist/base/errors.js': '',
  'src/pot.cpp': '', 'src/lids/lid.cpp': '', 'notes/README.md': 'See src/pot.cpp.\n',
  'tests/support/helper.js': "import '../../tools/spoon.js';\n", 'tools/spoon.js': '',
};

/** What a test with this text reads besides itself. */
function readBy(text, more = {}) {
  const files = { ...sources, 'tests/a.test.js': text, ...more };
  const readingsOf = readings(Object.keys(files), (file) => files[file]);
  return readingsOf('tests/a.test.js')
    .filter((file) => !['package.json', 'tests/a.test.js'].includes(file));
}

test('what is imported is read, and what that imports', () => {
  assert.deepEqual(readBy("import { stir } from './support/helper.js';\n"),
    ['tests/support/helper.js', 'tools/spoon.js']);
});

test('an entry of the package is all that it leads to under any condition', () => {
  assert.deepEqual(readBy("import { cook } from 'soup';\n"),
    ['dist/base/errors.d.ts', 'dist/base/errors.js', 'dist/core.wasm', 'dist/node.js',
      'dist/web.d.ts', 'dist/web.js']);
  assert.deepEqual(readBy("import { pinch } from 'soup/salt';\n"), ['dist/salt.js']);
});

test('a path is read wherever it is named, a folder with all that is in it', () => {
  assert.deepEqual(readBy("run(join(root, 'tools/spoon.js'));\n"), ['tools/spoon.js']);
  assert.deepEqual(readBy("filesUnder('src', /cpp$/);\n"), ['src/lids/lid.cpp', 'src/pot.cpp']);
  assert.deepEqual(readBy('readText(`src/lids/${name}.cpp`);\n'), ['src/lids/lid.cpp']);
  assert.deepEqual(readBy("lint(['src/**/*.cpp']);\n", { 'src/new.cpp': '' }),
    ['src/lids/lid.cpp', 'src/new.cpp', 'src/pot.cpp']);
  assert.deepEqual(readBy("call('npm', ['pack']);\n", { LICENSE: 'MIT' }),
    ['LICENSE', ...Object.keys(sources).filter((file) => file.startsWith('dist/')).sort()]);
});

test('a program that was built is read by its whole name only', () => {
  const built = { 'build/test/cook': '' };
  assert.deepEqual(readBy("join(root, 'build/test/cook');\n", built), ['build/test/cook']);
  assert.deepEqual(readBy("at.indexOf('build/'); readText('build/test/log');\n", built), []);
});

test('comments and documents read nothing, but for the links of the papers', () => {
  assert.deepEqual(readBy("read('README.md');\n", { 'README.md': '[Pots](src/pot.cpp)\n' }),
    ['README.md', 'src/pot.cpp']);
  assert.deepEqual(readBy("// See src/pot.cpp.\n/** As\n * src/pot.cpp. */\nread('notes');\n"),
    ['notes/README.md']);
});

test('tests of the core have it before them, those of the page the page, and no more', () => {
  const files = [...['bindings', 'dist', 'examples', 'src', 'tests', 'web']
    .flatMap((folder) => filesUnder(folder, /./)), 'package.json'];
  const of = readings(files, readText);
  const sees = (/** @type {string} */ name, /** @type {RegExp} */ pattern) =>
    files.filter((file) => file.endsWith(`/${name}.test.js`)).flatMap(of)
      .some((file) => pattern.test(file));
  for (const name of ['api', 'cli', 'faults', 'gltf', 'laws', 'pool', 'quality', 'web', 'queue']) {
    assert.ok(sees(name, /^dist\/remesher\.wasm$/), name);
    assert.ok(!sees(name, /^src\//), name);
  }
  for (const name of ['architecture', 'figures', 'lint', 'texts', 'unit']) {
    assert.ok(sees(name, /^src\/.+\.cpp$/), name);
  }
  for (const name of ['web', 'web_in', 'lint', 'texts']) {
    assert.ok(sees(name, /^web\/main\.js$/), name);
  }
  assert.ok(!sees('api', /^web\//));
  assert.ok(!sees('company', /wasm$/));
});
