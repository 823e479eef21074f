// SPDX-License-Identifier: MIT
// One of any number of workers, on any number of machines that see the same files:
//   REDIS_URL=redis://host:6379 node worker.js
// It takes one file at a time, and remeshes it in a thread, so that it goes on telling Redis that
// it is alive. A job whose worker dies goes to another one once its lock has run out.
import { readFile, rename, writeFile } from 'node:fs/promises';
import { basename } from 'node:path';

import { Worker } from 'bullmq';
import { remeshFile } from 'remesher';

const connection =
  { url: process.env.REDIS_URL ?? 'redis://127.0.0.1:6379', maxRetriesPerRequest: null };
const lockDuration = Number(process.env.LOCK_MILLISECONDS ?? 30_000);

/**
 * The result appears under its name when it is whole, and not before: whoever does a job again
 * writes the same bytes.
 * @param {import('bullmq').Job} job
 */
async function remeshOne({ data: { input, output, options } }) {
  console.log(`begins ${input}`);
  const { bytes, report } = await remeshFile(await readFile(input),
    { ...options, name: basename(input), output: basename(output) });
  const part = `${output}.${process.pid}.part`;
  await writeFile(part, bytes);
  await rename(part, output);
  console.log(`ends ${input}`);
  return { vertices: report.output.vertices, hausdorff: report.fidelity.hausdorff };
}

// A file that cannot be remeshed fails the same way every time, so it is not tried again. A job
// whose worker has died is tried again, three times.
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
