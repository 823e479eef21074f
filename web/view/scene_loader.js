// SPDX-License-Identifier: MIT
// Makes a three.js group, with textures, from the bytes of a glTF. Files that the glTF names come
// from memory, so nothing is fetched.
import { Cache, DataTexture, FileLoader, LoadingManager } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';

/** @typedef {import('../files/files.js').NamedBytes} NamedBytes */

Cache.enabled = false;  // different files may have the same name

/** @param {Uint8Array} bytes */
const blobUrl = (bytes) => URL.createObjectURL(new Blob([/** @type {BlobPart} */ (bytes)]));

/** Decodes a KTX2 texture to texels, which every graphics card shows.
 * @param {ArrayBuffer} buffer @returns {Promise<DataTexture>} */
async function decoded(buffer) {
  const worker = new Worker(new URL('./ktx_worker.js', import.meta.url), { type: 'module' });
  try {
    const { data, width, height } = await new Promise((resolve, reject) => {
      worker.onmessage = ({ data: { answer, error } }) =>
        (error ? reject(new Error(error)) : resolve(answer));
      worker.onerror = ({ message }) => reject(new Error(message));
      worker.postMessage(buffer, [buffer]);
    });
    const texture = new DataTexture(data, width, height);
    texture.needsUpdate = true;
    return texture;
  } finally {
    worker.terminate();
  }
}

/** @param {LoadingManager} manager */
const ktx2Loader = (manager) => ({
  /** @param {string} url @param {(texture: DataTexture) => void} onLoad @param {unknown} _
   * @param {(error: unknown) => void} onError */
  load(url, onLoad, _, onError) {
    new FileLoader(manager).setResponseType('arraybuffer').loadAsync(url)
      .then((bytes) => decoded(/** @type {ArrayBuffer} */ (bytes))).then(onLoad, onError);
  },
});

/**
 * @param {Uint8Array} bytes a GLB, or the text of a glTF
 * @param {NamedBytes[]} [resources]
 * @returns {Promise<import('three').Group>}
 */
export async function loadScene(bytes, resources = []) {
  const urls = new Map(resources.map(({ name, bytes: content }) => [name, blobUrl(content)]));
  const manager = new LoadingManager();
  manager.setURLModifier((url) => urls.get(url) ?? urls.get(decodeURIComponent(url)) ?? url);
  const loader = new GLTFLoader(manager).setMeshoptDecoder(MeshoptDecoder)
    .setKTX2Loader(/** @type {any} */ (ktx2Loader(manager)));
  try {
    const isWhole = bytes.length === bytes.buffer.byteLength;
    const data = /** @type {ArrayBuffer} */ (isWhole ? bytes.buffer : bytes.slice().buffer);
    return (await loader.parseAsync(data, '')).scene;
  } finally {
    for (const url of urls.values()) URL.revokeObjectURL(url);
  }
}
