// SPDX-License-Identifier: MIT
// Unpacks .gz files by the platform's own decompression, in pieces and up to a limit, so that a
// file that unpacks to a thousand times its size fills no memory.

import { RemeshError } from '../base/errors.js';
import { withoutGz } from '../base/formats.js';
import { legible } from '../base/legible.js';
import { Pieces } from '../base/pieces.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */
/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */

/** Beyond any mesh that WebAssembly's four gigabytes have room for. */
export const largestInflated = 2 ** 30;

/** RFC 1952: two magic bytes, the only method, no reserved flags. @param {Uint8Array} bytes */
export function isGzip(bytes) {
  return bytes.length >= 4 && bytes[0] === 0x1f && bytes[1] === 0x8b && bytes[2] === 8
    && (bytes[3] & 0xe0) === 0;
}

/** @param {NamedBytes} file @param {number} limit @returns {Promise<Pieces>} */
async function inflate({ name, bytes }, limit) {
  const source = new Blob([/** @type {BlobPart} */ (bytes)]).stream();
  const reader = source.pipeThrough(new DecompressionStream('gzip')).getReader();
  const pieces = new Pieces();
  for (let step = await reader.read(); !step.done; step = await reader.read()) {
    pieces.add(step.value);
    if (pieces.size <= limit) continue;
    await reader.cancel().catch(() => {});
    throw new RemeshError('UNSUPPORTED',
      `${legible(name)}: it unpacks to more than ${limit} bytes, which is the limit.`,
      'Unpack it first, and give a smaller model.');
  }
  return pieces;
}

/** @param {NamedBytes} file @param {number} limit @returns {Promise<Pieces>} */
async function unpacked(file, limit) {
  if (typeof DecompressionStream === 'undefined') {
    throw new RemeshError('UNSUPPORTED', `${legible(file.name)}: this browser cannot unpack gzip.`,
      'Unpack the file first.');
  }
  try {
    return await inflate(file, limit);
  } catch (cause) {
    if (cause instanceof RemeshError) throw cause;
    throw new RemeshError('PARSE_ERROR', `${legible(file.name)}: its gzip is damaged or cut short.`,
      'Was it copied completely?', { cause });
  }
}

/**
 * The unpacked file, under the name without .gz; the same object if it is no gzip.
 * @param {NamedBytes} file
 * @param {number} [limit] bytes
 * @returns {Promise<NamedBytes>}
 */
export async function gunzip(file, limit = largestInflated) {
  if (!isGzip(file.bytes)) return file;
  return { name: withoutGz(file.name), bytes: (await unpacked(file, limit)).joined() };
}

/**
 * A file and what it refers to, all unpacked; what is left to the core stays in pieces.
 * @param {FileRequest} file
 * @returns {Promise<FileRequest>}
 */
export async function gunzipAll(file) {
  const resources = [];
  for (const resource of file.resources) resources.push(await gunzip(resource));
  if (!isGzip(file.bytes)) return { ...file, resources };
  const pieces = await unpacked(file, largestInflated);
  return { ...file, name: withoutGz(file.name), ...pieces.open(), resources };
}
