// SPDX-License-Identifier: MIT
// What a user's project does with the package in Node, use by use: each leaves one line, which must
// be the same under every version.
import { createHash } from 'node:crypto';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { nodeProgram } from '../support/bake_program.js';
import { commonProgram, expected, moduleProgram } from '../support/entries.js';
import { objText, torus } from '../support/shape_files.js';

/**
 * @typedef {object} Use
 * @property {string} name
 * @property {(project: Project) => string} line
 * @property {string} [expected] where it is known beforehand
 */

/**
 * @typedef {object} Project
 * @property {string} folder where the package is installed
 * @property {(words: readonly string[], cwd?: string) => Buffer} node runs it
 */

/** @param {Project} project @param {string} name @param {string} text a program's */
function lineOf({ folder, node }, name, text) {
  writeFileSync(join(folder, name), text);
  return node([name]).toString().trim();
}

const byImport = moduleProgram(
  "const wasmUrl = import.meta.resolve('remesher/remesher.wasm');", 'console.log');

/** In a worker and in the calling thread the same bytes; progress comes, and a signal ends it. */
const workerProgram = `
import { createHash } from 'node:crypto';
import { remeshFile } from 'remesher';
const bytes = new TextEncoder().encode(${JSON.stringify(objText(torus(48, 24)))});
const options = { name: 'torus.obj', output: 'glb', vertices: 700 };
const phases = new Set();
const onProgress = ({ phase }) => phases.add(phase);
const digests = [];
for (const worker of [true, false]) {
  const result = await remeshFile(bytes, { ...options, worker, onProgress });
  digests.push(createHash('sha256').update(result.bytes).digest('hex'));
}
const controller = new AbortController();
const ended = await remeshFile(bytes, { ...options, vertices: 50_000, signal: controller.signal,
  onProgress: () => controller.abort() }).catch((error) => error.name);
console.log(digests[0] === digests[1], phases.size > 3, ended, digests[0]);
`;

/** Each file below a folder by its path and its bytes, as one digest. @param {string} folder */
function digestOf(folder) {
  const hash = createHash('sha256');
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name)).sort();
  for (const file of files) hash.update(file.slice(folder.length)).update(readFileSync(file));
  return `${files.length} files ${hash.digest('hex')}`;
}

/** @param {string} obj */
const coloured = (obj) => obj.replace(/^v .*/gm, (line) => `${line} 0.5 0.2 0.9`);

/** A run, a report, a conversion, painted textures, many files at once, and a pipe. */
function commandLine(/** @type {Project} */ { folder, node }) {
  const place = mkdtempSync(join(folder, 'cli-'));
  mkdirSync(join(place, 'in'));
  mkdirSync(join(place, 'made'));
  const cli = join(folder, 'node_modules/remesher/dist/cli/cli.js');
  const remesher = (/** @type {string} */ words) => node([cli, ...words.split(' ')], place);
  for (const [i, columns] of [16, 24, 32].entries()) {
    writeFileSync(join(place, 'in', `torus${i}.obj`), coloured(objText(torus(columns, 12))));
  }
  remesher('in/torus2.obj -o made/one.glb --vertices 300 --quiet');
  remesher('in/torus2.obj -o made/baked.glb --vertices 200 --textures bake --texture-size 64 '
    + '--quiet');
  remesher('convert in/torus2.obj -o made/other.ply --quiet');
  remesher('in/ -o made/many/ --format stl --vertices 150 --jobs 2 --quiet');
  writeFileSync(join(place, 'made/piped.off'),
    remesher('in/torus0.obj -o - --format off --vertices 120 --quiet'));
  const { input } = JSON.parse(remesher('inspect in/torus2.obj --json').toString());
  return `${input.vertices} ${remesher('--version').toString().trim()} `
    + digestOf(join(place, 'made'));
}

/** @type {readonly Use[]} */
export const uses = [
  { name: 'import', expected, line: (project) => lineOf(project, 'entries.mjs', byImport) },
  { name: 'require()', expected, line: (project) =>
    lineOf(project, 'entries.cjs', commonProgram()) },
  { name: 'worker', line: (project) => lineOf(project, 'worker.mjs', workerProgram) },
  { name: 'baking', line: (project) => lineOf(project, 'bake.mjs', nodeProgram) },
  { name: 'command line', line: commandLine },
];
