// SPDX-License-Identifier: MIT
// Makes a three.js group, with textures, from the bytes of a glTF. Files that the glTF names come
// from memory, so nothing is fetched.
import { Cache, LoadingManager } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';

/** @typedef {import('../files/files.js').NamedBytes} NamedBytes */

Cache.enabled = false;  // different files may have the same name

/** @param {Uint8Array} bytes */
const blobUrl = (bytes) => URL.createObjectURL(new Blob([/** @type {BlobPart} */ (bytes)]));

/**
 * @param {Uint8Array} bytes a GLB, or the text of a glTF
 * @param {NamedBytes[]} [resources]
 * @returns {Promise<import('three').Group>}
 */
export async function loadScene(bytes, resources = []) {
  const urls = new Map(resources.map(({ name, bytes: content }) => [name, blobUrl(content)]));
  const manager = new LoadingManager();
  manager.setURLModifier((url) => urls.get(url) ?? urls.get(decodeURIComponent(url)) ?? url);
  const loader = new GLTFLoader(manager).setMeshoptDecoder(MeshoptDecoder);
  try {
    const isWhole = bytes.length === bytes.buffer.byteLength;
    const data = /** @type {ArrayBuffer} */ (isWhole ? bytes.buffer : bytes.slice().buffer);
    return (await loader.parseAsync(data, '')).scene;
  } finally {
    for (const url of urls.values()) URL.revokeObjectURL(url);
  }
}
