// SPDX-License-Identifier: MIT
// Lowers the memory limit of a WebAssembly module, so that runs that would end at 4 GB end sooner.

const memorySection = 5;
const headerBytes = 8;

/** An unsigned LEB128 number. */
function readNumber(bytes, at) {
  let [value, length] = [0, 0];
  for (let more = true; more; length += 1) {
    value += (bytes[at + length] & 127) * 2 ** (7 * length);
    more = bytes[at + length] > 127;
  }
  return { value, length };
}

/** Writes a number in as many bytes as it had before. */
function writeNumber(bytes, { at, length, value }) {
  for (let i = 0; i < length; i += 1) {
    const isLast = i === length - 1;
    bytes[at + i] = (Math.floor(value / 2 ** (7 * i)) & 127) | (isLast ? 0 : 128);
  }
}

/** The module's bytes with another memory limit.
 * @param {Uint8Array} wasm @param {number} megabytes */
export function withMemory(wasm, megabytes) {
  const bytes = Uint8Array.from(wasm);
  let at = headerBytes;
  while (bytes[at] !== memorySection) {
    const { value, length } = readNumber(bytes, at + 1);
    at += 1 + length + value;
  }
  const counts = at + 1 + readNumber(bytes, at + 1).length; // of memories, then the limits
  const minimum = counts + 2;
  const maximum = minimum + readNumber(bytes, minimum).length;
  writeNumber(bytes, { at: maximum, length: readNumber(bytes, maximum).length,
    value: megabytes * 16 });
  return bytes;
}
