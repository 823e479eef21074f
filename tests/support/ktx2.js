// SPDX-License-Identifier: MIT
// Makes KTX2 textures: UASTC blocks of one colour each, as the specification of UASTC lays them out
// (mode 8), in a container that compresses nothing more.

const identifier = [0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 0x0d, 0x0a, 0x1a, 0x0a];
const side = 4; // texels
const blockBytes = 16;
const solid = { code: 0x17n, bits: 5n }; // mode 8

/** @param {number[]} colour of red, green, blue and, if not opaque, alpha */
function blockOf([red, green, blue, alpha = 255]) {
  let bits = solid.code;
  [red, green, blue, alpha].forEach((value, i) => {
    bits |= BigInt(value) << (solid.bits + 8n * BigInt(i));
  });
  return [bits, 0n];
}

/** What the texels are, by the Khronos Data Format Specification: UASTC in sRGB. */
function describe() {
  const words = new DataView(new ArrayBuffer(44));
  const set = (/** @type {number} */ at, /** @type {number[]} */ ...bytes) =>
    bytes.forEach((byte, i) => words.setUint8(at + i, byte));
  set(0, 44);
  set(8, 2, 0, 40, 0, 166, 1, 2, 0, side - 1, side - 1, 0, 0, blockBytes);
  set(28, 0, 0, 127, 3);
  words.setUint32(40, 0xffffffff, true);
  return new Uint8Array(words.buffer);
}

/**
 * @param {number} columns of blocks of four by four texels
 * @param {number} rows
 * @param {(column: number, row: number) => number[]} colour of a block, up to 255 a channel
 * @returns {Uint8Array}
 */
export function ktx2(columns, rows, colour) {
  const description = describe();
  const [atLevels, atDescription] = [80, 104];
  const atBlocks = Math.ceil((atDescription + description.length) / blockBytes) * blockBytes;
  const bytes = new Uint8Array(atBlocks + blockBytes * columns * rows);
  const view = new DataView(bytes.buffer);
  bytes.set(identifier);
  [0, 1, side * columns, side * rows, 0, 0, 1, 1, 0, atDescription, description.length]
    .forEach((word, i) => view.setUint32(12 + 4 * i, word, true));
  const length = BigInt(blockBytes * columns * rows);
  [BigInt(atBlocks), length, length]
    .forEach((word, i) => view.setBigUint64(atLevels + 8 * i, word, true));
  bytes.set(description, atDescription);
  for (let i = 0; i < columns * rows; i += 1) {
    blockOf(colour(i % columns, Math.floor(i / columns))).forEach((word, half) =>
      view.setBigUint64(atBlocks + blockBytes * i + 8 * half, word, true));
  }
  return bytes;
}
