// SPDX-License-Identifier: MIT
// What has the name of a model and is none: links that lead nowhere, pipes, sockets, devices, names
// that are not UTF-8, folders that may not be read. Each is one line, the others are done, and
// nothing waits for ever.
import assert from 'node:assert/strict';
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import {
  chmodSync, lstatSync, mkdirSync, mkdtempSync, readdirSync, rmSync, symlinkSync, writeFileSync,
} from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { snapshot } from '../support/faults.js';
import { objText, torus } from '../support/shape_files.js';
import { root } from '../support/tree.js';

const top = mkdtempSync(join(tmpdir(), 'remesher-special-'));
const at = (...parts) => join(top, ...parts);
const server = createServer();
const cli = join(root, 'dist/cli/cli.js');

/** Runs the command line, for a minute at most. */
const run = (cwd, words, user = {}) => spawnSync(process.execPath, [cli, ...words],
  { cwd, encoding: 'utf8', timeout: 60_000, killSignal: 'SIGKILL', ...user });
const obj = objText(torus(12, 8));

/** A file of a name that is no UTF-8. */
const latin = (folder) => Buffer.concat([Buffer.from(`${folder}/caf`), Buffer.from([0xe9]),
  Buffer.from('.obj')]);

/** Fills a folder with one of everything. */
function fill(folder) {
  mkdirSync(at(folder, 'inner'), { recursive: true });
  writeFileSync(at(folder, 'good.obj'), obj);
  writeFileSync(at(folder, 'inner/fine.obj'), obj);
  symlinkSync('self.obj', at(folder, 'self.obj'));
  symlinkSync('nowhere.obj', at(folder, 'lost.obj'));
  symlinkSync('..', at(folder, 'loop'));
  symlinkSync('inner', at(folder, 'folder.obj'));
  symlinkSync('/dev/zero', at(folder, 'device.obj'));
  execFileSync('mkfifo', [at(folder, 'pipe.obj')]);
  writeFileSync(latin(at(folder)), obj);
}

const whys = {
  'self.obj': 'its links lead nowhere',
  'lost.obj': 'it is a link that leads nowhere',
  'device.obj': 'it is a device',
  'pipe.obj': 'it is a pipe, and no program writes into it',
  'socket.obj': 'it is a socket',
};

before(async () => {
  fill('in');
  await new Promise((resolve) => server.listen(at('in/socket.obj'), resolve));
});
after(() => {
  server.close();
  rmSync(top, { recursive: true });
});

/** The lines by the file that each begins with. */
const byFile = (stderr) => Object.fromEntries(stderr.trim().split('\n').map((line) => {
  const [, file, rest] = /^remesher: (in\/[^:]*): (.*)$/.exec(line) ?? [];
  return [file, rest];
}));

test('below a folder: one line each, the others are done', () => {
  const { status, stdout, stderr } =
    run(top, ['convert', 'in/', '-o', 'out/', '--format', 'glb', '--jobs', '4', '--quiet']);
  assert.deepEqual([status, stdout], [2, ''], stderr);
  const lines = byFile(stderr);
  const latinName = 'in/caf\\xe9.obj';
  assert.deepEqual(Object.keys(lines).sort(),
    [...Object.keys(whys).map((name) => `in/${name}`), latinName].sort());
  for (const [name, why] of Object.entries(whys)) {
    assert.ok(lines[`in/${name}`].includes(` cannot be read: ${why}.`), lines[`in/${name}`]);
  }
  assert.match(lines[latinName], /its name is not UTF-8\. Rename it\./);
  assert.deepEqual(Object.keys(snapshot(at('out'))), ['good.glb', 'inner/fine.glb']);
});

test('among several inputs, and by a pattern, with --json', () => {
  const named = ['good.obj', ...Object.keys(whys), 'nothere.obj'].map((name) => `in/${name}`);
  for (const words of [named, ['in/*.obj', 'in/none*', 'in/nothere.obj']]) {
    const { status, stdout, stderr } = run(top, ['convert', ...words, '-o', 'several/',
      '--format', 'glb', '--json', '--force']);
    assert.equal(status, 2, stderr);
    const outcomes = stdout.trim().split('\n').map((line) => JSON.parse(line));
    const failed = outcomes.filter(({ error }) => error);
    assert.equal(stderr.trim().split('\n').length, failed.length);
    assert.ok(failed.every(({ error }) => error.code === 'INPUT_UNREADABLE'));
    const files = failed.map(({ file }) => file);
    for (const name of [...Object.keys(whys), 'nothere.obj']) {
      assert.ok(files.includes(`in/${name}`), `${name}: ${files}`);
    }
    assert.deepEqual(outcomes.filter(({ error }) => !error).map(({ file }) => file),
      ['in/good.obj']);
  }
});

