// SPDX-License-Identifier: MIT
// The decoder's module that the build makes of draco3dgltf; draco.js alone knows what is in it.
export default function createDraco(): Promise<any>;
