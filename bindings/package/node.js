// SPDX-License-Identifier: MIT
// The package in Node: the functions of index.js, whose words and types are theirs too.

import { createApi } from './api/api.js';
import * as platform from './platform_node.js';

export { RemeshError } from './base/errors.js';

/** @type {Omit<typeof import('./index.js'), 'RemeshError'>} */
const api = createApi(platform);
export const { init, remesh, remeshScene, remeshFile, convertFile, inspect } = api;
