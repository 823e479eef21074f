// SPDX-License-Identifier: MIT
// Counts the WebAssembly instances that a program with arrays and files makes, and the instances
// that it still holds at its end: in the calling thread, and in the code that serves a worker. This
// is a separate program because it needs --expose-gc.
import { remesh, remeshFile } from 'remesher';

import { serve } from '../../dist/worker/serve.js';
import { compileArrays, compileWhole } from '../../dist/platform_node.js';
import { octahedron, offText } from './shapes.js';

const { instantiate } = WebAssembly;
/** @type {WeakRef<WebAssembly.Instance>[]} */
let made = [];
WebAssembly.instantiate = async (/** @type {any[]} */ ...given) => {
  const instance = await instantiate.apply(WebAssembly, given);
  made.push(new WeakRef(instance));
  return instance;
};

/** The instances that some work makes, and those left after garbage collection. */
async function countOf(work) {
  made = [];
  await work();
  for (let i = 0; i < 5; i += 1) {
    globalThis.gc?.();
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
  return { made: made.length, held: made.filter((one) => one.deref()).length };
}

const options = { vertices: 30 };
const bytes = new TextEncoder().encode(offText(octahedron()));

async function here() {
  await remesh(octahedron(), { ...options, worker: false });
  await remeshFile(bytes, { ...options, name: 'a.off', output: 'a.obj', worker: false });
  await remesh(octahedron(), { ...options, worker: false });
}

/** @type {ReturnType<typeof serve>} kept alive, as in a worker */
let receive;

/** Sends the messages of a client. */
async function asInWorker() {
  receive = serve(() => {});
  const job = { kind: 'remesh', parts: [{ mesh: octahedron() }], options };
  const file = { name: 'a.off', bytes, resources: [], output: 'a.obj' };
  await receive({ type: 'start', engine: 'arrays', module: await compileArrays(), helpers: 0 });
  await receive({ type: 'job', job, progress: false });
  await receive({ type: 'start', engine: 'whole', module: await compileWhole(), helpers: 0 });
  await receive({ type: 'job', job: { kind: 'remeshFile', file, options }, progress: false });
  await receive({ type: 'job', job, progress: false });
}

console.log(JSON.stringify({ here: await countOf(here), worker: await countOf(asInWorker) }));
