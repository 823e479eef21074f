// SPDX-License-Identifier: MIT
// A very large model on the stage: its picture has fewer triangles, which a worker finds. The
// worker keeps the surfaces of the file itself, so that the page holds none of them.
import { treeOf } from '../files/glb.js';
import { countIn } from './thinned_glb.js';

/** @typedef {import('./thinned_glb.js').Thinned} Thinned */
/** @typedef {import('./thinned_glb.js').Kept} Kept */
/** The model to show. content: the visitor's file itself; isOwned: nobody else needs the bytes.
 * @typedef {{ bytes: Uint8Array, resources: import('../files/files.js').NamedBytes[],
 *   content?: Blob | Uint8Array, isOwned?: boolean }} Gltf */

const mostShown = 1_000_000;

export class Thinning {
  #worker = new Worker(new URL('./thinning_worker.js', import.meta.url), { type: 'module' });
  /** @type {Thinned} */
  thinned = { shown: 0, all: 0 };
  /** By the numbers that the geometries have as `whole`. @type {Kept[]} */
  parts = [];

  /** One question at a time. @param {any} request @param {Transferable[]} [transfer]
   * @returns {Promise<any>} */
  #ask(request, transfer = []) {
    return new Promise((resolve, reject) => {
      this.#worker.onmessage = ({ data: { answer, error } }) =>
        (error ? reject(new Error(error)) : resolve(answer));
      this.#worker.onerror = ({ message }) => reject(new Error(message));
      this.#worker.postMessage(request, transfer);
    });
  }

  /** @param {Gltf} gltf @returns {Promise<Uint8Array>} the GLB that is shown */
  async begin({ bytes, content = bytes, isOwned }) {
    const { bytes: fewer, thinned, parts } = await this.#ask({ glb: content, most: mostShown },
      isOwned ? [bytes.buffer] : []);
    Object.assign(this, { thinned, parts });
    return fewer;
  }

  /** All triangles of the model. @param {import('three').Mesh[]} surfaces */
  soup(surfaces) {
    return this.#ask(surfaces.map(({ geometry, matrixWorld }) =>
      ({ whole: geometry.userData.whole, matrix: matrixWorld.elements })));
  }

  close() {
    this.#worker.terminate();
  }
}

/** Whether a model must be thinned out. Throws if it must be converted before that can be done.
 * @param {Gltf} gltf */
export function isTooLarge({ bytes, content }) {
  const { all, isPlain } = countIn(treeOf(bytes));
  if (all <= mostShown) return false;
  const isReady = isPlain && bytes[0] === 'g'.charCodeAt(0);
  if (content && !isReady) throw new Error('The scene is stored in parts');
  return isReady;
}
