// SPDX-License-Identifier: MIT
// What compress_meshopt.js uses of meshoptimizer's encoder.
export const MeshoptEncoder: {
  ready: Promise<void>;
  encodeFilterOct(source: Float32Array, count: number, stride: number, bits: number): Uint8Array;
  encodeFilterExp(
    source: Float32Array,
    count: number,
    stride: number,
    bits: number,
    mode?: string,
  ): Uint8Array;
  encodeGltfBuffer(source: Uint8Array, count: number, size: number, mode: string): Uint8Array;
};
