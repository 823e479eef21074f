// SPDX-License-Identifier: MIT
// The package in browsers.

import { createApi } from './api/api.js';
import * as platform from './platform_browser.js';

/**
 * The types of all that goes in and comes out.
 * @typedef {import('./api/inputs.js').Bytes} Bytes
 * @typedef {import('./api/api.js').InitOptions} InitOptions
 * @typedef {import('./api/inputs.js').FileOptions} FileOptions
 * @typedef {import('./api/inputs.js').OutputOptions} OutputOptions
 * @typedef {import('./api/api.js').RemeshResult} RemeshResult
 * @typedef {import('./api/api.js').RemeshFileResult} RemeshFileResult
 * @typedef {import('./api/api.js').ConvertFileResult} ConvertFileResult
 * @typedef {import('./api/client.js').RunOptions} RunOptions
 * @typedef {import('./base/errors.js').ErrorCode} ErrorCode
 * @typedef {import('./base/messages.js').Inspection} Inspection
 * @typedef {import('./base/messages.js').Mesh} Mesh
 * @typedef {import('./base/messages.js').MeshAttribute} MeshAttribute
 * @typedef {import('./base/messages.js').MeshReport} MeshReport
 * @typedef {import('./base/messages.js').NamedBytes} NamedBytes
 * @typedef {import('./base/messages.js').ProgressEvent} ProgressEvent
 * @typedef {import('./base/messages.js').RemeshReport} RemeshReport
 * @typedef {import('./base/messages.js').Warning} Warning
 * @typedef {import('./base/options.js').RemeshOptions} RemeshOptions
 */

export { RemeshError } from './base/errors.js';
export const { init, remesh, remeshFile, convertFile, inspect } = createApi(platform);
