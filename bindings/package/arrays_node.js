// SPDX-License-Identifier: MIT
// remesher/arrays in Node. Functions and types are documented in arrays.js.

import { ArraysApi } from './api/arrays_api.js';
import * as platform from './platform_node.js';

export { RemeshError } from './base/errors.js';

const api = new ArraysApi(platform, platform.client);
export const init = api.init.bind(api);
export const remesh = api.remesh.bind(api);
export const remeshScene = api.remeshScene.bind(api);
export const inspect = api.inspect.bind(api);
