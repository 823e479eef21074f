// SPDX-License-Identifier: MIT
// One of any number of workers, on any number of machines that see the same files:
//   REDIS_URL=redis://host:6379 node worker.js
// It takes one file at a time, and remeshes it in a thread, so that it goes on telling Redis that
// it is alive. A job whose worker dies goes to another one once its lock has run out; a job that
// takes longer than it may is ended.
import { createHash } from 'node:crypto';
import { createReadStream } from 'node:fs';
import { readFile, rename, rm, writeFile } from 'node:fs/promises';
import { basename } from 'node:path';

import { Worker } from 'bullmq';
import { remeshFile } from 'remesher';

import { joined } from './join.js';

const connection =
  { url: process.env.REDIS_URL ?? 'redis://127.0.0.1:6379', maxRetriesPerRequest: null };
const lockDuration = Number(process.env.LOCK_MILLISECONDS ?? 30_000);

/**
 * The result appears under its name when it is whole, and not before: whoever does a job again
 * writes the same bytes.
 * @param {string} output @param {Uint8Array} bytes
 */
async function writeWhole(output, bytes) {
  const part = `${output}.${process.pid}.part`;
  try {
    await writeFile(part, bytes);
    await rename(part, output);
  } finally {
    await rm(part, { force: true });
  }
}

/**
 * The file's content; of a scan whose slab is wanted as a stream, which may be of any length.
 * @param {{ input: string, pieces?: string[], options: { slab?: number } }} data
 */
async function contentOf({ input, pieces, options: { slab } }) {
  if (pieces) return joined(await Promise.all(pieces.map((piece) => readFile(piece))));
  return slab ? createReadStream(input) : readFile(input);
}

/** @param {import('bullmq').Job} job */
async function remeshOne({ data }) {
  const { input, output, options, seconds } = data;
  console.log(`begins ${input}`);
  const signal = AbortSignal.timeout(1000 * seconds);
  const { bytes, report } = await remeshFile(await contentOf(data),
    { ...options, name: basename(input), output: basename(output), signal }).catch((error) => {
    throw signal.aborted ? new Error(`it takes longer than ${seconds} s (JOB_SECONDS)`) : error;
  });
  await writeWhole(output, bytes);
  console.log(`ends ${input}`);
  return { vertices: report.output.vertices, hausdorff: report.fidelity.hausdorff,
    digest: createHash('sha256').update(bytes).digest('hex') };
}

// A file that cannot be remeshed fails the same way every time, so it is not tried again until it
// has changed. A job whose worker has died is tried again, three times.
const worker = new Worker('remesh', remeshOne,
  { connection, concurrency: 1, lockDuration, stalledInterval: lockDuration, maxStalledCount: 3 });
worker.on('failed', (job, error) => console.error(`fails ${job?.data.input}: ${error.message}`));

// What runs is finished first.
for (const signal of ['SIGINT', 'SIGTERM']) {
  process.once(signal, async () => {
    await worker.close();
    process.exit();
  });
}
