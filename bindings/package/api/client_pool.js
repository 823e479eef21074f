// SPDX-License-Identifier: MIT
// Runs jobs as a client does, but several at once: a client for each worker, all with the same
// compiled modules. Jobs wait in the order of asking for the first free client. Clients of lower
// number are taken first, so that no more workers are started than are needed.

import { Client, checkRun } from './client.js';
import { Modules } from './modules.js';
import { abortError } from '../base/errors.js';

/** @import { EngineName, Job } from '../base/messages.js' */
/** @import { Platform, RunOptions } from './client.js' */

/**
 * @typedef {object} Waiting
 * @property {(client: Client) => void} start
 * @property {() => void} leave
 */

export class ClientPool {
  #clients;
  #free;
  /** @type {Waiting[]} */
  #waiting = [];
  #isClosed = false;

  /** @param {Platform} platform @param {number} size how many workers at most */
  constructor(platform, size) {
    /** @type {Platform} */
    const own = { ...platform, cores: () => Math.floor(platform.cores() / size) }; // each its share
    this.modules = new Modules(platform.compileArrays);
    this.#clients = Array.from({ length: size }, () => new Client(own, this.modules));
    this.#free = new Set(this.#clients);
  }

  /** See Client. @param {import('./client.js').Codecs} codecs */
  bring(codecs) {
    for (const client of this.#clients) client.bring(codecs);
  }

  /** Starts all workers and returns the first. @param {EngineName} needed */
  async warmUp(needed) {
    const [first] = await Promise.all(this.#clients.map((client) => client.warmUp(needed)));
    return first;
  }

  /**
   * @param {Job} job
   * @param {ArrayBuffer[]} transfer
   * @param {RunOptions} options
   * @returns {Promise<any>}
   */
  async run(job, transfer, options) {
    checkRun(options);
    if (this.#isClosed) throw abortError('The pool is closed.');
    if (options.signal?.aborted) throw abortError();
    if (options.worker === false) return this.#clients[0].run(job, transfer, options);
    const client = await this.#nextFree(options.signal);
    try {
      if (this.#isClosed) throw abortError('The pool is closed.');
      return await client.run(job, transfer, options);
    } finally {
      this.#free.add(client);
      this.#startNext();
    }
  }

  /** Ends all workers. Jobs that run or wait reject with an `AbortError`. */
  close() {
    this.#isClosed = true;
    for (const { leave } of this.#waiting.splice(0)) leave();
    for (const client of this.#clients) client.close();
  }

  /** @param {AbortSignal | undefined} signal @returns {Promise<Client>} */
  #nextFree(signal) {
    return new Promise((resolve, reject) => {
      const abort = () => {
        this.#waiting = this.#waiting.filter((other) => other !== waiting);
        waiting.leave();
      };
      const waiting = {
        start: (/** @type {Client} */ client) => {
          signal?.removeEventListener('abort', abort);
          resolve(client);
        },
        leave: () => {
          signal?.removeEventListener('abort', abort);
          reject(abortError(this.#isClosed ? 'The pool is closed.' : undefined));
        },
      };
      signal?.addEventListener('abort', abort, { once: true });
      this.#waiting.push(waiting);
      this.#startNext();
    });
  }

  #startNext() {
    const client = this.#clients.find((one) => this.#free.has(one));
    if (this.#isClosed || !client) return;
    const next = this.#waiting.shift();
    if (!next) return;
    this.#free.delete(client);
    next.start(client);
  }
}
