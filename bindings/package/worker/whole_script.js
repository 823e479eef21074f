// SPDX-License-Identifier: MIT
// What the whole engine needs of JavaScript.

import { decompress } from '../codecs/decompress.js';
import { gunzipAll } from '../codecs/gunzip.js';
import { packThreemf, unpackThreemf } from '../codecs/threemf.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */
/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */

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
 * A result with its files packed as their formats are, and compressed if that was asked for.
 * @param {any} result
 * @param {{ packed?: FileRequest, opened?: FileRequest, compress?: 'meshopt' | 'draco',
 *   units?: unknown }} read the file that was read, and what was said of the one that is written
 * @returns {Promise<any>}
 */
export async function closed(result, read) {
  if (!result.files) return result;
  const files = await Promise.all(
    result.files.map((/** @type {NamedBytes} */ file) => packThreemf(file, read)));
  if (!read.compress) return { ...result, files };
  const { compressed } = await import('../codecs/compress.js');
  const { files: smaller, compression } = await compressed(files, read.compress);
  return result.report
    ? { ...result, files: smaller, report: { ...result.report, compression } }
    : { ...result, files: smaller, compression };
}
