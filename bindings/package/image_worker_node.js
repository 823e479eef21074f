// SPDX-License-Identifier: MIT
// The worker for images in Node.

import { parentPort } from 'node:worker_threads';

import { compileCodec } from './platform_node.js';
import { serveImages } from './textures/image_workers.js';

parentPort?.on('message', serveImages(
  (answer, transfer) => parentPort?.postMessage(answer, transfer), { compile: compileCodec }));
