// SPDX-License-Identifier: MIT
// Tells whether this build gives the same bytes as another build, for work that must not change any
// result. Both must have been built (npm run build).
//   node tests/bench/same_bytes.js OTHER_CHECKOUT MODELS_FOLDER [model…]
// Every model is remeshed to half its vertices, by every scheme, into every format. The status is 1
// if anything differs.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

import * as ours from 'remesher';

const schemes = ['best', 'rounds'];
const formats = ['glb', 'gltf', 'obj', 'off'];

/** The files and warnings of a run, as one hash. */
async function outcome({ remeshFile }, bytes, { name, output, scheme }) {
  const result = await remeshFile(bytes, { name, output, scheme, ratio: 0.5, worker: false });
  const hash = createHash('sha256').update(result.bytes);
  for (const file of result.files) hash.update(file.name).update(file.bytes);
  return hash.update(JSON.stringify([result.report.output, result.report.fidelity])).digest('hex');
}

const [other, folder, ...wanted] = process.argv.slice(2);
if (!other || !folder) throw new Error('Which other checkout, and which folder of models?');
const theirs = await import(pathToFileURL(resolve(other, 'dist/node.js')).href);

let different = 0;
const models = readdirSync(folder).filter((name) => /\.(glb|gltf|obj|off)$/.test(name))
  .filter((name) => wanted.length === 0 || wanted.includes(name));
const cases = models.flatMap((name) => schemes.flatMap((scheme) =>
  formats.map((format) => ({ name, scheme, output: `result.${format}` }))));
for (const how of cases) {
  const bytes = readFileSync(join(folder, how.name));
  const [mine, their] = [await outcome(ours, bytes, how), await outcome(theirs, bytes, how)];
  if (mine !== their) different += 1;
  console.log(`${mine === their ? 'same     ' : 'DIFFERENT'} ${Object.values(how).join(' ')}`);
}
console.log(`${different} of ${cases.length} differ`);
if (different > 0) process.exitCode = 1;
