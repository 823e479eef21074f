// SPDX-License-Identifier: MIT
// The example for several machines, with a real Redis on a port of its own: thirty jobs, three
// worker processes, one of them killed in the middle of a job; and GNU parallel, for those who need
// no queue.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { once } from 'node:events';
import {
  mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync,
} from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { after, test } from 'node:test';

import { inspect, remeshFile } from 'remesher';

import { offText, stl, torus } from '../support/shapes.js';
import { root } from '../support/tree.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-queue-'));
const limit = 150_000;

/** @type {import('node:child_process').ChildProcess[]} */
const children = [];
after(() => {
  for (const child of children) child.kill('SIGKILL');
  rmSync(folder, { recursive: true });
});

async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  server.close();
  await once(server, 'close');
  return port;
}

/**
 * A program with its lines as they come; it is killed when the test's time is up.
 * @param {string} command @param {string[]} words @param {NodeJS.ProcessEnv} [environment]
 */
function start(command, words, environment = {}) {
  const child = spawn(command, words, { cwd: folder, timeout: limit, killSignal: 'SIGKILL',
    env: { ...process.env, ...environment }, stdio: ['ignore', 'pipe', 'inherit'] });
  children.push(child);
  /** @type {string[]} */
  const lines = [];
  /** @type {((line: string) => void)[]} */
  const listeners = [];
  createInterface(child.stdout).on('line', (line) => {
    lines.push(line);
    for (const listener of listeners) listener(line);
  });
  return { child, lines, ended: once(child, 'exit'),
    onLine: (/** @type {(line: string) => void} */ listener) => listeners.push(listener) };
}

/** @returns {Promise<string>} its address, once it answers */
async function startRedis() {
  const port = await freePort();
  const redis = start('redis-server', ['--port', String(port), '--bind', '127.0.0.1',
    '--save', '', '--appendonly', 'no', '--dir', folder]);
  await new Promise((resolve, reject) => {
    redis.onLine((line) => line.includes('Ready to accept connections') && resolve(undefined));
    redis.child.on('exit', () => reject(new Error(redis.lines.join('\n'))));
  });
  return `redis://127.0.0.1:${port}`;
}

/** Models with a hole that differ, by their names. @param {number} count @param {string} place */
function writeModels(count, place) {
  mkdirSync(join(folder, place));
  for (let i = 0; i < count; i += 1) {
    const mesh = torus({ columns: 12, rows: 8, radius: 2 + i / count });
    const torn = { ...mesh, indices: mesh.indices.slice(0, -3) };
    writeFileSync(join(folder, place, `torus${i}.off`), offText(torn));
  }
}

/** @param {string} line `begins …/torus7.off` */
const named = (line) => /(torus\d+)\.off/.exec(line)?.[1];
const linesOf = (/** @type {{ lines: string[] }} */ { lines }, /** @type {string} */ verb) =>
  lines.filter((line) => line.startsWith(verb)).map(named);

test('thirty jobs are done once each, though a worker dies in the middle of one',
  { timeout: limit }, async () => {
    const environment = { REDIS_URL: await startRedis(), LOCK_MILLISECONDS: '2000' };
    writeModels(30, 'models');
    const run = (/** @type {string} */ name, /** @type {string[]} */ ...words) =>
      start(process.execPath, [join(root, 'examples/queue', name), ...words], environment);
    const workers = [1, 2, 3].map(() => run('worker.js'));
    const [victim, ...others] = workers;
    // Its lines come before the work on the file: it dies with that undone.
    victim.onLine((line) => {
      if (line.startsWith('begins') && victim.lines.length > 6) victim.child.kill('SIGKILL');
    });
    const producer = run('producer.js', 'models', 'results', '60', '{ "repair": "holes" }');
    assert.deepEqual(await producer.ended, [0, null]);

    assert.deepEqual(await victim.ended, [null, 'SIGKILL']);
    const orphan = linesOf(victim, 'begins').find((name) =>
      !linesOf(victim, 'ends').includes(name));
    assert.ok(orphan, 'it died in mid-job');
    assert.ok(others.some((worker) => linesOf(worker, 'ends').includes(orphan)), 'others did it');
    const ends = workers.flatMap((worker) => linesOf(worker, 'ends'));
    assert.deepEqual([ends.length, new Set(ends).size], [30, 30]);
    assert.ok(others.every((worker) => linesOf(worker, 'ends').length > 3), 'all take part');

    assert.equal(producer.lines.at(-1), '30 of 30 files are in results/');
    assert.equal(new Set(producer.lines.slice(0, -1)).size, 30);
    const results = readdirSync(join(folder, 'results'));
    assert.deepEqual(results.sort(),
      Array.from({ length: 30 }, (_, i) => `torus${i}.glb`).sort());
    for (const name of results) {
      const { input } = await inspect(readFileSync(join(folder, 'results', name)), { name });
      assert.equal(input.vertices, 60, name);
      assert.equal(input.boundaryEdges, 0, name);
    }

    for (const { child } of others) child.kill('SIGTERM');
    for (const { ended } of others) assert.deepEqual(await ended, [0, null]);
  });

/** @param {string} place @param {string[]} names */
const mtimes = (place, names) => names.map((name) => statSync(join(folder, place, name)).mtimeMs);

