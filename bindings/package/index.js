// SPDX-License-Identifier: MIT
// The package in browsers.

import { createApi } from './api.js';
import * as platform from './platform_browser.js';

export { RemeshError } from './errors.js';
export const { init, remesh, remeshFile, inspect } = createApi(platform);
