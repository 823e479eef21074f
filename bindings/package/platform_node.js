// SPDX-License-Identifier: MIT
// What differs in Node: where the engines are and how a worker is started.

import { readSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';

import { RemeshError } from './base/errors.js';
import { Client } from './api/client.js';
import { compileBinary, compileUrl as compileFetched, sayWhere } from './api/wasm_source.js';

/** @param {string | URL} url @returns {Promise<Uint8Array<ArrayBuffer> | undefined>} */
async function readLocal(url) {
  try {
    const parsed = new URL(url, import.meta.url);
    return parsed.protocol === 'file:' ? await readFile(parsed) : undefined;
  } catch (cause) {
    throw new RemeshError('INTERNAL', `${url} cannot be read.`,
      sayWhere, { cause });
  }
}

/** @param {string | URL} url @returns {Promise<WebAssembly.Module>} */
export async function compileUrl(url) {
  const bytes = await readLocal(url);
  return bytes ? compileBinary(bytes, String(url)) : compileFetched(url);
}

/** @returns {Promise<WebAssembly.Module>} */
export function compileArrays() {
  return compileUrl(new URL('./remesher_arrays.wasm', import.meta.url));
}

/** @returns {Promise<WebAssembly.Module>} */
export function compileWhole() {
  return compileUrl(new URL('./remesher.wasm', import.meta.url));
}

/**
 * A file of another package, whose own code cannot fetch it here.
 * @param {string} path
 */
export async function compileCodec(path) {
  return WebAssembly.compile(await readFile(createRequire(import.meta.url).resolve(path)));
}

/** @type {import('./base/open_file.js').BlocksOf} */
export function blocksOf({ fd }) {
  if (fd === undefined) return undefined;
  return (at, into) => {
    try {
      for (let filled = 0; filled < into.length;) {
        const count = readSync(fd, into, filled, into.length - filled, at + filled);
        if (count === 0) return false;
        filled += count;
      }
      return true;
    } catch {
      return false;
    }
  };
}

/** @typedef {import('./api/client.js').WorkerPort} WorkerPort */
/** @typedef {import('./base/messages.js').ImagePort} ImagePort */

/** @param {URL} script */
function start(script) {
  // No execArgv: what the program was started with (--input-type, --test) is not the worker's.
  const worker = new Worker(script, { execArgv: [] });
  return {
    post: (/** @type {any} */ message, /** @type {ArrayBuffer[]} */ transfer) =>
      worker.postMessage(message, transfer),
    listen(/** @type {(message: any) => void} */ onMessage,
      /** @type {(why: string) => void} */ onFailure) {
      worker.on('message', onMessage);
      worker.on('error', (error) => onFailure(error.message));
      // An exit may come without an error before it: a job would never settle.
      worker.on('exit', (status) => onFailure(`it ended with status ${status}`));
    },
    terminate: () => void worker.terminate(),
    keepAlive: (/** @type {boolean} */ busy) => (busy ? worker.ref() : worker.unref()),
  };
}

/** @returns {WorkerPort} */
export function spawn() {
  return start(new URL('./worker_node.js', import.meta.url));
}

/** For a worker. @returns {ImagePort} */
export function spawnForImages() {
  return start(new URL('./image_worker_node.js', import.meta.url));
}

export const cores = availableParallelism;

/** Runs the jobs of all the package's functions, whichever entry they come from. */
export const client = new Client({ compileArrays, compileUrl, spawn, cores, compileCodec,
  blocksOf });
