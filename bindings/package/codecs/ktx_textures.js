// SPDX-License-Identifier: MIT
// KTX2 textures as glTF has them (KHR_texture_basisu): ETC1S and UASTC to texels.

/** How the transcoder calls texels of red, green, blue and alpha, a byte each. */
const rgba = 13;

/** @type {Promise<any> | undefined} */
let transcoder;

async function startTranscoder() {
  const { default: createBasis } = await import('../basis_decoder.mjs');
  const module = await createBasis({ printErr: () => {} });
  module.initializeBasis();
  return module;
}

/**
 * The finest level of a texture.
 * @param {ArrayBuffer} buffer of the file
 * @returns {Promise<{ data: Uint8ClampedArray, width: number, height: number }>}
 */
export async function decodeKtx2(buffer) {
  const { KTX2File } = await (transcoder ??= startTranscoder());
  const file = new KTX2File(new Uint8Array(buffer));
  try {
    if (!file.isValid() || !file.startTranscoding()) throw new Error('its header is broken');
    const data = new Uint8ClampedArray(file.getImageTranscodedSizeInBytes(0, 0, 0, rgba));
    if (!file.transcodeImage(new Uint8Array(data.buffer), 0, 0, 0, rgba, 0, -1, -1)) {
      throw new Error('its blocks are broken');
    }
    const result = { data, width: file.getWidth(), height: file.getHeight() };
    file.close();
    file.delete();
    return result;
  } catch (error) {
    transcoder = undefined; // broken bytes may have broken it, too
    throw error;
  }
}
