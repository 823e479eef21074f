// SPDX-License-Identifier: MIT
// Puts every model of a folder into the queue, and waits for the results:
//   REDIS_URL=redis://host:6379 node producer.js models/ results/ 5000 '{ "repair": "auto" }'
// The last word is what else is asked of each, as remeshFile takes it.
// It may be interrupted and started again: a job is known by its result, and is put there once.
import { mkdir, readdir } from 'node:fs/promises';
import { join, parse, resolve } from 'node:path';

import { Queue, QueueEvents } from 'bullmq';

const [models, results, vertices, others = '{}'] = process.argv.slice(2);
const options = { vertices: Number(vertices), ...JSON.parse(others) };
const connection =
  { url: process.env.REDIS_URL ?? 'redis://127.0.0.1:6379', maxRetriesPerRequest: null };
const queue = new Queue('remesh', { connection });
queue.setMaxListeners(0); // a listener for each job that is waited for
const events = new QueueEvents('remesh', { connection });

/** @param {string} file */
function jobOf(file) {
  const output = resolve(results, `${parse(file).name}.glb`);
  return {
    name: file,
    data: { input: resolve(models, file), output, options },
    opts: { jobId: Buffer.from(output).toString('hex') },
  };
}

/** @param {import('bullmq').Job} job @returns {Promise<boolean>} whether it has a result */
async function outcome(job) {
  try {
    const { vertices: count, hausdorff } = await job.waitUntilFinished(events);
    console.log(`${job.name}: ${count} vertices, ${hausdorff.toFixed(3)} % away`);
    return true;
  } catch (error) {
    console.error(`${job.name}: ${/** @type {Error} */ (error).message}`);
    return false;
  }
}

await mkdir(results, { recursive: true });
await events.waitUntilReady();
const files = (await readdir(models)).filter((file) => /\.(glb|gltf|obj|off|ply|stl)$/i.test(file));
const jobs = await queue.addBulk(files.map(jobOf));
const done = await Promise.all(jobs.map(outcome));
console.log(`${done.filter(Boolean).length} of ${files.length} files are in ${join(results, '/')}`);
process.exitCode = done.every(Boolean) ? 0 : 2;

await Promise.all([queue.close(), events.close()]);
