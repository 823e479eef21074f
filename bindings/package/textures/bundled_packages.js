// SPDX-License-Identifier: MIT
// The codecs of images by names that bundlers see: all three packages must be installed.

/** @type {Record<string, () => Promise<any[]>>} */
const packages = {
  '@jsquash/jpeg': () =>
    Promise.all([import('@jsquash/jpeg/decode.js'), import('@jsquash/jpeg/encode.js')]),
  '@jsquash/png': () =>
    Promise.all([import('@jsquash/png/decode.js'), import('@jsquash/png/encode.js')]),
  '@jsquash/webp': () => Promise.all([import('@jsquash/webp/decode.js'), webpEncoder()]),
};

/** The package's encode.js, without the encoder for browsers that lack SIMD: they cannot run the
 * engine either, and its bytes might differ. */
async function webpEncoder() {
  const [{ default: make }, { defaultOptions }, { initEmscriptenModule }] = await Promise.all([
    import('@jsquash/webp/codec/enc/webp_enc_simd.js'), import('@jsquash/webp/meta.js'),
    import('@jsquash/webp/utils.js')]);
  /** @type {Promise<any> | undefined} */
  let encoder;
  /** @param {WebAssembly.Module} [module] */
  const init = (module) => (encoder = initEmscriptenModule(make, module));
  /** @param {any} image @param {object} options */
  const encode = async ({ data, width, height }, options) =>
    (await (encoder ?? init())).encode(data, width, height, { ...defaultOptions, ...options });
  return { init, default: encode };
}

/** The two halves of a package, to decode and to encode. @param {string} name */
export const loadPackage = (name) => packages[name]();
