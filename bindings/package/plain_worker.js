// SPDX-License-Identifier: MIT
// The worker that is started unless codecs bring their own, written so that bundlers see it.

export const plainWorker = () =>
  new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
