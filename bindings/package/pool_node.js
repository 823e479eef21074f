// SPDX-License-Identifier: MIT
// remesher/pool in Node. pool.js documents it, and its types.

import { PoolOf } from './api/pool_of.js';
import * as platform from './platform_node.js';

export class Pool extends PoolOf {
  /** @param {import('./api/pool_of.js').PoolOptions} [options] */
  constructor(options = {}) {
    super(platform, options);
  }
}
