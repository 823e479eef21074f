// SPDX-License-Identifier: MIT
// The worker in browsers, with codecs of images, and with workers for them where a worker can have
// any. The `new URL(…, import.meta.url)` is written out for bundlers.

import { loadPackage } from './textures/bundled_packages.js';
import { portOf } from './worker/browser_port.js';
import { serveBrowser } from './worker/serve.js';

const start = () => new Worker(new URL('./image_worker.js', import.meta.url), { type: 'module' });

serveBrowser({
  load: loadPackage,
  spawn: () => (typeof Worker === 'undefined' ? undefined : portOf(start())),
});
