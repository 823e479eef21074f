// SPDX-License-Identifier: MIT
// A pool of workers gives what the package gives, and settles whatever becomes of its jobs.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { after, test } from 'node:test';

import { convertFile, inspect, remesh, remeshFile, remeshScene, repair } from 'remesher';
import { Pool } from 'remesher/pool';

import { PoolOf } from '../../dist/api/pool_of.js';
import * as platform from '../../dist/platform_node.js';
import { rejectsWith } from '../support/errors.js';
import { offText, torus } from '../support/shapes.js';
import { root } from '../support/tree.js';

const shared = new Pool({ size: 2 });
after(() => shared.close());

const small = torus({ columns: 16, rows: 8 });
const large = torus({ columns: 400, rows: 200 });
const isAbort = { name: 'AbortError' };

/** A pool whose platform counts its workers, made and not yet ended, and its compilations. */
function countedPool(size) {
  const counts = { made: 0, alive: 0, compiled: 0 };
  const spawn = () => {
    counts.made += 1;
    counts.alive += 1;
    const port = platform.spawn();
    return { ...port, terminate() {
      counts.alive -= 1;
      port.terminate();
    } };
  };
  const compileArrays = () => {
    counts.compiled += 1;
    return platform.compileArrays();
  };
  return { pool: new PoolOf({ ...platform, spawn, compileArrays }, { size }), counts };
}

/** Without what a clock says. */
const timeless = ({ report, ...others }) => ({ ...others,
  output: report?.output, fidelity: report?.fidelity });

test('every function gives what it gives without a pool', async () => {
  const bytes = new TextEncoder().encode(offText(small));
  const file = { name: 'torus.off', output: 'torus.ply' };
  assert.deepEqual(timeless(await shared.remesh(small, { vertices: 200 })),
    timeless(await remesh(small, { vertices: 200 })));
  assert.deepEqual(timeless(await shared.remeshScene([{ mesh: small }], { vertices: 90 })),
    timeless(await remeshScene([{ mesh: small }], { vertices: 90 })));
  assert.deepEqual(timeless(await shared.remeshFile(bytes, { ...file, vertices: 90 })),
    timeless(await remeshFile(bytes, { ...file, vertices: 90 })));
  assert.deepEqual(await shared.convertFile(bytes, file), await convertFile(bytes, file));
  assert.deepEqual((await shared.inspect(small)).input, (await inspect(small)).input);
});

test('quads and repair are the same in a pool, and alone', async () => {
  const open = { ...small, indices: small.indices.slice(0, -6) };
  const options = { vertices: 200, quads: true, repair: 'holes' };
  const [pooled, alone] = [await shared.remesh(open, options), await remesh(open, options)];
  assert.deepEqual(timeless(pooled), timeless(alone));
  assert.equal(pooled.mesh.quads.length / 4, pooled.report.output.quads.count);
  assert.deepEqual([pooled.report.repair.holes, pooled.report.output.boundaryEdges], [1, 0]);
  assert.deepEqual((await shared.repair(open)).mesh, (await repair(open)).mesh);
});

test('fifty jobs at once settle, each with its own result', async () => {
  const { pool, counts } = countedPool(2);
  const targets = Array.from({ length: 50 }, (_, i) => 60 + i);
  const results = await Promise.all(targets.map((vertices) => pool.remesh(small, { vertices })));
  assert.deepEqual(results.map(({ mesh }) => mesh.positions.length / 3), targets);
  assert.deepEqual(counts, { made: 2, alive: 2, compiled: 1 });
  pool.close();
  assert.equal(counts.alive, 0);
});

test('no more workers start than are needed', async () => {
  const { pool, counts } = countedPool(8);
  for (let i = 0; i < 3; i += 1) await pool.remesh(small, { vertices: 80 });
  assert.equal(counts.made, 1);
  await pool.init();
  assert.equal(counts.made, 8);
  pool.close();
});

test('two workers are busy at once', async () => {
  const { pool } = countedPool(2);
  const phases = [new Set(), new Set()];
  const controller = new AbortController();
  const runs = phases.map((seen) => pool.remesh(large, {
    signal: controller.signal,
    onProgress({ phase }) {
      seen.add(phase);
      if (phases.every(({ size }) => size > 0)) controller.abort();
    },
  }));
  for (const run of runs) await assert.rejects(run, isAbort);
  pool.close();
});

