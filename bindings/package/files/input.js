// SPDX-License-Identifier: MIT
// The file that the user names, wherever it is. A pipe will do; a device that never ends will not.
// Nothing waits for ever: a pipe is opened without waiting for a program at its other end.

import { constants } from 'node:fs';
import { lstat, open, stat } from 'node:fs/promises';
import { setTimeout as sleep } from 'node:timers/promises';

import { bytesAsked, bytesLooked, isLeftToCore, isReadInBlocks } from '../base/contents.js';
import { RemeshError } from '../base/errors.js';
import { OpenFile } from '../base/open_file.js';
import { Pieces } from '../base/pieces.js';
import { codeOf, kindOf, reason, unreadable } from './reasons.js';

// Bytes of a file that is read whole: more than a run can use of WebAssembly's memory.
const largest = 2 ** 31 - 1;

// Milliseconds: a shell that redirects into a pipe has opened it long before.
const patience = 2_000;
const step = 20;

/**
 * A piece of what comes through a pipe. Empty: no program writes into it, or none does any longer;
 * undefined: one does, and nothing is there yet.
 * @param {import('node:fs/promises').FileHandle} handle
 */
async function pieceOf(handle) {
  const buffer = Buffer.allocUnsafe(2 ** 16);
  try {
    const { bytesRead } = await handle.read(buffer, 0, buffer.length, null);
    return buffer.subarray(0, bytesRead);
  } catch (error) {
    if (codeOf(error) === 'EAGAIN') return undefined;
    throw error;
  }
}

/**
 * The bytes that come through a pipe, to its end.
 * @param {import('node:fs/promises').FileHandle} handle
 * @param {string} path
 */
async function drain(handle, path) {
  const pieces = new Pieces();
  for (let isJoined = false, waited = 0; ;) {
    const piece = await pieceOf(handle);
    isJoined ||= piece?.length !== 0;
    if (piece?.length) {
      pieces.add(piece);
      if (pieces.size > largest) throw tooLarge(path);
      continue;
    }
    if (piece && isJoined) return pieces.open();
    if (!isJoined && waited >= patience) {
      throw unreadable(path, 'it is a pipe, and no program writes into it',
        'Start that program first.');
    }
    waited += step;
    await sleep(step);
  }
}

/** @param {string} path */
function tooLarge(path) {
  return unreadable(path,
    `it has more than ${largest} bytes (2 GiB), and only OBJ, binary PLY and STL, and GLB `
      + 'without images, are read in blocks',
    'Convert it to binary PLY, or give the model in parts.');
}

/**
 * Opening a device may do something; opening a pipe would wait.
 * @param {import('node:fs').Stats} stats @param {string} path
 */
function requireReadable(stats, path) {
  if (!(stats.isFile() || stats.isFIFO())) {
    throw unreadable(path, `it is ${kindOf(stats)}`, stats.isDirectory()
      ? 'For all models in it, let the output end in /.' : undefined);
  }
}

/** Node shows bytes of a name that are not UTF-8 as U+FFFD. @param {string} path */
const isMisread = (path) => path.includes('\ufffd');

/** @param {string} path @param {unknown} error */
async function failureOf(path, error) {
  if (error instanceof RemeshError) return error;
  const code = codeOf(error);
  const link = code === 'ENOENT' ? await lstat(path).catch(() => undefined) : undefined;
  if (link) return unreadable(path, 'it is a link that leads nowhere', 'Mend the link.');
  if (code === 'ENOENT' && isMisread(path)) {
    return unreadable(path, 'its name is not UTF-8', 'Rename it.');
  }
  return unreadable(path, reason(error), code === 'EACCES' ? '' : undefined);
}

/**
 * The first bytes of a plain file, at most so many: it may grow for ever.
 * @param {import('node:fs/promises').FileHandle} handle
 * @param {number} most
 */
async function beginOf(handle, most) {
  const bytes = new Uint8Array(most);
  let length = 0;
  while (length < most) {
    const { bytesRead } = await handle.read(bytes, length, most - length, length);
    if (bytesRead === 0) return bytes.slice(0, length);
    length += bytesRead;
  }
  return bytes;
}

/**
 * @param {import('node:fs/promises').FileHandle} handle
 * @param {string} path
 * @returns {Promise<OpenFile>}
 */
async function contentOf(handle, path) {
  const stats = await handle.stat(); // it may have been exchanged
  requireReadable(stats, path);
  if (!stats.isFile()) return drain(handle, path);
  const first = await beginOf(handle, Math.min(stats.size, bytesLooked));
  const begin = await beginOf(handle, Math.min(stats.size, bytesAsked(first)));
  if (begin.length === stats.size) return new OpenFile(begin);
  if (stats.size > largest && !isReadInBlocks(begin, stats.size)) throw tooLarge(path);
  return isLeftToCore(begin) ? new OpenFile(begin, { fd: handle.fd, size: stats.size })
    : new OpenFile(await beginOf(handle, stats.size));
}

/** @param {string} path */
async function opened(path) {
  try {
    requireReadable(await stat(path), path);
    const handle = await open(path, constants.O_RDONLY | (constants.O_NONBLOCK ?? 0));
    try {
      return { handle, file: await contentOf(handle, path) };
    } catch (error) {
      await handle.close();
      throw error;
    }
  } catch (error) {
    throw await failureOf(path, error);
  }
}

/**
 * @template Result
 * @param {string} path
 * @param {(file: OpenFile) => Promise<Result>} use the file is open until this has ended
 * @returns {Promise<Result>}
 */
export async function withInput(path, use) {
  const { handle, file } = await opened(path);
  try {
    return await use(file);
  } finally {
    await handle.close();
  }
}
