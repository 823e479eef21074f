// SPDX-License-Identifier: MIT
// Whatever goes wrong while results are written: the output is the old one or the new one, whole,
// and nothing else is left behind or written over.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  cpSync, linkSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, statSync,
  symlinkSync, utimesSync, writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import {
  endedAtUnlock, interrupted, makeReadOnly, mountSmall, randomFrom, run, runHere, runLimited,
  snapshot, start, statesDuring,
} from '../support/faults.js';
import { glbBytes, gltfParts, objText, torus } from '../support/shape_files.js';
import { root } from '../support/tree.js';

const top = mkdtempSync(join(tmpdir(), 'remesher-faults-'));
after(() => rmSync(top, { recursive: true }));
const at = (...parts) => join(top, ...parts);

writeFileSync(at('old.obj'), objText(torus(30, 20)));
writeFileSync(at('new.obj'), objText(torus(80, 40)));
writeFileSync(at('small.obj'), objText(torus(6, 5)));

/** A folder with the results of the old model; and what those of the newer one will be. */
async function prepared(name, format, newer = 'new') {
  for (const [folder, model] of [['old', 'old'], ['new', newer]]) {
    mkdirSync(at(name, folder), { recursive: true });
    await runHere(top, 'convert', `${model}.obj`, '-o', `${name}/${folder}/x.${format}`);
  }
  const [before, wanted] = [snapshot(at(name, 'old')), snapshot(at(name, 'new'))];
  const restore = () => {
    rmSync(at(name, 'old'), { recursive: true });
    mkdirSync(at(name, 'old'));
    for (const [file, text] of Object.entries(before)) {
      writeFileSync(at(name, 'old', file), text, 'latin1');
    }
  };
  return { folder: at(name, 'old'), before, wanted, restore,
    words: ['convert', `${newer}.obj`, '-o', `${name}/old/x.${format}`] };
}

/** Half of them over the whole run, half when it has begun to write. */
function* moments(count, { folder, words }, seed) {
  const random = randomFrom(seed);
  const begin = performance.now();
  run(top, ...words);
  const duration = performance.now() - begin;
  for (let i = 0; i < count / 2; i += 1) yield { after: random() * duration };
  for (let i = 0; i < count / 2; i += 1) yield { after: random() * 30, since: folder };
}

test('SIGKILL at 4 moments: the output is the old one or the new one', async (t) => {
  const work = await prepared('kill', 'glb');
  const { folder, before, wanted, restore, words } = work;
  const seen = { old: 0, new: 0 };
  for (const moment of moments(4, work, 20161216)) {
    restore();
    await interrupted(top, words, { signal: 'SIGKILL', ...moment });
    const { 'x.glb': found, ...others } = snapshot(folder);
    assert.ok(found === before['x.glb'] || found === wanted['x.glb'], JSON.stringify(moment));
    seen[found === before['x.glb'] ? 'old' : 'new'] += 1;
    for (const name of Object.keys(others)) assert.match(name, /^\.x\.glb\.\d+-\w{8}\.part$/);
  }
  t.diagnostic(JSON.stringify(seen));
});

/** A .gltf and what it refers to, wherever that is; what the file is called does not matter. */
function wholeGltf(files) {
  const { buffers: [{ uri, ...buffer }], ...tree } = JSON.parse(files['x.gltf']);
  return JSON.stringify({ ...tree, buffer, data: files[decodeURIComponent(uri)] });
}

/** An .obj and its library. */
function wholeObj(files) {
  const [line, name] = /^mtllib (.*)\n/m.exec(files['x.obj']);
  return JSON.stringify([files['x.obj'].replace(line, ''), files[name]]);
}

test('SIGKILL at 4 moments: an output of two files is whole, the old one or the new one',
  async (t) => {
    const work = await prepared('pair', 'gltf');
    const { folder, before, wanted, restore, words } = work;
    const seen = { old: 0, new: 0 };
    for (const moment of moments(4, work, 20161217)) {
      restore();
      await interrupted(top, words, { signal: 'SIGKILL', ...moment });
      const found = wholeGltf(snapshot(folder));
      const isOld = found === wholeGltf(before);
      assert.ok(isOld || found === wholeGltf(wanted), JSON.stringify(moment));
      seen[isOld ? 'old' : 'new'] += 1;
    }
    t.diagnostic(JSON.stringify(seen));
  });

