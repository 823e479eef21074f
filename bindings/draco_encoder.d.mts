// SPDX-License-Identifier: MIT
// The encoder's module that the build makes of draco3dgltf; compress_draco.js alone knows what is
// in it.
export default function createDraco(): Promise<any>;
