// SPDX-License-Identifier: MIT
// What threemf.js uses of fflate.
export function strToU8(text: string): Uint8Array;
export function unzipSync(
  bytes: Uint8Array,
  options: { filter: (entry: { name: string; originalSize: number }) => boolean },
): Record<string, Uint8Array>;
export function zipSync(
  entries: Record<string, Uint8Array>,
  options: { mtime: Date },
): Uint8Array;
