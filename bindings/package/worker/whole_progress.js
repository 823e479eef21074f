// SPDX-License-Identifier: MIT
// The progress of a run, up to its end.

import { RemeshError } from '../base/errors.js';

/** @typedef {import('../base/messages.js').ProgressEvent} ProgressEvent */

/**
 * A listener to the progress of a run, which tells at the end that all is done.
 * @param {((event: ProgressEvent) => boolean | void) | undefined} onProgress
 */
export function toTheEnd(onProgress) {
  /** @type {ProgressEvent | undefined} */
  let last;
  /** @param {ProgressEvent} event */
  const listen = (event) => {
    last = event;
    return onProgress?.(event);
  };
  const end = () => {
    if (!last || last.fraction >= 1 || listen({ ...last, fraction: 1 }) !== false) return;
    throw new RemeshError('CANCELLED', 'The run was cancelled.');
  };
  return { listen: onProgress && listen, end };
}