/** A model and its library, converted from others of the same name. */
async function preparedWithLibrary() {
  for (const [model, shape, color] of [['one', torus(5, 4), 1], ['two', torus(6, 5), 0]]) {
    mkdirSync(at(model));
    writeFileSync(at(model, 'm.obj'), `mtllib x.mtl\nusemtl paint\n${objText(shape)}`);
    writeFileSync(at(model, 'x.mtl'), `newmtl paint\nKd ${color} 0 0\n`);
  }
  for (const [model, name] of [['one', 'old'], ['two', 'new']]) {
    mkdirSync(at('library', name), { recursive: true });
    await runHere(top, 'convert', `${model}/m.obj`, '-o', `library/${name}/x.obj`);
  }
  return { folder: at('library/old'), before: snapshot(at('library/old')),
    wanted: snapshot(at('library/new')),
    words: ['convert', 'two/m.obj', '-o', 'library/old/x.obj', '--force'] };
}

const pairs = { '.gltf': [() => prepared('steps', 'gltf', 'small'), wholeGltf],
  '.obj': [preparedWithLibrary, wholeObj] };

for (const [format, [prepare, wholeOf]] of Object.entries(pairs)) {
  test(`a SIGKILL before any change to a folder leaves the ${format} whole`, async (t) => {
    const { folder, before, wanted, words } = await prepare();
    const states = statesDuring(top, words, folder);
    assert.deepEqual(snapshot(folder), wanted);
    const seen = { old: 0, new: 0 };
    for (const [step, left] of states.entries()) {
      rmSync(folder, { recursive: true });
      renameSync(left, folder);
      const found = wholeOf(snapshot(folder));
      const isOld = found === wholeOf(before);
      assert.ok(isOld || found === wholeOf(wanted), `step ${step}`);
      seen[isOld ? 'old' : 'new'] += 1;
      await runHere(top, ...words);  // what was left is in nobody’s way
      const mended = snapshot(folder);
      for (const name of Object.keys(wanted)) assert.equal(mended[name], wanted[name]);
    }
    t.diagnostic(JSON.stringify(seen));
    assert.ok(seen.old > 4 && seen.new > 4, JSON.stringify(seen));
  });
}

for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) {
  test(`${signal} leaves nothing behind`, async () => {
    const { folder, before, wanted, restore, words } = await prepared(signal, 'gltf');
    const random = randomFrom(signal.length * 7919);
    for (let i = 0; i < 2; i += 1) {
      restore();
      const moment = { after: random() * 20, since: folder };
      const ended = await interrupted(top, words, { signal, ...moment });
      const found = snapshot(folder);
      if (ended.signal === signal) assert.deepEqual(Object.keys(found), Object.keys(before));
      if (found['x.gltf'] === before['x.gltf']) assert.deepEqual(found, before);
      else assert.deepEqual(found, wanted);
    }
  });
}

test('a signal when all is written but the lock is there leaves no lock', async () => {
  const { folder, wanted, words } = await prepared('unlock', 'gltf', 'small');
  endedAtUnlock(top, words);
  assert.deepEqual(snapshot(folder), wanted);
});

test('two runs, and four, to one output do not mix', async () => {
  const { folder, before, wanted, words } = await prepared('race', 'gltf');
  const others = ['convert', 'old.obj', ...words.slice(2)];
  for (const count of [2, 4]) {
    const runs = Array.from({ length: count }, (_, i) =>
      start(top, ...(i % 2 === 0 ? words : others), '--force').ended);
    for (const { status } of await Promise.all(runs)) assert.equal(status, 0);
    const found = snapshot(folder);
    assert.deepEqual(found, found['x.gltf'] === before['x.gltf'] ? before : wanted);
  }
});

test('a full disk leaves the old output, and nothing else', async (t) => {
  const { folder, before, words } = await prepared('full', 'gltf');
  const limited = runLimited(top, 64, words);
  assert.equal(limited.status, 2, limited.stderr);
  assert.match(limited.stderr, /^remesher: .*x\.gltf cannot be written: it is larger[^\n]*\n$/);
  assert.deepEqual(snapshot(folder), before);

  const mounted = mountSmall(at('small'), '96k');
  if (!mounted) {
    t.diagnostic('no file system could be mounted: the limit of a file’s length stood for it');
    return;
  }
  try {
    cpSync(folder, at('small'), { recursive: true });
    const filled = snapshot(at('small'));
    const { status, stderr } = run(top, 'convert', 'new.obj', '-o', 'small/x.gltf', '--force');
    assert.equal(status, 2, stderr);
    assert.match(stderr, /^remesher: .*x\.gltf cannot be written: the disk is full[^\n]*\n$/);
    assert.deepEqual(snapshot(at('small')), filled);
    assert.equal(run(top, 'convert', 'new.obj', '-o', 'small/new/sub/x.gltf').status, 2);
    assert.deepEqual(snapshot(at('small')), filled);
  } finally {
    mounted.undo();
  }
});

test('a full standard output is said', () => {
  const { status, stderr } = spawnSync('bash', ['-c', `${process.execPath} `
    + `${join(root, 'dist/cli/cli.js')} convert old.obj -o - --format glb > /dev/full`],
  { cwd: top, encoding: 'utf8' });
  assert.equal(status, 2);
  assert.match(stderr, /^remesher: The standard output cannot be written: the disk is full/);
});

