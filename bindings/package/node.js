// SPDX-License-Identifier: MIT
// The package in Node. index.js documents its functions, and their types.

import { Api } from './api/api.js';
import * as platform from './platform_node.js';

export { RemeshError } from './base/errors.js';

const api = new Api(platform, platform.client);
export const init = api.init.bind(api);
export const remesh = api.remesh.bind(api);
export const remeshScene = api.remeshScene.bind(api);
export const remeshFile = api.remeshFile.bind(api);
export const repair = api.repair.bind(api);
export const repairFile = api.repairFile.bind(api);
export const boolean = api.boolean.bind(api);
export const booleanFiles = api.booleanFiles.bind(api);
export const bake = api.bake.bind(api);
export const bakeFile = api.bakeFile.bind(api);
export const unwrap = api.unwrap.bind(api);
export const unwrapFile = api.unwrapFile.bind(api);
export const convertFile = api.convertFile.bind(api);
export const inspect = api.inspect.bind(api);
