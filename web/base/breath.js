// SPDX-License-Identifier: MIT
// A pause in long work, in which the page answers: shorter than a timer's, and as short in a tab in
// the background.

/** @returns {Promise<void>} after what else is waiting */
export function breath() {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
