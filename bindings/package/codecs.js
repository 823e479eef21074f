// SPDX-License-Identifier: MIT
// remesher/codecs, for browsers: a worker whose image codecs bundlers find and put beside it. Node
// finds them by itself. The `new URL(…, import.meta.url)` is written out for bundlers.

import { loadPackage } from './textures/bundled_packages.js';

/** @typedef {import('./api/client.js').Codecs} Codecs */

/**
 * The codecs of images that painting textures needs, as bundlers find them.
 *
 * @example
 * await init({ codecs });
 * const { bytes } = await remeshFile(file, { output: 'glb', textures: 'bake' });
 *
 * @type {Codecs}
 */
export const codecs = {
  worker: () => new Worker(new URL('./worker_with_codecs.js', import.meta.url), { type: 'module' }),
  load: loadPackage,
};
