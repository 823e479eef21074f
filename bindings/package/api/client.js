// SPDX-License-Identifier: MIT
// Runs jobs: in one worker, kept warm, one job at a time in the order of asking; or in the calling
// thread if there are no workers or none is wanted. Aborting a running job terminates its worker,
// which frees all it held; the next job starts another worker from the compiled module. Jobs on
// arrays use the small engine until the whole one is there and takes its place. Every promise
// settles.

import { RemeshError, abortError, errorFrom } from '../base/errors.js';
import { inJavaScript } from '../base/options.js';
import { Modules } from './modules.js';

/** @import { EngineName, FromWorker, Job, ProgressEvent, ToWorker } from '../base/messages.js' */

/**
 * A worker, the same in browsers and Node.
 * @typedef {object} WorkerPort
 * @property {(message: ToWorker, transfer: ArrayBuffer[]) => void} post
 * @property {(onMessage: (message: FromWorker) => void, onFailure: (why: string) => void) => void}
 *   listen
 * @property {() => void} terminate
 * @property {(busy: boolean) => void} keepAlive whether the process must wait for it
 */

/**
 * Image codecs, for workers and runs that do not find them by themselves. The members are the
 * package's own affair.
 * @typedef {object} Codecs
 * @property {() => Worker} worker Starts a worker in browsers that has them.
 * @property {(name: string) => Promise<any[]>} load For runs in the calling thread.
 */

/**
 * @typedef {object} Platform
 * @property {() => Promise<WebAssembly.Module>} compileArrays the small engine
 * @property {(url: string | URL) => Promise<WebAssembly.Module>} compileUrl
 * @property {(codecs?: Codecs) => WorkerPort | undefined} spawn
 * @property {() => number} cores how many workers can be busy at once
 * @property {(path: string) => Promise<WebAssembly.Module>} [compileCodec] a file of another
 *   package; without it, its own code finds it
 * @property {import('../base/open_file.js').BlocksOf} [blocksOf] where files can be read in blocks
 * @property {(text: string) => string} [words] how the caller knows the options that the core's
 *   sentences name by flags: as JavaScript does, if not given
 */

/**
 * @typedef {object} RunOptions
 * @property {AbortSignal} [signal] Ends the run at once, with an `AbortError`.
 * @property {(event: ProgressEvent) => void} [onProgress] Called with the progress of the run.
 * @property {boolean} [worker] `false`: run in the calling thread, not in a worker.
 */

/**
 * @typedef {object} Task
 * @property {Job} job
 * @property {ArrayBuffer[]} transfer the buffers the job owns
 * @property {AbortSignal | undefined} signal
 * @property {((event: ProgressEvent) => void) | undefined} onProgress
 * @property {(result: any) => void} resolve
 * @property {(error: unknown) => void} reject
 */

/** @param {RunOptions} options */
export function checkRun({ signal, onProgress, worker }) {
  /** @param {string} what @returns {never} */
  const refuse = (what) => {
    throw new RemeshError('INVALID_OPTION', what);
  };
  if (typeof (signal ?? new EventTarget()).addEventListener !== 'function') {
    refuse('signal must be an AbortSignal.');
  }
  if (typeof (onProgress ?? refuse) !== 'function') refuse('onProgress must be a function.');
  if (worker !== undefined && typeof worker !== 'boolean') refuse('worker must be true or false.');
}

/** @typedef {{ warnings?: { message: string }[], lods?: Warned[] }} Warned */

/**
 * Puts the options in warnings into the caller's words.
 * @param {Warned} warned @param {(text: string) => string} words
 */
function settleWords({ warnings = [], lods = [] }, words) {
  for (const warning of warnings) warning.message = words(warning.message);
  for (const lod of lods) settleWords(lod, words);
}

// Workers that a worker may have for images: of a material's five maps it does one itself.
const mostHelpers = 4;

export class Client {
  #platform;
  /** @type {import('../worker/engine.js').Engine | undefined} in the calling thread */
  #engine;
  /** @type {WorkerPort | undefined} */
  #worker;
  /** @type {EngineName | undefined} which engine the worker has */
  #inWorker;
  /** @type {Task[]} the first is running, if #isRunning */
  #tasks = [];
  #isRunning = false;
  #isClosed = false;
  /** @type {Codecs | undefined} */
  #codecs;

  /** @param {Platform} platform @param {Modules} [modules] of a pool */
  constructor(platform, modules = new Modules(platform.compileArrays)) {
    this.#platform = platform;
    this.modules = modules;
  }

  /** For workers and engines that start from now on. @param {Codecs} codecs */
  bring(codecs) {
    this.#codecs = codecs;
  }

  /**
   * @param {Job} job
   * @param {ArrayBuffer[]} transfer
   * @param {RunOptions} options
   * @returns {Promise<any>}
   */
  async run(job, transfer, options) {
    checkRun(options);
    const { words = inJavaScript } = this.#platform;
    try {
      const result = await this.#run(job, transfer, options);
      settleWords(result.report ?? result, words);
      return result;
    } catch (error) {
      if (!(error instanceof RemeshError)) throw error;
      const [message, hint] = [error.message, error.hint].map(words);
      if (message === error.message && hint === error.hint) throw error;
      throw new RemeshError(error.code, message, hint, { cause: error });
    }
  }

