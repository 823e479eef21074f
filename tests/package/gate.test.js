// SPDX-License-Identifier: MIT
// Which files a model can have read and written, on a tree made for the purpose: those in its own
// folder and below, or below --root; and with all the cunning there is, no other.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  existsSync, mkdirSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';

import * as api from 'remesher';

import { legible } from '../../dist/base/legible.js';
import { runFile } from '../../dist/cli/run_file.js';
import {
  carriers, contentsOf, makeTree, modelWithLibrary, secret, tricksFor,
} from '../support/attacks.js';
import { root as checkout } from '../support/tree.js';

const { top, close } = await makeTree();
after(() => {
  close();
  rmSync(top, { recursive: true });
});
const at = (...parts) => join(top, ...parts);
/** Runs in this process, as the command line does. */
function run(command, input, output, more = {}) {
  return runFile({ command, input, output, outputName: output.split('/').at(-1), root: undefined,
    force: false, options: {}, ...more }, api, { worker: false });
}

function clearOutput() {
  rmSync(at('out'), { recursive: true });
  mkdirSync(at('out'));
}

/** All that a run says: its warnings, or why it failed. */
async function wordsOf(promise) {
  try {
    const { report } = await promise;
    return report.warnings.map(({ message }) => message).join('\n');
  } catch (error) {
    assert.ok(error instanceof api.RemeshError, String(error));
    assert.equal(error.code, 'MISSING_RESOURCE', error.message);
    return `${error.message} ${error.hint}`;
  }
}

for (const [model, bytesFor] of Object.entries(carriers)) {
  const tricks = tricksFor(top);
  test(`${model}: ${tricks.length} ways to name a file outside, none read, each said`, async () => {
    for (const trick of tricks) {
      if (model.endsWith('.obj') && /[\n\r]/.test(trick)) continue;
      clearOutput();
      writeFileSync(at('models', model), bytesFor(trick));
      const before = contentsOf(top);
      const said = await wordsOf(run('convert', at('models', model), at('out', model)));
      const outside = (line) => !line.startsWith(`${at('out')}/`);
      assert.deepEqual(contentsOf(top).filter(outside), before.filter(outside), trick);
      assert.ok(said.includes(legible(trick)), `${trick}: ${said}`);
      const written = readdirSync(at('out'), { recursive: true });
      assert.deepEqual(written.filter((name) => name !== model && name !== 'buffer.bin'
        && name !== 'image.bin'), [], trick);
      for (const name of written) assert.ok(!readFileSync(at('out', name)).includes(secret), trick);
    }
  });
}

test('the images of a material library are not read, and each is said', async () => {
  writeFileSync(at('models/library.obj'), modelWithLibrary['library.obj']);
  for (const trick of tricksFor(top)) {
    clearOutput();
    writeFileSync(at('models/beside.mtl'), modelWithLibrary['beside.mtl'](trick));
    const said = await wordsOf(run('convert', at('models/library.obj'), at('out/library.obj')));
    assert.ok(said.includes(legible(trick)), `${trick}: ${said}`);
    assert.deepEqual(readdirSync(at('out')), ['beside.mtl', 'library.obj']);
  }
  rmSync(at('models/beside.mtl'));
});

test('what lies below the model’s folder is read and passed on', async () => {
  for (const name of ['inner/own.png', './inner/own.png', 'inner%2fown.png', 'inner\\own.png',
    'within.png']) {
    clearOutput();
    writeFileSync(at('models/image.gltf'), carriers['image.gltf'](name));
    const { report } = await run('convert', at('models/image.gltf'), at('out/image.gltf'));
    assert.deepEqual(report.warnings, [], name);
    const [{ uri }] = JSON.parse(readFileSync(at('out/image.gltf'), 'utf8')).images;
    assert.equal(readFileSync(at('out', decodeURIComponent(uri)), 'utf8'), '\x89PNG own', name);
  }
});

test('--root lets a model read from above; that is laid in under a plain name', async () => {
  const from = at('models/image.gltf');
  const to = at('out/image.gltf');
  writeFileSync(from, carriers['image.gltf']('../textures/wood.png'));
  const refused = await wordsOf(run('convert', from, to));
  assert.match(refused, /\.\.\/textures\/wood\.png is not read: it lies outside.*--root DIR/);
  clearOutput();
  const { report } = await run('convert', from, to, { root: top });
  assert.deepEqual(report.warnings, []);
  assert.deepEqual(readdirSync(at('out')).sort(), ['image.gltf', 'wood.png']);
  assert.equal(JSON.parse(readFileSync(to, 'utf8')).images[0].uri, 'wood.png');
  assert.equal(readFileSync(at('out/wood.png'), 'latin1'), '\xc2\x89PNG wood');
});

