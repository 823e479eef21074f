// SPDX-License-Identifier: MIT
// The package in browsers.

import { createApi } from './api.js';
import * as platform from './platform_browser.js';

/**
 * The types of all that goes in and comes out.
 * @typedef {import('./inputs.js').Bytes} Bytes
 * @typedef {import('./api.js').InitOptions} InitOptions
 * @typedef {import('./inputs.js').FileOptions} FileOptions
 * @typedef {import('./inputs.js').OutputOptions} OutputOptions
 * @typedef {import('./api.js').RemeshResult} RemeshResult
 * @typedef {import('./api.js').RemeshFileResult} RemeshFileResult
 * @typedef {import('./api.js').ConvertFileResult} ConvertFileResult
 * @typedef {import('./client.js').RunOptions} RunOptions
 * @typedef {import('./errors.js').ErrorCode} ErrorCode
 * @typedef {import('./messages.js').Inspection} Inspection
 * @typedef {import('./messages.js').Mesh} Mesh
 * @typedef {import('./messages.js').MeshAttribute} MeshAttribute
 * @typedef {import('./messages.js').MeshReport} MeshReport
 * @typedef {import('./messages.js').NamedBytes} NamedBytes
 * @typedef {import('./messages.js').ProgressEvent} ProgressEvent
 * @typedef {import('./messages.js').RemeshReport} RemeshReport
 * @typedef {import('./messages.js').Warning} Warning
 * @typedef {import('./options.js').RemeshOptions} RemeshOptions
 */

export { RemeshError } from './errors.js';
export const { init, remesh, remeshFile, convertFile, inspect } = createApi(platform);
