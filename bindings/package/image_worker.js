// SPDX-License-Identifier: MIT
// The worker for images in browsers, which the worker with codecs starts.

import { loadPackage } from './textures/bundled_packages.js';
import { serveImages } from './textures/image_workers.js';

const scope = /** @type {any} */ (globalThis);
const receive = serveImages((answer, transfer) => scope.postMessage(answer, transfer),
  { load: loadPackage });
scope.addEventListener('message', (/** @type {MessageEvent} */ event) => receive(event.data));
