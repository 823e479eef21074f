// SPDX-License-Identifier: MIT
// The file that the user names, wherever it is. A pipe will do; a device that never ends will not.

import { open, stat } from 'node:fs/promises';

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { codeOf, kindOf, reason } from './reasons.js';

// Bytes: more than a run can use of WebAssembly's memory.
const largest = 2 ** 31 - 1;

/** @param {string} path @param {string} why @param {string} [hint] */
function unreadable(path, why, hint = 'Check the name.') {
  return new RemeshError('INPUT_UNREADABLE', `${legible(path)} cannot be read: ${why}.`, hint);
}

/**
 * What comes through a pipe, to its end.
 * @param {import('node:fs/promises').FileHandle} handle
 * @param {string} path
 */
async function drain(handle, path) {
  const chunks = [];
  let length = 0;
  for await (const chunk of handle.createReadStream({ autoClose: false, highWaterMark: 2 ** 20 })) {
    length += chunk.length;
    if (length > largest) throw tooLarge(path);
    chunks.push(chunk);
  }
  return Buffer.concat(chunks, length);
}

/** @param {string} path */
function tooLarge(path) {
  return unreadable(path, `it has more than ${largest} bytes (2 GiB)`, 'Give the model in parts.');
}

/** @param {string} path @returns {Promise<Uint8Array>} */
export async function readInput(path) {
  try {
    const stats = await stat(path);
    if (!(stats.isFile() || stats.isFIFO())) {
      throw unreadable(path, `it is ${kindOf(stats)}`, stats.isDirectory()
        ? 'For all models in it, let the output end in /.' : undefined);
    }
    if (stats.size > largest) throw tooLarge(path);
    const handle = await open(path);
    try {
      return stats.isFile() ? await handle.readFile() : await drain(handle, path);
    } finally {
      await handle.close();
    }
  } catch (error) {
    throw error instanceof RemeshError ? error : unreadable(path, reason(error),
      codeOf(error) === 'EACCES' ? '' : undefined);
  }
}
