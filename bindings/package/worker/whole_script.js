// SPDX-License-Identifier: MIT
// What the whole engine needs of JavaScript.

import { decompress } from '../codecs/decompress.js';
import { gunzipAll } from '../codecs/gunzip.js';

export { default as createInstance } from '../remesher.mjs';

/**
 * A job with its files neither packed nor compressed.
 * @template {{ file: import('../base/messages.js').FileRequest }} FileJob
 * @param {FileJob} job
 * @returns {Promise<FileJob>}
 */
export async function opened(job) {
  return { ...job, file: await decompress(await gunzipAll(job.file)) };
}
