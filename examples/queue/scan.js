// SPDX-License-Identifier: MIT
// Remeshes one large scan, a binary PLY or STL, as jobs of the same workers: each thins out a slab
// of it, and the last one joins these pieces and remeshes them:
//   REDIS_URL=redis://host:6379 node scan.js scan.ply result.glb 50000 4
// The result is what one run with `slabs: 4` makes, byte for byte.
import { rm } from 'node:fs/promises';
import { resolve } from 'node:path';

import { FlowProducer, QueueEvents } from 'bullmq';

const [scan, result, vertices, count] = process.argv.slice(2);
const options = { vertices: Number(vertices) };
const slabs = Number(count);
const seconds = Number(process.env.JOB_SECONDS ?? 3600);
const connection =
  { url: process.env.REDIS_URL ?? 'redis://127.0.0.1:6379', maxRetriesPerRequest: null };
const producer = new FlowProducer({ connection });
const events = new QueueEvents('remesh', { connection });
const [input, output] = [resolve(scan), resolve(result)];

const children = Array.from({ length: slabs }, (_, i) => ({
  name: `slab ${i + 1} of ${scan}`, queueName: 'remesh', opts: { failParentOnFailure: true },
  data: { input, output: `${output}.slab${i + 1}.ply`, seconds,
    options: { ...options, slabs, slab: i + 1 } },
}));
const pieces = children.map(({ data }) => data.output);

await events.waitUntilReady();
const { job } = await producer.add({ name: scan, queueName: 'remesh', children,
  data: { input, pieces, output, options, seconds } });
try {
  const { vertices: made } = await job.waitUntilFinished(events);
  for (const piece of pieces) await rm(piece);
  console.log(`${scan}: ${made} vertices`);
} catch (error) {
  console.error(`${scan}: ${/** @type {Error} */ (error).message}`);
  process.exitCode = 2;
}
await Promise.all([producer.close(), events.close()]);
