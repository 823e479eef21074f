// SPDX-License-Identifier: MIT
// The package in Node.

import { createApi } from './api.js';
import * as platform from './platform_node.js';

export { RemeshError } from './errors.js';
export const { init, remesh, remeshFile, convertFile, inspect } = createApi(platform);
