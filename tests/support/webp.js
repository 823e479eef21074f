// SPDX-License-Identifier: MIT
// Still WebP pictures put together to one that moves, as Google's "WebP Container Specification"
// says.

/** Little-endian. @param {number} value @param {number} length in bytes */
const bytesOf = (value, length) =>
  Buffer.from(Array.from({ length }, (_, i) => (value >>> (8 * i)) & 255));

/** @param {string} name @param {Uint8Array[]} parts */
function chunk(name, parts) {
  const content = Buffer.concat(parts);
  return Buffer.concat([Buffer.from(name), bytesOf(content.length, 4), content,
    Buffer.alloc(content.length % 2)]);
}

/** The picture data of a still without transparency. @param {Uint8Array} still */
function dataOf(still) {
  const bytes = Buffer.from(still);
  for (let at = 12; at < bytes.length;) {
    const length = bytes.readUInt32LE(at + 4);
    const end = at + 8 + length + length % 2;
    if (/^VP8[ L]$/.test(bytes.toString('latin1', at, at + 4))) return bytes.subarray(at, end);
    at = end;
  }
  throw new Error('The still has no picture.');
}

/**
 * @param {{ width: number, height: number }} size of all stills
 * @param {{ bytes: Uint8Array, milliseconds: number }[]} stills shown in turn, for ever
 */
export function animated({ width, height }, stills) {
  const [w, h] = [bytesOf(width - 1, 3), bytesOf(height - 1, 3)];
  const isMoving = 2, keepsNothing = 2;
  const content = [
    chunk('VP8X', [bytesOf(isMoving, 4), w, h]),
    chunk('ANIM', [bytesOf(0, 4), bytesOf(0, 2)]),
    ...stills.map(({ bytes, milliseconds }) => chunk('ANMF', [bytesOf(0, 6), w, h,
      bytesOf(milliseconds, 3), bytesOf(keepsNothing, 1), dataOf(bytes)])),
  ];
  const whole = Buffer.concat([Buffer.from('WEBP'), ...content]);
  return Buffer.concat([Buffer.from('RIFF'), bytesOf(whole.length, 4), whole]);
}