test('a job is one file with one wish: what changed is done again, and nothing else',
  { timeout: limit }, async () => {
    const environment = { REDIS_URL: await startRedis(), LOCK_MILLISECONDS: '2000' };
    const run = (/** @type {string} */ name, /** @type {string[]} */ ...words) =>
      start(process.execPath, [join(root, 'examples/queue', name), ...words], environment);
    writeModels(3, 'changing');
    writeFileSync(join(folder, 'changing/torus0.obj'), 'f 1 2 3\n');
    const worker = run('worker.js');
    const all = ['torus0.off.glb', 'torus1.glb', 'torus2.glb'];
    const produce = async (/** @type {string} */ vertices) => {
      const { ended, lines } = run('producer.js', 'changing', 'changed', vertices);
      const [status] = await ended;
      const begun = linesOf(worker, 'begins').length;
      return { status, last: lines.at(-1), begun, lines };
    };
    const first = await produce('60');
    assert.deepEqual([first.status, first.last, first.begun],
      [2, '3 of 4 files are in changed/', 4]);
    assert.deepEqual(readdirSync(join(folder, 'changed')).sort(), all);
    const before = mtimes('changed', all);

    const again = await produce('60');
    assert.deepEqual([again.status, again.last, again.begun],
      [2, '3 of 4 files are in changed/', 4], 'nothing is done twice, nor tried twice');
    assert.deepEqual(mtimes('changed', all), before);

    const mesh = torus({ columns: 12, rows: 8 });
    const obj = [...Array(mesh.positions.length / 3).keys()].map((i) =>
      `v ${mesh.positions.slice(3 * i, 3 * i + 3).join(' ')}`);
    for (let i = 0; i < mesh.indices.length; i += 3) {
      obj.push(`f ${Array.from(mesh.indices.slice(i, i + 3), (v) => v + 1).join(' ')}`);
    }
    writeFileSync(join(folder, 'changing/torus0.obj'), obj.join('\n'));
    rmSync(join(folder, 'changed/torus1.glb'));
    writeFileSync(join(folder, 'changed/torus2.glb'), 'not what was written');
    const mended = await produce('60');
    assert.deepEqual([mended.status, mended.last, mended.begun],
      [0, '4 of 4 files are in changed/', 7], 'the file that was mended, and two lost results');
    assert.deepEqual(mtimes('changed', all.slice(0, 1)), before.slice(0, 1));

    const fewer = await produce('50');
    assert.deepEqual([fewer.status, fewer.begun], [0, 11], 'other options are other jobs');
    const { input } = await inspect(readFileSync(join(folder, 'changed/torus1.glb')),
      { name: 'torus1.glb' });
    assert.equal(input.vertices, 50);
    const back = await produce('60');
    assert.deepEqual([back.status, back.begun], [0, 15], 'their results took the place');

    writeFileSync(join(folder, 'scan.stl'), stl(mesh));
    const scan = run('scan.js', 'scan.stl', 'scan.glb', '60', '2');
    assert.deepEqual([await scan.ended, scan.lines], [[0, null], ['scan.stl: 60 vertices']]);
    const { bytes } = await remeshFile(readFileSync(join(folder, 'scan.stl')),
      { name: 'scan.stl', output: 'scan.glb', vertices: 60, slabs: 2 });
    assert.deepEqual(readFileSync(join(folder, 'scan.glb')), Buffer.from(bytes),
      'jobs that thin out a slab each, and one that joins them');
    assert.deepEqual(readdirSync(folder).filter((name) => name.endsWith('.ply')), []);

    worker.child.kill('SIGTERM');
    assert.deepEqual(await worker.ended, [0, null]);
  });

test('a job that takes longer than it may is ended', { timeout: limit }, async () => {
  const environment = { REDIS_URL: await startRedis(), JOB_SECONDS: '0.01' };
  writeModels(1, 'slow');
  const worker = start(process.execPath, [join(root, 'examples/queue/worker.js')], environment);
  const producer = start(process.execPath,
    [join(root, 'examples/queue/producer.js'), 'slow', 'late', '200000'], environment);
  assert.deepEqual(await producer.ended, [2, null]);
  assert.equal(producer.lines.at(-1), '0 of 1 files are in late/');
  assert.deepEqual(readdirSync(join(folder, 'late')), []);
  worker.child.kill('SIGTERM');
  assert.deepEqual(await worker.ended, [0, null]);
});

test('GNU parallel spreads files over processes, and over machines with --sshlogin', () => {
  writeModels(6, 'scans');
  mkdirSync(join(folder, 'out'));
  const remesher = `${process.execPath} ${join(root, 'dist/cli/cli.js')}`;
  execFileSync('parallel', ['--will-cite', '--jobs', '2', '--halt', 'soon,fail=1',
    `${remesher} {} -o out/{/.}.glb --vertices 60 --quiet`,
    ':::', ...readdirSync(join(folder, 'scans')).map((name) => join('scans', name))],
  { cwd: folder, timeout: 60_000, stdio: ['ignore', 'pipe', 'inherit'] });
  assert.deepEqual(readdirSync(join(folder, 'out')).sort(),
    Array.from({ length: 6 }, (_, i) => `torus${i}.glb`));
});