  /**
   * @param {Job} job
   * @param {ArrayBuffer[]} transfer
   * @param {RunOptions} options
   * @returns {Promise<any>}
   */
  async #run(job, transfer, options) {
    const { signal, onProgress, worker = true } = options;
    if (signal?.aborted) throw abortError();
    if (!worker) return this.#runHere(job, { signal, onProgress });
    return new Promise((resolve, reject) => {
      /** @type {Task} */
      const task = { job, transfer, signal, onProgress, resolve, reject };
      const abort = () => this.#abort(task);
      signal?.addEventListener('abort', abort, { once: true });
      task.resolve = (result) => {
        signal?.removeEventListener('abort', abort);
        resolve(result);
      };
      task.reject = (error) => {
        signal?.removeEventListener('abort', abort);
        reject(error);
      };
      this.#tasks.push(task);
      void this.#startNext();
    });
  }

  /**
   * The worker, if there can be one, with an engine for jobs that need this one. A new engine takes
   * the place of the one that the worker had.
   * @param {EngineName} needed
   * @returns {Promise<WorkerPort | undefined>}
   */
  async warmUp(needed) {
    const { engine, module } = await this.modules.load(needed);
    if (this.#isClosed) throw abortError();
    const worker = this.#worker ?? this.#spawn();
    if (!worker || this.#inWorker === engine) return worker;
    this.#inWorker = engine;
    const helpers = Math.min(mostHelpers, this.#platform.cores() - 1);
    worker.post({ type: 'start', engine, module, helpers }, []);
    return worker;
  }

  #spawn() {
    const worker = this.#platform.spawn(this.#codecs);
    if (!worker) return undefined;
    this.#worker = worker;
    this.#inWorker = undefined;
    worker.listen(
      (message) => this.#receive(worker, message),
      (why) => this.#fail(worker, why));
    worker.keepAlive(false);
    return worker;
  }

  async #startNext() {
    const [task] = this.#tasks;
    if (this.#isRunning || !task) return;
    this.#isRunning = true;
    try {
      const worker = await this.warmUp(this.modules.engineFor(task.job));
      if (this.#tasks[0] !== task) return; // aborted meanwhile
      if (!worker) {
        const result = await this.#runHere(task.job, task);
        this.#finish(task).resolve(result);
        return;
      }
      worker.keepAlive(true);
      worker.post({ type: 'job', job: task.job, progress: Boolean(task.onProgress) },
        task.transfer);
    } catch (error) {
      if (this.#tasks[0] === task) this.#finish(task).reject(error);
    }
  }

  /** Ends the worker and, with an `AbortError`, all jobs that run or wait. */
  close() {
    this.#isClosed = true;
    for (const task of [...this.#tasks].reverse()) this.#abort(task);
    this.#worker?.terminate();
    this.#worker = undefined;
  }

  /** Takes the running task off the queue and lets the next one start. @param {Task} task */
  #finish(task) {
    this.#tasks.shift();
    this.#isRunning = false;
    this.#worker?.keepAlive(false);
    void this.#startNext();
    return task;
  }

  /** @param {Task} task */
  #abort(task) {
    if (this.#tasks[0] === task && this.#isRunning) {
      this.#worker?.terminate();
      this.#worker = undefined;
      this.#finish(task);
    } else {
      this.#tasks = this.#tasks.filter((other) => other !== task);
    }
    task.reject(abortError());
  }

  /** @param {WorkerPort} worker @param {FromWorker} message */
  #receive(worker, message) {
    if (worker !== this.#worker || !this.#isRunning) return;
    const [task] = this.#tasks;
    if (message.type === 'progress') {
      this.#report(task, message.event);
    } else if (message.type === 'done') {
      this.#finish(task).resolve(message.result);
    } else {
      this.#finish(task).reject(errorFrom(message.failure));
    }
  }

  /** A listener that throws ends its run. @param {Task} task @param {ProgressEvent} event */
  #report(task, event) {
    try {
      task.onProgress?.(event);
    } catch (error) {
      task.reject(error);
      this.#abort(task);
    }
  }

  /** @param {WorkerPort} worker @param {string} why */
  #fail(worker, why) {
    if (worker !== this.#worker) return;
    worker.terminate();
    this.#worker = undefined;
    if (!this.#isRunning) return;
    this.#finish(this.#tasks[0]).reject(new RemeshError('INTERNAL',
      `The worker failed: ${why || 'its script cannot be loaded'}.`,
      'Check that worker.js is served beside the script, or pass worker: false.'));
  }

  /** The engine for runs in the calling thread. @param {EngineName} needed */
  async #engineHere(needed) {
    const { Engine } = await import('../worker/engine.js');
    const loaded = await this.modules.load(needed);
    if (this.#engine?.name !== loaded.engine) {
      this.#engine = new Engine(loaded,
        { load: this.#codecs?.load, compile: this.#platform.compileCodec,
          blocksOf: this.#platform.blocksOf });
    }
    return this.#engine;
  }

  /**
   * @param {Job} job
   * @param {{ signal?: AbortSignal, onProgress?: (event: ProgressEvent) => void }} options
   */
  async #runHere(job, { signal, onProgress }) {
    const engine = await this.#engineHere(this.modules.engineFor(job));
    if (signal?.aborted) throw abortError();
    /** @type {unknown} */
    let thrown;
    /** @param {ProgressEvent} event */
    const listen = (event) => {
      try {
        onProgress?.(event);
      } catch (error) {
        thrown = error;
      }
      return thrown === undefined && !signal?.aborted;
    };
    try {
      return await engine.run(job, onProgress || signal ? listen : undefined);
    } catch (error) {
      if (thrown !== undefined) throw thrown;
      throw signal?.aborted ? abortError() : error;
    }
  }
}
