// SPDX-License-Identifier: MIT
// A file that the package itself has opened. Nobody else has its bytes, so they need no copy.

/**
 * How the bytes of a file that is read in blocks are reached, in this thread and in its workers.
 * @typedef {{ fd: number, size: number }} FileHandle
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
