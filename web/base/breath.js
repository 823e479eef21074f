// SPDX-License-Identifier: MIT
// A pause in long work that lets the page react. The pause is shorter than a timer's, and as short
// in a background tab.

/** @returns {Promise<void>} resolved after the tasks that were already waiting */
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
