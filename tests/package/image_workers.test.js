// SPDX-License-Identifier: MIT
// Images done side by side: what comes out is what one thread makes of them, whoever has helped.
import assert from 'node:assert/strict';
import test from 'node:test';

import { ImageWorkers, serveImages } from '../../bindings/package/textures/image_workers.js';
import { RemeshError } from '../../bindings/package/base/errors.js';
import { compileCodec, spawnForImages } from '../../bindings/package/platform_node.js';

// As in browsers: helpers that are of this thread must not take it from one another.
globalThis.ImageData ??= class {
  constructor(data, width, height) {
    Object.assign(this, { data, width, height });
  }
};

const source = { compile: compileCodec };

/** A picture with a pattern of its own. @param {number} seed */
const picture = (seed, type = 'image/png') => ({
  name: `picture ${seed}`,
  type,
  width: 32,
  height: 16,
  texels: Uint8Array.from({ length: 4 * 32 * 16 },
    (_, i) => (i % 4 === 3 ? 255 : i * seed) % 256),
});

const encoding = (image) => ({ work: /** @type {const} */ ('encode'), image });
const decoding = (bytes) => ({
  work: /** @type {const} */ ('decode'),
  image: { name: `an image of ${bytes.length}`, bytes },
});

/** A helper of this very thread that answers after so many turns; below 0, it is gone by then. */
function portAnswering(turns, served = []) {
  let onAnswer;
  let onFailure;
  const serve = serveImages((answer) => onAnswer(answer), source);
  return {
    post: async (job) => {
      served.push(job);
      for (let turn = Math.abs(turns); turn > 0; turn -= 1) await new Promise(setImmediate);
      if (turns >= 0) await serve(job);
      else onFailure();
    },
    listen: (answer, failure) => { [onAnswer, onFailure] = [answer, failure]; },
    terminate() {},
  };
}

/** @param {any} options @param {any[]} jobs */
async function done(options, jobs, tell = () => {}) {
  const workers = new ImageWorkers({ ...source, ...options });
  try {
    return await workers.run(jobs, tell);
  } finally {
    workers.end();
  }
}

const jobs = ['image/png', 'image/jpeg', 'image/png', 'image/webp', 'image/jpeg']
  .map((type, i) => encoding(picture(i + 3, type)));

test('image workers: the same bytes in the same order, with workers or without, quick or slow',
  async () => {
    const alone = await done({}, jobs);
    assert.equal(alone.length, jobs.length);
    const back = await done({ spawn: spawnForImages, helpers: 2 }, alone.map(decoding));
    back.forEach(({ width, height }) => assert.deepEqual([width, height], [32, 16]));
    assert.deepEqual(back[0].texels, jobs[0].image.texels); // PNG loses nothing
    for (const turns of [0, 50]) {
      const served = [];
      const spawn = () => portAnswering(turns, served);
      assert.deepEqual(await done({ spawn, helpers: 3 }, jobs), alone);
      assert.ok(served.length >= 3, 'helpers help');
    }
    assert.deepEqual(await done({ spawn: spawnForImages, helpers: 2 }, jobs), alone);
  });

test('image workers: what a helper leaves undone is done by others', async () => {
  const spawn = () => portAnswering(-1);
  assert.deepEqual(await done({ spawn, helpers: 2 }, jobs), await done({}, jobs));
});

test('image workers: the first image that is broken is reported', async () => {
  const [good] = await done({}, [encoding(picture(5))]);
  const broken = [good, good.subarray(0, 60), good, good.subarray(0, 50), good].map(decoding);
  for (const options of [{}, { spawn: () => portAnswering(0), helpers: 4 },
    { spawn: spawnForImages, helpers: 2 }]) {
    await assert.rejects(done(options, broken), (/** @type {RemeshError} */ error) =>
      error instanceof RemeshError && error.code === 'PARSE_ERROR'
        && error.message.startsWith('an image of 60 '));
  }
});

test('image workers: it is the first even where a helper has left it undone', async () => {
  const [good] = await done({}, [encoding(picture(5))]);
  const jobsOfTwo = [good, good.subarray(0, 60), good.subarray(0, 50)].map(decoding);
  await assert.rejects(done({ spawn: () => portAnswering(-20_000), helpers: 1 }, jobsOfTwo),
    { message: 'an image of 60 cannot be decoded.' });
});

test('image workers: a listener to progress may end the work', async () => {
  const reported = [];
  await assert.rejects(done({}, jobs, (count) => {
    reported.push(count);
    if (count === 2) throw new RemeshError('CANCELLED', 'Enough.');
  }), { code: 'CANCELLED' });
  assert.deepEqual(reported, [0, 1, 2]);
});
