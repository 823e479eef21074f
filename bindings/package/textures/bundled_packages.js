// SPDX-License-Identifier: MIT
// The codecs of images by names that bundlers see: all three packages must be installed.

/** @type {Record<string, () => Promise<any[]>>} */
const packages = {
  '@jsquash/jpeg': () =>
    Promise.all([import('@jsquash/jpeg/decode.js'), import('@jsquash/jpeg/encode.js')]),
  '@jsquash/png': () =>
    Promise.all([import('@jsquash/png/decode.js'), import('@jsquash/png/encode.js')]),
  '@jsquash/webp': () =>
    Promise.all([import('@jsquash/webp/decode.js'), import('@jsquash/webp/encode.js')]),
};

/** The two halves of a package, to decode and to encode. @param {string} name */
export const loadPackage = (name) => packages[name]();
