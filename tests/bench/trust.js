// SPDX-License-Identifier: MIT
// Files under the laws of trust: each is repaired, remeshed, made of quads and baked, and its
// written bytes are read without the engine. A finding is what the report does not say.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, dirname, extname, join } from 'node:path';

import { inspect, remeshFile, repairFile } from 'remesher';

import { figuresOf } from '../support/independent/figures.js';
import { readFile } from '../support/independent/read.js';
import { lawsOfHarm } from '../support/trust/harm.js';
import { lawsOfWriting } from '../support/trust/said.js';
import { watch } from '../support/watch.js';

const formats = new Set(['.obj', '.stl', '.ply', '.off', '.glb', '.gltf']);

/** Larger files are left out: they say nothing that smaller ones do not, and take minutes. */
const mostBytes = 6e6;

/** Vertices asked for, of any file, so that a run takes seconds. */
const [fewest, most] = [20, 600];

/** @param {string} folder @returns {string[]} the models in it and below, in order */
function modelsUnder(folder) {
  return readdirSync(folder, { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile() && formats.has(extname(entry.name).toLowerCase()))
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name)).sort();
}

/** Other files that a glTF names. @param {string} path @param {Uint8Array} bytes */
function resourcesOf(path, bytes) {
  if (!/\.gltf$/i.test(path)) return {};
  const resources = {};
  for (const [, uri] of Buffer.from(bytes).toString().matchAll(/"uri"\s*:\s*"([^"]+)"/g)) {
    if (uri.startsWith('data:')) continue;
    const name = decodeURIComponent(uri);
    try {
      resources[name] = readFileSync(join(dirname(path), name));
    } catch {
      // Without it the engine refuses the file, or passes its texture over.
    }
  }
  return resources;
}

/** The runs of a file: a name, a function of the package, its options, the output's format. */
function runsOf(path, before) {
  const same = extname(path).slice(1).toLowerCase();
  const vertices = Math.max(fewest, Math.min(most, before.vertices));
  const runs = [['repair', repairFile, { repair: 'auto' }, same],
    ['quads', remeshFile, { quads: true, vertices }, same === 'stl' ? 'obj' : same],
    ['plain', remeshFile, { vertices }, same],
    ['repair and remesh', remeshFile, { repair: 'auto', vertices }, 'stl']];
  if (/gl(b|tf)$/.test(same)) {
    runs.push(['bake', remeshFile, { vertices, textures: 'bake', textureSize: 256 }, 'glb']);
  }
  return runs;
}

async function judged(file, [what, run, options, output], before) {
  const watched = watch();
  try {
    const { bytes, name, files, report } = await run(file.bytes, { ...options, name: file.name,
      resources: file.resources, output, signal: watched.signal });
    const resources = Object.fromEntries(files.slice(1).map((other) => [other.name, other.bytes]));
    const written = figuresOf(readFile(bytes, { name, resources }));
    const isRepair = what === 'repair';
    return [...lawsOfWriting(written, report, { name, before }),
      ...lawsOfHarm(before, written, { report, isRepair, options, sameBytes: isRepair
        && Buffer.compare(Buffer.from(bytes), Buffer.from(file.bytes)) === 0 })];
  } catch (error) {
    if (error?.name === 'AbortError') return [`not done after ${watched.limit} s`];
    if (['INTERNAL', undefined].includes(error.code)) return [`${error.code}: ${error.message}`];
    return [];
  } finally {
    watched.stop();
  }
}

/** @param {string} path @returns {Promise<string[]>} findings, a line each */
async function findingsOf(path) {
  const bytes = new Uint8Array(readFileSync(path));
  const file = { name: basename(path), bytes, resources: resourcesOf(path, bytes) };
  let before;
  try {
    await inspect(bytes, { name: file.name, resources: file.resources });
    before = figuresOf(readFile(bytes, file));
  } catch (error) {
    return error.code && error.code !== 'INTERNAL' ? [] : [`${path}: not read: ${error.message}`];
  }
  const found = [];
  for (const run of runsOf(path, before)) {
    const [what, , options, output] = run;
    for (const law of await judged(file, run, before)) {
      found.push(`${path}: ${what} ${JSON.stringify(options)} to ${output}: ${law}`);
      console.log(found.at(-1));
    }
  }
  return found;
}

/** The small files come first. @param {string[]} folders */
export async function runTrust(folders) {
  const sizes = new Map(folders.flatMap(modelsUnder).map((path) => [path, statSync(path).size]));
  const paths = [...sizes.keys()].filter((path) => sizes.get(path) <= mostBytes)
    .sort((a, b) => sizes.get(a) - sizes.get(b));
  const findings = [];
  for (const [i, path] of paths.entries()) {
    process.stderr.write(`${i + 1} of ${paths.length}: ${path}\n`);
    findings.push(...await findingsOf(path));
  }
  return { table: `${paths.length} files, ${findings.length} findings`, broken: findings };
}
