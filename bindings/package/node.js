// SPDX-License-Identifier: MIT
// The package in Node.

import { createApi } from './api/api.js';
import * as platform from './platform_node.js';

export { RemeshError } from './base/errors.js';
export const { init, remesh, remeshFile, convertFile, inspect } = createApi(platform);
