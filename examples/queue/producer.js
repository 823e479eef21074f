// SPDX-License-Identifier: MIT
// Puts every model of a folder into the queue, and waits for the results:
//   REDIS_URL=redis://host:6379 node producer.js models/ results/ 5000 '{ "repair": "auto" }'
// The last word is what else is asked of each, as remeshFile takes it. JOB_SECONDS is the time that
// a job may take.
// It may be interrupted and started again. A job is known by the file's contents, its result's
// place and what is asked, and is put there once; if the file or the options change, it is another
// job. What was done is done again only if its result is no longer as it was written.
import { createHash } from 'node:crypto';
import { mkdir, readdir, readFile } from 'node:fs/promises';
import { join, parse, resolve } from 'node:path';

import { Queue, QueueEvents } from 'bullmq';

const [models, results, vertices, others = '{}'] = process.argv.slice(2);
const options = { vertices: Number(vertices), ...JSON.parse(others) };
const seconds = Number(process.env.JOB_SECONDS ?? 3600);
const connection =
  { url: process.env.REDIS_URL ?? 'redis://127.0.0.1:6379', maxRetriesPerRequest: null };
const queue = new Queue('remesh', { connection });
queue.setMaxListeners(0); // a listener for each job that is waited for
const events = new QueueEvents('remesh', { connection });

/** @param {string | Uint8Array} content */
const digestOf = (content) => createHash('sha256').update(content).digest('hex');

/** @param {string} file @param {string[]} files all of them */
function outputOf(file, files) {
  const stem = (/** @type {string} */ name) => parse(name).name.toLowerCase();
  const isAlone = files.filter((other) => stem(other) === stem(file)).length === 1;
  return resolve(results, `${isAlone ? parse(file).name : file}.glb`);
}

/** @param {string} file @param {string[]} files */
async function jobOf(file, files) {
  const input = resolve(models, file);
  const data = { input, output: outputOf(file, files), options, seconds };
  const jobId = digestOf(JSON.stringify([data, digestOf(await readFile(input))]));
  return { name: file, data, opts: { jobId } };
}

/**
 * Forgets a job that was done if its result is gone, or has been replaced since, as by a job with
 * other options.
 * @param {Awaited<ReturnType<typeof jobOf>>} job
 */
async function forgetIfLost({ data: { output }, opts: { jobId } }) {
  const known = await queue.getJob(jobId);
  if (!known || !await known.isCompleted()) return;
  const there = await readFile(output).catch(() => undefined);
  if (there === undefined || digestOf(there) !== known.returnvalue.digest) await known.remove();
}

/** @param {import('bullmq').Job} job @returns {Promise<boolean>} whether it has a result */
async function outcome(job) {
  try {
    const { vertices: count, hausdorff, digest } = await job.waitUntilFinished(events);
    if (digestOf(await readFile(job.data.output)) !== digest) {
      throw new Error('its result is not as it was written');
    }
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
const jobs = [];
for (const file of files) jobs.push(await jobOf(file, files));
await Promise.all(jobs.map(forgetIfLost));
const done = await Promise.all((await queue.addBulk(jobs)).map(outcome));
console.log(`${done.filter(Boolean).length} of ${files.length} files are in ${join(results, '/')}`);
process.exitCode = done.every(Boolean) ? 0 : 2;

await Promise.all([queue.close(), events.close()]);
