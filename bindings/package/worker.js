// SPDX-License-Identifier: MIT
// The worker in browsers.

import { serve } from './worker/serve.js';

const scope = /** @type {any} */ (globalThis);
const receive = serve((message, transfer) => scope.postMessage(message, transfer));
scope.addEventListener('message', (/** @type {MessageEvent} */ event) => receive(event.data));