test('alone: one line, with status 2', () => {
  const all = { ...whys, 'folder.obj': 'it is a folder', 'caf\ufffd.obj': 'its name is not UTF-8' };
  for (const [name, why] of Object.entries(all)) {
    const { status, stdout, stderr } = run(top, ['inspect', join('in', name)]);
    assert.deepEqual([status, stdout], [2, '']);
    assert.match(stderr, /^remesher: [^\n]+\n$/);
    assert.ok(stderr.includes(` cannot be read: ${why}.`), stderr);
  }
});

test('a pipe is read while a program writes into it, however late it begins and slow it is',
  async () => {
    const child = spawn('bash', ['-c', `(head -c 500; sleep 0.3; cat) < '${at('in/good.obj')}' `
      + `> '${at('in/pipe.obj')}'`]);
    const { status, stdout, stderr } = run(top, ['inspect', 'in/pipe.obj']);
    assert.equal(status, 0, stderr);
    assert.match(stdout, /^input: .*96 vertices/);
    if (child.exitCode === null) await once(child, 'exit');
  });

test('a folder that may not be read is one line, and the others are done', () => {
  mkdirSync(at('shared/locked'), { recursive: true });
  writeFileSync(at('shared/good.obj'), obj);
  writeFileSync(at('shared/locked/no.obj'), obj);
  mkdirSync(at('results'));
  chmodSync(at('shared/locked'), 0);
  for (const folder of [top, at('results')]) chmodSync(folder, 0o777);
  // To root all is permitted.
  const user = process.getuid?.() === 0 ? { uid: 65534, gid: 65534 } : {};
  const asUser = (...words) => run(top, ['convert', ...words], user);
  for (const words of [['shared/'], ['shared/**/*.obj'],
    ['shared/good.obj', 'shared/locked/no.obj', 'shared/locked']]) {
    const { status, stderr } =
      asUser(...words, '-o', 'results/', '--format', 'glb', '--force', '--quiet');
    assert.equal(status, 2, stderr);
    const lines = stderr.trim().split('\n');
    assert.equal(lines.length, words.length === 1 ? 1 : 2, stderr);
    for (const line of lines) assert.match(line, /locked[^:]* cannot be read: permission is/);
    assert.deepEqual(readdirSync(at('results')), ['good.glb']);
  }
  const { status, stderr } = asUser('shared/good.obj', '-o', 'shared/locked/');
  assert.equal(status, 2);
  assert.match(stderr, /^remesher: [^\n]*cannot be written: permission is denied[^\n]*\n$/);
  chmodSync(at('shared/locked'), 0o755);
});

test('as an output each is one line, and stays as it is', () => {
  fill('taken');
  const entries = () => readdirSync(Buffer.from(at('taken')), { encoding: 'buffer' })
    .map((name) => lstatSync(Buffer.concat([Buffer.from(at('taken/')), name])).ino);
  const inodes = entries();
  const outputs = {
    'self.obj': 'its links lead nowhere',
    'lost.obj': 'it is a link that leads nowhere',
    'device.obj': 'it is a device',
    'pipe.obj': 'it is a pipe',
    'folder.obj': 'it is a folder',
    'caf\ufffd.obj': 'its name is not UTF-8',
    'self.obj/inner.obj': 'its links lead nowhere',
    'pipe.obj/inner.obj': 'a part of its path is not a folder',
  };
  for (const [name, why] of Object.entries(outputs)) {
    const { status, stderr } = run(top, ['convert', 'in/good.obj', '-o', join('taken', name)]);
    assert.equal(status, 2, name);
    assert.match(stderr, /^remesher: [^\n]+\n$/);
    assert.ok(stderr.includes(` cannot be written: ${why}.`), stderr);
  }
  for (const folder of ['self.obj/', 'lost.obj/', 'pipe.obj/', 'device.obj/']) {
    const { status, stderr } = run(top, ['convert', 'in/good.obj', '-o', join('taken', folder)]);
    assert.equal(status, 2, folder);
    assert.match(stderr, /^remesher: [^\n]*cannot be written: [^\n]*\n$/);
  }
  assert.deepEqual(entries(), inodes);
});

test('a result whose place is taken by one of these fails alone', () => {
  mkdirSync(at('places'));
  mkdirSync(at('two'));
  for (const name of ['a', 'b', 'c']) writeFileSync(at('two', `${name}.obj`), obj);
  symlinkSync('b.glb', at('places/b.glb'));
  execFileSync('mkfifo', [at('places/c.glb')]);
  const { status, stderr } = run(top, ['convert', 'two/', '-o', 'places/', '--format', 'glb',
    '--force', '--quiet']);
  assert.equal(status, 2);
  assert.deepEqual(stderr.match(/^remesher: two\/.\.obj:/gm).sort(),
    ['remesher: two/b.obj:', 'remesher: two/c.obj:']);
  assert.equal(stderr.trim().split('\n').length, 2);
  assert.ok(lstatSync(at('places/a.glb')).isFile());
  assert.ok(lstatSync(at('places/c.glb')).isFIFO());
});
