// SPDX-License-Identifier: MIT
// What the whole engine needs of JavaScript.

import { decompress } from '../codecs/decompress.js';
import { gunzipAll } from '../codecs/gunzip.js';
import { packThreemf, unpackThreemf } from '../codecs/threemf.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */

export { default as createInstance } from '../remesher.mjs';

/**
 * A job with its files neither packed nor compressed.
 * @template {{ file: import('../base/messages.js').FileRequest }} FileJob
 * @param {FileJob} job
 * @returns {Promise<FileJob>}
 */
export async function opened(job) {
  return { ...job, file: await decompress(await unpackThreemf(await gunzipAll(job.file))) };
}

/**
 * A result with its files packed as their formats are.
 * @template {{ files?: import('../base/messages.js').NamedBytes[] }} Result
 * @param {Result} result
 * @param {{ packed?: FileRequest, opened?: FileRequest }} read the file that was read
 * @returns {Promise<Result>}
 */
export async function closed(result, read) {
  if (!result.files) return result;
  return { ...result,
    files: await Promise.all(result.files.map((file) => packThreemf(file, read))) };
}
