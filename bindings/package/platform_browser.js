// SPDX-License-Identifier: MIT
// What differs in browsers: where the small engine is and how a worker is started. Only the entries
// that read files know the whole engine. The `new URL(…, import.meta.url)` is written out so that
// bundlers see it.

import { Client } from './api/client.js';
import { compileUrl } from './api/wasm_source.js';
import { plainWorker } from './plain_worker.js';
import { portOf } from './worker/browser_port.js';

/** @returns {Promise<WebAssembly.Module>} */
export function compileArrays() {
  return compileUrl(new URL('./remesher_arrays.wasm', import.meta.url));
}

export { compileUrl };

/** @typedef {import('./api/client.js').WorkerPort} WorkerPort */

/**
 * @param {import('./api/client.js').Codecs} [codecs]
 * @returns {WorkerPort | undefined} undefined: there are no workers here
 */
export function spawn(codecs) {
  if (typeof Worker === 'undefined') return undefined;
  return portOf((codecs?.worker ?? plainWorker)());
}

export const cores = () => globalThis.navigator?.hardwareConcurrency || 1;

/** Runs the jobs of all the package's functions, whichever entry they come from. */
export const client = new Client({ compileArrays, compileUrl, spawn, cores });