test('a folder that cannot be written is said, before the work', () => {
  const { folder, undo } = makeReadOnly(at('readonly'));
  try {
    const { status, stderr } = run(top, 'new.obj', '-o', join(folder, 'x.glb'));
    assert.equal(status, 2);
    assert.match(stderr, /x\.glb cannot be written: [^\n]*\[OUTPUT_UNWRITABLE\]\n$/);
  } finally {
    undo();
  }
  assert.match(run(top, 'convert', 'old.obj', '-o', 'old.obj/x.glb').stderr, /is not a folder/);
});

test('nothing is written over what was read, by whatever name it is called', () => {
  mkdirSync(at('input'));
  writeFileSync(at('input/x.glb'), glbBytes(torus(5, 4)));
  linkSync(at('input/x.glb'), at('input/y.glb'));
  symlinkSync('x.glb', at('input/z.glb'));
  symlinkSync('.', at('input/again'));
  const before = snapshot(at('input'));
  assert.equal(run(at('input'), 'x.glb', '-o', 'x.glb').status, 2, 'without --force, too');
  for (const output of ['x.glb', './x.glb', 'again/x.glb', 'y.glb', 'z.glb']) {
    const { status, stderr } = run(at('input'), 'x.glb', '-o', output, '--force');
    assert.equal(status, 2, output);
    assert.match(stderr, /one of the files that were read/);
    assert.deepEqual(snapshot(at('input')), before);
  }
});

test('a companion never takes the place of one that was read', () => {
  mkdirSync(at('resource'));
  const { json, buffer } = gltfParts(torus(5, 4));
  const tree = { ...json, buffers: [{ ...json.buffers[0], uri: 'y.bin' }] };
  writeFileSync(at('resource/x.gltf'), JSON.stringify(tree));
  writeFileSync(at('resource/y.bin'), buffer);
  const { status, stderr } =
    run(at('resource'), 'x.gltf', '-o', 'y.gltf', '--vertices', '30', '--force');
  assert.equal(status, 2);
  assert.match(stderr, /y\.bin cannot be written: it is one of the files that were read/);
  assert.deepEqual(readdirSync(at('resource')).sort(), ['x.gltf', 'y.bin']);
  assert.deepEqual(readFileSync(at('resource/y.bin')), buffer);
});

test('a companion that is there already stays, unless it is the same or --force is given',
  async () => {
    const { folder, wanted, words } = await prepared('there', 'gltf');
    rmSync(join(folder, 'x.gltf'));
    writeFileSync(join(folder, 'x.bin'), 'mine');
    const { status, stderr } = run(top, ...words);
    assert.equal(status, 2);
    assert.match(stderr, /x\.bin cannot be written: it is there already.*--force/);
    assert.deepEqual(snapshot(folder), { 'x.bin': 'mine' });
    assert.equal(run(top, ...words, '--force').status, 0);
    assert.deepEqual(snapshot(folder), wanted);

    const { mtimeMs } = statSync(join(folder, 'x.bin'));
    rmSync(join(folder, 'x.gltf'));
    assert.equal(run(top, ...words).status, 0, 'the same bytes are in nobody’s way');
    assert.equal(statSync(join(folder, 'x.bin')).mtimeMs, mtimeMs);
  });

test('a .gltf that is replaced takes its own data with it', async () => {
  const { folder, wanted, words } = await prepared('own', 'gltf');
  assert.equal(run(top, ...words).status, 0);
  assert.deepEqual(snapshot(folder), wanted);
});

test('what killed runs left is cleaned away by a later one; what is young or foreign stays', () => {
  mkdirSync(at('left'));
  const dead = spawnSync('true').pid;
  const long = ['.x.glb.1', '.y.glb.1'].map((name) => `${name}-0123abcd.part`);
  for (const name of [`.x.glb.${dead}-0123abcd.part`, `.x.glb.${dead}-0123abcd.old`, ...long]) {
    writeFileSync(at('left', name), 'part');
    utimesSync(at('left', name), 1, 1);
  }
  writeFileSync(at(`left/.x.glb.${dead}-00000000.part`), 'young');
  writeFileSync(at('left/.x.gltf.lock'), `${dead} ${spawnSync('hostname', { encoding: 'utf8' })
    .stdout.trim()} 0`);
  assert.equal(run(top, 'convert', 'old.obj', '-o', 'left/x.glb').status, 0);
  assert.equal(run(top, 'convert', 'old.obj', '-o', 'left/x.gltf').status, 0);
  assert.deepEqual(readdirSync(at('left')).sort(), [`.x.glb.${dead}-00000000.part`, ...long,
    'x.bin', 'x.glb', 'x.gltf'].sort());
});