test('a job that is aborted leaves the others alone, running or waiting', async () => {
  const { pool, counts } = countedPool(1);
  const [running, waiting] = [new AbortController(), new AbortController()];
  const jobs = [
    pool.remesh(large, { signal: running.signal, onProgress: () => running.abort() }),
    pool.remesh(small, { vertices: 70, signal: waiting.signal }),
    pool.remesh(small, { vertices: 80 }),
    pool.remesh(small, { vertices: 90 }),
  ];
  waiting.abort();
  const ends = await Promise.allSettled(jobs);
  assert.deepEqual(ends.map(({ status }) => status),
    ['rejected', 'rejected', 'fulfilled', 'fulfilled']);
  assert.deepEqual(ends.slice(0, 2).map(({ reason }) => reason.name), ['AbortError', 'AbortError']);
  assert.deepEqual(ends.slice(2).map(({ value }) => value.mesh.positions.length / 3), [80, 90]);
  assert.deepEqual([counts.made, counts.alive], [2, 1]);
  pool.close();
});

test('a bad job is refused and the next one runs', async () => {
  await rejectsWith(shared.remesh(small, { vertices: 1 }), 'TARGET_TOO_SMALL', /1/);
  await rejectsWith(shared.remesh(small, { vertexes: 1 }), 'UNKNOWN_OPTION', /vertexes/);
  await rejectsWith(shared.remesh(small, { worker: 1 }), 'INVALID_OPTION', /worker/);
  assert.equal((await shared.remesh(small, { vertices: 100 })).report.output.vertices, 100);
  const here = await shared.remesh(small, { vertices: 100, worker: false });
  assert.equal(here.report.output.vertices, 100);
});

test('closing rejects all that runs or waits or comes later, and ends the workers', async () => {
  const { pool, counts } = countedPool(2);
  /** @type {Promise<void>[]} */
  const jobs = [];
  await new Promise((resolve) => {
    for (let i = 0; i < 5; i += 1) jobs.push(pool.remesh(large, { onProgress: resolve }));
  });
  pool.close();
  pool.close();
  for (const job of jobs) await assert.rejects(job, isAbort);
  await assert.rejects(pool.remesh(small), { ...isAbort, message: 'The pool is closed.' });
  assert.equal(counts.alive, 0);
});

test('closing before a worker is there leaves none', async () => {
  const { pool, counts } = countedPool(2);
  const jobs = [pool.remesh(small), pool.remesh(small), pool.remesh(small), pool.init()];
  await Promise.resolve();
  pool.close();
  for (const job of jobs) await assert.rejects(job, isAbort);
  await platform.compileArrays();
  assert.equal(counts.alive, 0);
});

test('Node and browsers are given the same', async () => {
  const [inNode, inBrowsers] = await Promise.all(
    [import('remesher/pool'), import('../../dist/pool.js')]);
  assert.deepEqual(Object.keys(inNode), Object.keys(inBrowsers));
  const names = Object.getOwnPropertyNames(inBrowsers.Pool.prototype);
  assert.ok(names.includes('remeshFile'));
  assert.deepEqual(names.filter((name) => !(name in inNode.Pool.prototype)), []);
});

test('sizes that cannot be are refused in a sentence', () => {
  for (const size of [0, -1, 1.5, NaN, '2', 1e6]) {
    assert.throws(() => new Pool({ size }), { code: 'INVALID_OPTION', message: /from 1 to 1024/ });
  }
  assert.throws(() => new Pool({ sizes: 2 }), { code: 'UNKNOWN_OPTION' });
  assert.throws(() => new Pool(2), { code: 'INVALID_OPTION' });
  new Pool().close();
});

test('a pool that is idle keeps no program from ending', () => {
  const program = `
    import { Pool } from 'remesher/pool';
    const mesh = { positions: new Float32Array([0,0,0, 1,0,0, 0,1,0, 0,0,1]),
      indices: new Uint32Array([0,2,1, 0,1,3, 1,2,3, 2,0,3]) };
    const { report } = await new Pool({ size: 2 }).remesh(mesh, { vertices: 50 });
    console.log(report.output.vertices);`;
  const printed = execFileSync(process.execPath, ['--input-type=module', '-e', program],
    { cwd: root, encoding: 'utf8', timeout: 60_000 });
  assert.equal(printed.trim(), '50');
});
