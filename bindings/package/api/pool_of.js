// SPDX-License-Identifier: MIT
// The class Pool, for any platform.

import { Api } from './api.js';
import { ClientPool } from './client_pool.js';
import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { requireObject } from '../base/options.js';

/** @import { WholePlatform } from './api.js' */
/** @import { Platform } from './client.js' */

/**
 * @typedef {object} PoolOptions
 * @property {number} [size] How many workers at most; as many as the machine has cores, if not
 *   given.
 */

const mostWorkers = 1024;

/** @param {PoolOptions} options @param {Platform} platform */
function sizeOf(options, platform) {
  requireObject(options);
  const unknown = Object.keys(options).find((name) => name !== 'size');
  if (unknown) {
    throw new RemeshError('UNKNOWN_OPTION', `There is no option ${legible(unknown)} here.`,
      'There is size.');
  }
  const { size = platform.cores() } = options;
  if (!Number.isInteger(size) || size < 1 || size > mostWorkers) {
    throw new RemeshError('INVALID_OPTION',
      `size must be a whole number from 1 to ${mostWorkers}.`);
  }
  return size;
}

/** Each function is documented where the class is exported, in pool.js. */
export class PoolOf extends Api {
  #clients;

  /** @param {WholePlatform} platform @param {PoolOptions} options */
  constructor(platform, options) {
    const clients = new ClientPool(platform, sizeOf(options, platform));
    super(platform, clients);
    this.#clients = clients;
  }

  close() {
    this.#clients.close();
  }
}
