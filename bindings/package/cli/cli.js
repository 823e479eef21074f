#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// The command line: read, remesh, write to the side, rename. Nothing is written before all has
// succeeded. Standard output carries the report or the model alone, standard error the rest.

import { access, mkdir, readFile, rename, rm, writeFile } from 'node:fs/promises';
import { basename, dirname, extname, join } from 'node:path';

import { helpText, parseCommandLine } from './cli_arguments.js';
import { RemeshError } from '../base/errors.js';
import { inspect, remeshFile } from '../node.js';
import { referencesOf } from '../codecs/resources.js';

/** @typedef {import('./cli_arguments.js').CommandLine} CommandLine */
/** @typedef {import('../base/messages.js').MeshReport} MeshReport */
/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */

const ourFault = new Set(['INTERNAL', 'OUT_OF_MEMORY', 'CANCELLED']);

/** Why the system refused, in words. @param {unknown} error */
function reason(error) {
  const code = /** @type {NodeJS.ErrnoException} */ (error).code ?? '';
  const known = new Map([
    ['ENOENT', 'there is no such file or folder'],
    ['EACCES', 'permission is denied'],
    ['EPERM', 'permission is denied'],
    ['EISDIR', 'it is a folder'],
    ['ENOTDIR', 'a part of its path is not a folder'],
    ['EROFS', 'the file system is read-only'],
    ['ENOSPC', 'the disk is full'],
  ]);
  return known.get(code) ?? String(error);
}

/** @param {string} path */
async function readInput(path) {
  try {
    return await readFile(path);
  } catch (error) {
    throw new RemeshError('INPUT_UNREADABLE', `${path} cannot be read: ${reason(error)}.`,
      'Check the name.');
  }
}

/** A reference as it may be spelled on disk. @param {string} reference */
function spellings(reference) {
  try {
    return [reference, decodeURIComponent(reference)];
  } catch {
    return [reference];
  }
}

/**
 * What lies beside the input; what is not there is left out, for the core to say whether it is
 * needed.
 * @param {string} path @param {Uint8Array} bytes
 */
async function readResources(path, bytes) {
  /** @type {Record<string, Uint8Array>} */
  const resources = {};
  for (const reference of referencesOf(path, bytes)) {
    for (const spelling of spellings(reference)) {
      try {
        resources[reference] ??= await readFile(join(dirname(path), spelling));
      } catch {
        continue;
      }
    }
  }
  return resources;
}

/** @param {string} path @param {unknown} error */
function unwritable(path, error) {
  return new RemeshError('OUTPUT_UNWRITABLE', `${path} cannot be written: ${reason(error)}.`,
    'Choose another output.');
}

/** Before the work, which may take long, and not after it. @param {string} output */
async function requireFolder(output) {
  await access(dirname(output)).catch((error) => {
    throw unwritable(output, error);
  });
}

/**
 * All files or none: each is written beside its place, and moved there when all are whole. The
 * file asked for comes first, and is moved last.
 * @param {string} folder
 * @param {NamedBytes[]} files
 */
async function writeAll(folder, files) {
  const moves = files.map(({ name }) => {
    const place = join(folder, name);
    return { place, draft: join(dirname(place), `.${basename(place)}.${process.pid}.part`) };
  });
  try {
    for (const [i, { draft }] of moves.entries()) {
      if (i > 0) await mkdir(dirname(draft), { recursive: true });
      await writeFile(draft, files[i].bytes);
    }
    for (const { place, draft } of moves.reverse()) await rename(draft, place);
  } catch (error) {
    await Promise.all(moves.map(({ draft }) => rm(draft, { force: true })));
    throw unwritable(join(folder, files[0].name), error);
  }
}

/**
 * A reader that stops reading (head, a closed pager) is no failure of ours.
 * @param {Uint8Array} bytes
 * @returns {Promise<void>}
 */
function writeToStandardOutput(bytes) {
  return new Promise((resolve, reject) => {
    process.stdout.write(bytes, (error) =>
      (error && !isClosedPipe(error) ? reject(error) : resolve()));
  });
}

/** @param {Error} error */
function isClosedPipe(error) {
  return /** @type {NodeJS.ErrnoException} */ (error).code === 'EPIPE';
}

