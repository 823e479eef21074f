// SPDX-License-Identifier: MIT
// Bytes whose number nobody knows before the last of them: of a pipe, a stream or a packed file.
// They are kept in pieces of one size, and put together only where JavaScript needs them all.

import { bytesAsked, bytesLooked, isLeftToCore } from './contents.js';
import { OpenFile } from './open_file.js';

const pieceSize = 2 ** 22;

/** Copies bytes from pieces. @param {readonly Uint8Array[]} pieces
 * @param {number} from @param {Uint8Array} into all of them must be there */
function copy(pieces, from, into) {
  for (let filled = 0; filled < into.length;) {
    const at = from + filled;
    const start = at % pieceSize;
    const some = pieces[Math.floor(at / pieceSize)]
      .subarray(start, start + into.length - filled);
    into.set(some, filled);
    filled += some.length;
  }
}

/** The way to the blocks of bytes kept in pieces.
 * @param {{ pieces: readonly Uint8Array[], size: number }} handle
 * @returns {import('./open_file.js').ReadBlock} */
export const blocksOfPieces = ({ pieces, size }) => (at, into) => {
  if (at + into.length > size) return false;
  copy(pieces, at, into);
  return true;
};

export class Pieces {
  /** @type {Uint8Array<ArrayBuffer>[]} */
  #pieces = [];
  size = 0;

  /** @param {Uint8Array} bytes the caller's */
  add(bytes) {
    for (let taken = 0; taken < bytes.length;) {
      const start = this.size % pieceSize;
      if (start === 0) this.#pieces.push(new Uint8Array(pieceSize));
      const some = bytes.subarray(taken, taken + pieceSize - start);
      this.#pieces[this.#pieces.length - 1].set(some, start);
      taken += some.length;
      this.size += some.length;
    }
  }

  /** All bytes in one. @returns {Uint8Array<ArrayBuffer>} */
  joined() {
    return this.#first(this.size);
  }

  /** @param {number} count */
  #first(count) {
    const bytes = new Uint8Array(count);
    copy(this.#pieces, 0, bytes);
    return bytes;
  }

  /** The file: its first bytes and the pieces, if only the core needs all of it, else all bytes. */
  open() {
    const first = this.#first(Math.min(this.size, bytesLooked));
    const begin = this.#first(Math.min(this.size, bytesAsked(first)));
    return this.size > begin.length && isLeftToCore(begin)
      ? new OpenFile(begin, { pieces: this.#pieces, size: this.size })
      : new OpenFile(this.joined());
  }
}
