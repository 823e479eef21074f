// SPDX-License-Identifier: MIT
// The worker that is started unless codecs bring their own, written so that bundlers see it.

/** Browsers start no worker from another server, such as a CDN, but one that imports it. */
function borrowedWorker() {
  const address = import.meta.url.replace(/[^/]*$/, 'worker.js');
  const script = new Blob([`import ${JSON.stringify(address)};`], { type: 'text/javascript' });
  const url = URL.createObjectURL(script);
  const worker = new Worker(url, { type: 'module' });
  worker.addEventListener('message', () => URL.revokeObjectURL(url), { once: true });
  return worker;
}

const isElsewhere = () => globalThis.location?.origin !== new URL(import.meta.url).origin
  && /^https?:/.test(import.meta.url);

export const plainWorker = () => (isElsewhere() ? borrowedWorker()
  : new Worker(new URL('./worker.js', import.meta.url), { type: 'module' }));
