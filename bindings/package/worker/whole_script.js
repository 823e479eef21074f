// SPDX-License-Identifier: MIT
// The JavaScript that the whole engine calls.

import { cardOf } from '../base/card.js';
import { decompress } from '../codecs/decompress.js';
import { inMetres } from '../codecs/gltf_metres.js';
import { gunzipAll } from '../codecs/gunzip.js';
import { packThreemf, unpackThreemf } from '../codecs/threemf.js';
import { coverageOf } from '../textures/coverage.js';

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
 * The facts about the files when they are written: the file that was given, the same neither
 * packed nor compressed, the one of them whose lengths the result has, and what was asked of the
 * one that is written.
 * @typedef {{ isCarded: boolean, packed?: FileRequest, opened?: FileRequest, source?: FileRequest,
 *   compress?: 'meshopt' | 'draco', units?: unknown }} Closing
 */

/** Files packed as their formats are, and compressed if that was asked for.
 * @param {any} result @param {Closing} closing */
async function packedBy(result, closing) {
  const files = await Promise.all(inMetres(result.files, closing.source, closing.units)
    .map((file) => packThreemf(file, closing)));
  if (!closing.compress) return { ...result, files };
  const { compressed } = await import('../codecs/compress.js');
  const { files: smaller, compression } = await compressed(files, closing.compress);
  return result.report
    ? { ...result, files: smaller, report: { ...result.report, compression } }
    : { ...result, files: smaller, compression };
}

const lengthOf = (/** @type {readonly { bytes: Uint8Array }[]} */ files) =>
  files.reduce((sum, { bytes }) => sum + bytes.length, 0);

/** @param {FileRequest} file */
const sizeOf = ({ bytes, handle, resources }) =>
  (handle?.size ?? bytes.length) + lengthOf(resources);

/** What new textures use of their square; undefined if none were painted. @param {any} result */
function coverageIn({ report, files }) {
  const isPainted = report.phases.some((/** @type {any} */ { name }) => name === 'paint')
    && /\.gl(b|tf)$/i.test(files[0].name);
  return isPainted ? coverageOf(files) : undefined;
}

/**
 * A result with its files as they are written, and with a card in its report if `isCarded`.
 * @param {any} result
 * @param {Closing} closing
 * @returns {Promise<any>}
 */
export async function closed(result, closing) {
  if (!result.files) return result;
  if (!closing.isCarded || !closing.packed) return packedBy(result, closing);
  const coverage = coverageIn(result);
  const made = await packedBy(result, closing);
  const sizes = { before: sizeOf(closing.packed), after: lengthOf(made.files) };
  return { ...made, report: { ...made.report, card: cardOf(made.report, { ...sizes, coverage }) } };
}
