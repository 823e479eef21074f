// SPDX-License-Identifier: MIT
// The worker in Node.

import { parentPort } from 'node:worker_threads';

import { compileCodec, blocksOf, spawnForImages } from './platform_node.js';
import { serve } from './worker/serve.js';

parentPort?.on('message', serve(
  (message, transfer) => parentPort?.postMessage(message, transfer),
  { compile: compileCodec, blocksOf, spawn: spawnForImages }));