test('an OBJ’s library from above is laid in, and named so', async () => {
  writeFileSync(at('textures/red.mtl'), 'newmtl red\n');
  writeFileSync(at('models/library.obj'), carriers['library.obj']('../textures/red.mtl'));
  clearOutput();
  await run('convert', at('models/library.obj'), at('out/library.obj'), { root: top });
  assert.match(readFileSync(at('out/library.obj'), 'utf8'), /^mtllib red\.mtl$/m);
  assert.equal(readFileSync(at('out/red.mtl'), 'utf8'), 'newmtl red\n');
});

test('--root is a wall too', async () => {
  writeFileSync(at('models/image.gltf'), carriers['image.gltf']('../../../etc/passwd'));
  clearOutput();
  const said = await wordsOf(run('convert', at('models/image.gltf'), at('out/image.gltf'),
    { root: top }));
  assert.match(said, /is not read: it lies outside/);
  await assert.rejects(run('convert', at('models/image.gltf'), at('out/image.gltf'),
    { root: at('textures') }), /no folder that holds/);
  await assert.rejects(run('convert', at('models/image.gltf'), at('out/image.gltf'),
    { root: at('nothere') }), /there is no such file or folder/);
});

test('thousands of names are said in a few lines', async () => {
  const images = Array.from({ length: 3000 }, (_, i) => ({ uri: `../${i}.png` }));
  const model = JSON.parse(new TextDecoder().decode(carriers['image.gltf']('x')));
  writeFileSync(at('models/image.gltf'), JSON.stringify({ ...model, images }));
  clearOutput();
  const { report } = await run('convert', at('models/image.gltf'), at('out/image.gltf'));
  assert.ok(report.warnings.length < 20);
  assert.match(report.warnings.at(-1).message, /2990 more files are not read/);
});

test('a name that all objects have is a name like others', async () => {
  writeFileSync(at('models/__proto__'), '\x89PNG');
  writeFileSync(at('models/image.gltf'), carriers['image.gltf']('__proto__'));
  clearOutput();
  await run('convert', at('models/image.gltf'), at('out/image.gltf'));
  assert.ok(existsSync(at('out/__proto__')));
});

test('names of results are plain for whoever writes them: pages, servers', async () => {
  for (const trick of tricksFor(top)) {
    const { files } = await api.convertFile(carriers['image.gltf'](trick),
      { name: 'm.gltf', resources: { [trick]: new Uint8Array([1]) }, worker: false });
    assert.equal(files.length, 2, trick);
    for (const { name } of files) {
      assert.match(name, /^(?!\.)[^/\\:]+(\/(?!\.)[^/\\:]+)*$/, trick);
      // eslint-disable-next-line no-control-regex
      assert.doesNotMatch(name, /[\u0000-\u001f]|%2e|%2f|%5c/i, trick);
    }
    const { files: [main] } = await api.convertFile(carriers['image.gltf']('data:,'),
      { name: trick, output: `${trick}.glb`, worker: false });
    assert.match(main.name, /^[^./\\:][^/\\:]*\.glb$/, trick);
  }
});

test('a link among the output’s folders does not lead a companion out', async () => {
  writeFileSync(at('models/image.gltf'), carriers['image.gltf']('inner/own.png'));
  clearOutput();
  symlinkSync('../outside', at('out/inner'));
  const before = contentsOf(top);
  await assert.rejects(run('convert', at('models/image.gltf'), at('out/image.gltf')),
    /a link leads out of the output’s folder/);
  assert.deepEqual(contentsOf(top), before);
});

const cli = (...words) => spawnSync(process.execPath, [join(checkout, 'dist/cli/cli.js'), ...words],
  { cwd: at('models'), encoding: 'utf8', timeout: 20_000 });

test('the command says what it did not read, and what would help', () => {
  writeFileSync(at('models/image.gltf'), carriers['image.gltf']('../\x1b[2J.png'));
  clearOutput();
  const done = cli('convert', 'image.gltf', '-o', '../out/image.gltf');
  assert.equal(done.status, 0, done.stderr);
  assert.match(done.stderr, /^warning: \.\.\/\\u\{1b\}\[2J\.png is not read: .*--root DIR/m);
  writeFileSync(at('models/buffer.gltf'), carriers['buffer.gltf']('pipe.png'));
  const failed = cli('inspect', 'buffer.gltf');
  assert.equal(failed.status, 2);
  assert.match(failed.stderr, /^remesher: .*needs pipe\.png.*it is a pipe.*MISSING_RESOURCE\]\n$/);
});

test('an input that is a device is refused; a pipe will do', () => {
  assert.match(cli('inspect', '/dev/zero').stderr, /it is a device/);
  const piped = spawnSync('bash', ['-c', `cat image.gltf | ${process.execPath} `
    + `${join(checkout, 'dist/cli/cli.js')} inspect /dev/stdin`],
  { cwd: at('models'), encoding: 'utf8' });
  assert.match(piped.stdout, /12 vertices/, piped.stderr);
});
