// SPDX-License-Identifier: MIT
// A PNG from a function of the pixel: 8-bit colours, without filters.
import { deflateSync } from 'node:zlib';

/** The CRC remainder of each byte. */
const rests = Uint32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let k = 0; k < 8; k += 1) rest = (rest >>> 1) ^ (rest & 1 ? 0xedb88320 : 0);
  return rest;
});

function crc(bytes) {
  let rest = ~0;
  for (const byte of bytes) rest = (rest >>> 8) ^ rests[(rest ^ byte) & 255];
  return ~rest >>> 0;
}

function word(value) {
  const bytes = Buffer.alloc(4);
  bytes.writeUInt32BE(value);
  return bytes;
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type), data]);
  return Buffer.concat([word(data.length), body, word(crc(body))]);
}

/** @param {(x: number, y: number) => number[]} colour red, green, blue from 0 to 255, and alpha or
 * none */
export function png(width, height, colour) {
  const channels = colour(0, 0).length;
  const row = 1 + channels * width;
  const rows = Buffer.alloc(row * height);
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) rows.set(colour(x, y), row * y + 1 + channels * x);
  }
  return new Uint8Array(Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk('IHDR', Buffer.from(
      [...word(width), ...word(height), 8, channels === 4 ? 6 : 2, 0, 0, 0])),
    chunk('IDAT', deflateSync(rows)),
    chunk('IEND', Buffer.alloc(0)),
  ]));
}
