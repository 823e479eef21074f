// SPDX-License-Identifier: MIT
// What decompress.js uses of meshoptimizer's decoder.
export const MeshoptDecoder: {
  ready: Promise<void>;
  decodeGltfBuffer(
    target: Uint8Array,
    count: number,
    size: number,
    source: Uint8Array,
    mode: string,
    filter?: string,
  ): void;
};
