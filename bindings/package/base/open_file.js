// SPDX-License-Identifier: MIT
// A file that the package itself has opened. Nobody else has its bytes, so they need no copy.

/**
 * How the bytes of a file that is read in blocks are reached, in this thread and in its workers: by
 * the number of an open file in Node, by a Blob, or in pieces (pieces.js).
 * @typedef {{ size: number, fd?: number, blob?: Blob, pieces?: Uint8Array<ArrayBuffer>[] }}
 *   FileHandle
 */

/**
 * Fills an array with a file's bytes from a place on; false if they cannot be read.
 * @typedef {(at: number, into: Uint8Array) => boolean} ReadBlock
 */

/**
 * The way to the blocks of a file; undefined where the platform, or this thread, has none.
 * @typedef {(handle: FileHandle) => ReadBlock | undefined} BlocksOf
 */

export class OpenFile {
  /**
   * @param {Uint8Array<ArrayBuffer>} bytes all of them, on memory of their own; with a handle the
   *   first
   * @param {FileHandle} [handle]
   */
  constructor(bytes, handle) {
    this.bytes = bytes;
    this.handle = handle;
  }
}
