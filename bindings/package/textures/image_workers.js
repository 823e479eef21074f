// SPDX-License-Identifier: MIT
// Decodes or encodes images side by side: in this thread and, where it can start workers, in a few
// that do nothing else. Whoever is free takes the next image. The results come in the order of the
// jobs and are the same whoever has done them.

import { errorFrom, failureFrom } from '../base/errors.js';
import { ImageCodecs } from './image_codecs.js';

/** @import { ImageAnswer, ImageJob, ImagePort } from '../base/messages.js' */
/** @import { CodecSource } from './image_codecs.js' */

/** A worker is no longer there: others do its job. */
class Gone extends Error {}

/** Copies a job for a worker: it may have to be done again.
 * @param {ImageJob} job @returns {{ job: ImageJob, transfer: ArrayBuffer[] }} */
function copied({ work, image }) {
  const key = work === 'decode' ? 'bytes' : 'texels';
  const values = image[key].slice();
  return { job: { work, image: { ...image, [key]: values } }, transfer: [values.buffer] };
}

/** One job at a time. */
class Helper {
  #port;
  /** @type {{ resolve: (result: any) => void, reject: (error: unknown) => void } | undefined} */
  #waiting;
  #isGone = false;

  /** @param {ImagePort} port */
  constructor(port) {
    this.#port = port;
    port.listen((answer) => this.#settle(answer), () => this.end());
  }

  /** @param {ImageJob} whole @returns {Promise<any>} rejects with Gone where somebody else must */
  do(whole) {
    return new Promise((resolve, reject) => {
      if (this.#isGone) throw new Gone();
      this.#waiting = { resolve, reject };
      const { job, transfer } = copied(whole);
      this.#port.post(job, transfer);
    });
  }

  /** @param {ImageAnswer} answer */
  #settle(answer) {
    if ('result' in answer) {
      this.#waiting?.resolve(answer.result);
      return;
    }
    this.#waiting?.reject(errorFrom(answer.failure));
  }

  end() {
    this.#isGone = true;
    this.#port.terminate();
    this.#waiting?.reject(new Gone());
  }
}

export class ImageWorkers {
  #codecs;
  #spawn;
  #most;
  /** @type {Helper[]} */
  #helpers = [];

  /** @param {CodecSource} source */
  constructor(source) {
    this.#codecs = new ImageCodecs(source);
    this.#spawn = source.spawn;
    this.#most = source.helpers ?? 0;
  }

  /**
   * @param {ImageJob[]} jobs
   * @param {(done: number) => void} tell that so many are done; what it throws ends the rest
   * @param {boolean} [isAlone] one after the other, in this thread
   * @returns {Promise<any[]>} Rejects as the first job that fails would by itself.
   */
  async run(jobs, tell, isAlone = false) {
    /** @type {any[]} */
    const results = [];
    const waiting = [...jobs.keys()];
    /** @type {{ index: number, error?: unknown }} the first of the jobs that have failed */
    let failed = { index: jobs.length };
    let done = 0;
    tell(done);
    /** @param {(job: ImageJob) => Promise<any>} perform */
    const work = async (perform) => {
      while (waiting[0] < failed.index) {
        const index = /** @type {number} */ (waiting.shift());
        try {
          results[index] = await perform(jobs[index]);
        } catch (error) {
          if (error instanceof Gone) waiting.push(index);
          else if (index < failed.index) failed = { index, error };
          waiting.sort((one, other) => one - other);
          return;
        }
        done += 1;
        tell(done);
      }
    };
    const own = (/** @type {ImageJob} */ job) => this.#codecs[job.work](job.image);
    const helpers = isAlone ? [] : this.#helpersFor(jobs.length - 1);
    await Promise.all([own, ...helpers.map((helper) => helper.do.bind(helper))].map(work));
    await work(own);
    if (failed.index < jobs.length) throw failed.error;
    return results;
  }

  /** The present workers, and as many more as can be of use. @param {number} wanted */
  #helpersFor(wanted) {
    while (this.#helpers.length < Math.min(wanted, this.#most)) {
      const port = this.#spawn?.();
      if (!port) break;
      this.#helpers.push(new Helper(port));
    }
    return this.#helpers;
  }

  /** Ends the workers. */
  end() {
    for (const helper of this.#helpers.splice(0)) helper.end();
  }
}

/**
 * The side of the worker.
 * @param {(answer: ImageAnswer, transfer: ArrayBuffer[]) => void} post
 * @param {CodecSource} source
 * @returns {(job: ImageJob) => Promise<void>} to be called with every message
 */
export function serveImages(post, source) {
  const codecs = new ImageCodecs(source);
  return async ({ work, image }) => {
    try {
      const result = await codecs[work](image);
      const owner = result instanceof Uint8Array ? result : result.texels;
      post({ result }, [/** @type {ArrayBuffer} */ (owner.buffer)]);
    } catch (error) {
      post({ failure: failureFrom(error) }, []);
    }
  };
}
