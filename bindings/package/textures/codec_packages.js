// SPDX-License-Identifier: MIT
// Where the codecs come from in Node: packages that users install beside this one.

import { RemeshError } from '../base/errors.js';

/** All are named at once, for most models have images of several kinds. */
const all = ['@jsquash/png', '@jsquash/jpeg', '@jsquash/webp'];

/**
 * The two halves of a package. Hides them from bundlers, which would complain to all who bake
 * nothing.
 * @param {string} name
 * @returns {Promise<any[]>} to decode, to encode
 */
export async function loadPackage(name) {
  try {
    return [await import(/* webpackIgnore: true */ /* @vite-ignore */ `${name}/decode.js`),
      await import(/* webpackIgnore: true */ /* @vite-ignore */ `${name}/encode.js`)];
  } catch (cause) {
    throw new RemeshError('UNSUPPORTED', `Baking textures needs the package ${name}.`,
      `npm install ${all.join(' ')}; in browsers, init({ codecs }) with what remesher/codecs `
        + 'exports.',
      { cause });
  }
}
