// SPDX-License-Identifier: MIT
// The worker's side of the conversation: the part for every platform, and the part for browsers.

import { Engine } from './engine.js';
import { failureFrom } from '../base/errors.js';

/** @typedef {import('../base/messages.js').ToWorker} ToWorker */
/** @typedef {import('../base/messages.js').FromWorker} FromWorker */

/** The buffers a result owns, to be handed over instead of copied. @param {any} result */
function buffersOf(result) {
  const arrays = [];
  for (const mesh of [...result.meshes ?? [], ...(result.lods ?? []).flat()]) {
    arrays.push(mesh.positions, mesh.indices, ...(mesh.groups ? [mesh.groups] : []),
      ...(mesh.quads ? [mesh.quads] : []));
    for (const { array } of Object.values(mesh.attributes)) arrays.push(array);
  }
  for (const { bytes } of result.files ?? []) arrays.push(bytes);
  return arrays.map((array) => array.buffer);
}

/**
 * @param {(message: FromWorker, transfer: ArrayBuffer[]) => void} post
 * @param {import('./engine.js').EnginePlatform} [codecs]
 * @returns {(message: ToWorker) => Promise<void>} to be called with every message
 */
export function serve(post, codecs) {
  /** @type {Engine} */
  let engine;
  return async (message) => {
    if (message.type === 'start') {
      engine = new Engine(message, { ...codecs, helpers: message.helpers });
      return;
    }
    try {
      const onProgress = message.progress
        ? (/** @type {import('../base/messages.js').ProgressEvent} */ event) =>
          post({ type: 'progress', event }, [])
        : undefined;
      const result = await engine.run(message.job, onProgress);
      post({ type: 'done', result }, buffersOf(result));
    } catch (error) {
      post({ type: 'failed', failure: failureFrom(error) }, []);
    }
  };
}

const scope = /** @type {any} */ (globalThis);

/** A Blob's blocks: workers of browsers can wait for them.
 * @type {import('../base/open_file.js').BlocksOf} */
function blocksOf({ blob }) {
  if (!blob || !scope.FileReaderSync) return undefined;
  const reader = new scope.FileReaderSync();
  return (at, into) => {
    try {
      into.set(new Uint8Array(reader.readAsArrayBuffer(blob.slice(at, at + into.length))));
      return at + into.length <= blob.size;
    } catch {
      return false;
    }
  };
}

/** In browsers. @param {import('../textures/image_codecs.js').CodecSource} [codecs] */
export function serveBrowser(codecs) {
  const receive = serve((message, transfer) => scope.postMessage(message, transfer),
    { ...codecs, blocksOf });
  scope.addEventListener('message', (/** @type {MessageEvent} */ event) => receive(event.data));
}
