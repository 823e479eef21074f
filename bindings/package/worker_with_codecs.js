// SPDX-License-Identifier: MIT
// The worker in browsers, with codecs of images.

import { loadPackage } from './textures/bundled_packages.js';
import { serveBrowser } from './worker/serve.js';

serveBrowser({ load: loadPackage });
