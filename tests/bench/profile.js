// SPDX-License-Identifier: MIT
// Profiles a remesh by function, in the WebAssembly build itself. The module is linked again for
// that, with the names of its functions, in a separate folder.
//   npm run profile -- MODEL VERTICES [--runs N] [--top N] [--quality draft]
// MODEL is an OBJ or OFF file, or a model from an npm package, as in limits.json. A function's time
// excludes the functions that it calls, and includes functions inlined into it. The profile is left
// beside the build, for a browser's developer tools.
import { writeFileSync } from 'node:fs';
import { Session } from 'node:inspector/promises';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';

import { loadModel } from './models.js';
import { markdownTable } from './table.js';

const folder = fileURLToPath(new URL('../../build/profile', import.meta.url));

/** Milliseconds by function, largest first. */
function ownTimes({ nodes, samples, timeDeltas }) {
  const names = new Map(nodes.map(({ id, callFrame }) =>
    [id, callFrame.functionName || '(other)']));
  const times = new Map();
  samples.forEach((id, k) => {
    const name = names.get(id);
    times.set(name, (times.get(name) ?? 0) + timeDeltas[k] / 1000);
  });
  return [...times].sort((a, b) => b[1] - a[1]);
}

async function profileOf(work) {
  const session = new Session();
  session.connect();
  await session.post('Profiler.enable');
  await session.post('Profiler.setSamplingInterval', { interval: 200 });
  await session.post('Profiler.start');
  await work();
  const { profile } = await session.post('Profiler.stop');
  session.disconnect();
  return profile;
}

const { values, positionals: [model, vertices] } = parseArgs({
  allowPositionals: true,
  options: {
    runs: { type: 'string', default: '5' },
    top: { type: 'string', default: '40' },
    quality: { type: 'string', default: 'best' },
  },
});
if (!model || !vertices) throw new Error('Which model, and how many vertices?');

const { remesh } = await import(pathToFileURL(join(folder, 'package/node.js')).href);
const isPackaged = model.startsWith('npm:');
const mesh = loadModel(isPackaged ? model : basename(model), dirname(model));
const options = { vertices: Number(vertices), quality: values.quality, worker: false };
let { report } = await remesh(mesh, options); // a warm-up for V8's compilers
const runs = Number(values.runs);
const profile = await profileOf(async () => {
  for (let k = 0; k < runs; k += 1) ({ report } = await remesh(mesh, options));
});

const path = join(folder, 'remesh.cpuprofile');
writeFileSync(path, JSON.stringify(profile));
const times = ownTimes(profile);
const total = times.reduce((sum, [, time]) => sum + time, 0);
const rows = (pairs, whole) => pairs.map(([name, time]) =>
  [name, time.toFixed(1), `${((100 * time) / whole).toFixed(1)} %`]);
const phases = report.phases.map(({ name, milliseconds }) => [name, milliseconds]);
console.log(markdownTable(['phase', 'ms', 'share'],
  rows(phases, phases.reduce((sum, [, time]) => sum + time, 0))));
console.log(`\n${markdownTable(['function', 'ms', 'share'],
  rows(times.slice(0, Number(values.top)).map(([name, time]) => [name, time / runs]),
    total / runs))}`);
console.log(`\nThe whole profile: ${path}`);