/** A bar on a terminal, nothing elsewhere. @param {boolean} quiet */
function progressBar(quiet) {
  if (quiet || !process.stderr.isTTY) return { onProgress: undefined, clear() {} };
  const width = 30;
  return {
    onProgress(/** @type {import('../base/messages.js').ProgressEvent} */ { phase, fraction }) {
      const done = Math.round(fraction * width);
      const bar = '█'.repeat(done).padEnd(width, '░');
      process.stderr.write(`\r\x1b[K${bar} ${Math.round(100 * fraction)} % ${phase}`);
    },
    clear: () => void process.stderr.write('\r\x1b[K'),
  };
}

/** @param {string} title @param {MeshReport} mesh */
function meshInWords(title, mesh) {
  const { minAngle, maxAngle } = mesh;
  const shares = minAngle.histogram.map((percent) => percent.toFixed(1)).join('  ');
  return [
    `${title}: ${mesh.vertices} vertices, ${mesh.triangles} triangles, `
      + `${mesh.components} components`,
    `  boundary edges ${mesh.boundaryEdges}, non-manifold edges ${mesh.nonManifoldEdges}, `
      + `degenerate triangles ${mesh.degenerateTriangles}, `
      + `Euler characteristic ${mesh.eulerCharacteristic}`,
    `  minimum angle: mean ${minAngle.mean.toFixed(1)}°, worst ${minAngle.worst.toFixed(1)}°; `
      + `maximum ${maxAngle.toFixed(1)}°; valence 6: ${mesh.valence6.toFixed(1)} %`,
    `  triangles by minimum angle, %, 0–10 … 50–60°: ${shares}`,
  ].join('\n');
}

/** @param {any} report */
function reportInWords(report) {
  const parts = [meshInWords('input', report.input)];
  if (report.output) parts.push(meshInWords('output', report.output));
  if (report.fidelity) {
    parts.push(`distance to the input: ${report.fidelity.hausdorff.toFixed(4)} % at the farthest `
      + `point found, ${report.fidelity.rms.toFixed(4)} % RMS, of the diagonal`);
  }
  for (const { message } of report.warnings) parts.push(`warning: ${message}`);
  if (report.stopped && report.stopped !== 'target') {
    parts.push(`stopped before the target by: ${report.stopped}`);
  }
  return `${parts.join('\n')}\n`;
}

/** @param {CommandLine} line */
async function runInspection({ input, json }) {
  const bytes = await readInput(input);
  const resources = await readResources(input, bytes);
  const report = await inspect(bytes, { name: basename(input), resources, worker: false });
  process.stdout.write(json ? `${JSON.stringify(report, null, 2)}\n` : reportInWords(report));
}

/** @param {CommandLine} line */
async function runRemesh({ input, output, format, json, quiet, options }) {
  const isPiped = output === '-';
  const name = isPiped ? `${basename(input, extname(input))}.${format}` : basename(output);
  const bytes = await readInput(input);
  if (!isPiped) await requireFolder(output);
  const resources = await readResources(input, bytes);
  const { onProgress, clear } = progressBar(quiet);
  const { files, report } = await remeshFile(bytes,
    { ...options, name: basename(input), output: name, resources, onProgress, worker: false })
    .finally(clear);
  if (isPiped && files.length > 1) {
    throw new RemeshError('INVALID_OPTION',
      `${format} is ${files.length} files here, and - is one.`,
      'Use --format glb, or write to a file.');
  }
  if (isPiped) await writeToStandardOutput(files[0].bytes);
  else await writeAll(dirname(output), files);
  if (json) process.stdout.write(`${JSON.stringify(report, null, 2)}\n`);
  else if (!quiet) process.stderr.write(reportInWords(report));
}

async function showVersion() {
  const manifest = await readFile(new URL('../../package.json', import.meta.url), 'utf8');
  process.stdout.write(`${JSON.parse(manifest).version}\n`);
}

/** @param {string[]} words */
async function main(words) {
  const line = parseCommandLine(words);
  if (line.command === 'help') process.stdout.write(helpText());
  else if (line.command === 'version') await showVersion();
  else if (line.command === 'inspect') await runInspection(line);
  else await runRemesh(line);
}

/** One line: what, where, what to do. @param {unknown} error */
function complain(error) {
  const known = error instanceof RemeshError
    ? error : new RemeshError('INTERNAL', String(error), 'Please report this as a bug.');
  const line = `${known.message} ${known.hint}`.replace(/\s+/g, ' ').trim();
  process.stderr.write(`remesher: ${line} [${known.code}]\n`);
  process.exitCode = ourFault.has(known.code) ? 1 : 2;
}

process.stdout.on('error', (error) => {
  if (!isClosedPipe(error)) throw error;
});

await main(process.argv.slice(2)).catch(complain);
