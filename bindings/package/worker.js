// SPDX-License-Identifier: MIT
// The worker in browsers.

import { serveBrowser } from './worker/serve.js';

serveBrowser();
