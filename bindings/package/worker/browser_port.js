// SPDX-License-Identifier: MIT
// Gives a browser's worker the interface of WorkerPort.

/** @param {Worker} worker */
export function portOf(worker) {
  return {
    post: (/** @type {any} */ message, /** @type {ArrayBuffer[]} */ transfer) =>
      worker.postMessage(message, transfer),
    listen(/** @type {(message: any) => void} */ onMessage,
      /** @type {(why: string) => void} */ onFailure) {
      worker.addEventListener('message', (event) => onMessage(event.data));
      worker.addEventListener('error', (event) => onFailure(event.message));
    },
    terminate: () => worker.terminate(),
    keepAlive() {},
  };
}
