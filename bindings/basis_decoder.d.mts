// SPDX-License-Identifier: MIT
// The decoder's module that the build makes of three's transcoder; ktx_textures.js alone knows what is in it.
export default function createBasis(options?: object): Promise<any>;
