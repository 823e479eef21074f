// SPDX-License-Identifier: MIT
// Standard output carries the report or the model alone, standard error the rest. A reader that
// stops reading (head, a closed pager) is no failure of ours.

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { codeOf, reason } from '../files/reasons.js';

const ourFault = new Set(['INTERNAL', 'OUT_OF_MEMORY', 'CANCELLED']);

/**
 * @param {string | Uint8Array} content
 * @returns {Promise<void>}
 */
export function print(content) {
  return new Promise((resolve, reject) => {
    process.stdout.write(content, (error) => {
      if (!error || codeOf(error) === 'EPIPE') resolve();
      else {
        reject(new RemeshError('OUTPUT_UNWRITABLE',
          `The standard output cannot be written: ${reason(error)}.`, 'Choose another output.'));
      }
    });
  });
}

/** @param {string} text */
export function say(text) {
  process.stderr.write(text);
}

/** A bar on a terminal, nothing elsewhere. @param {boolean} quiet */
export function progressBar(quiet) {
  if (quiet || !process.stderr.isTTY) return { onProgress: undefined, clear() {} };
  const width = 30;
  return {
    onProgress(/** @type {import('../base/messages.js').ProgressEvent} */ { phase, fraction }) {
      const done = Math.round(fraction * width);
      const bar = '█'.repeat(done).padEnd(width, '░');
      say(`\r\x1b[K${bar} ${Math.round(100 * fraction)} % ${phase}`);
    },
    clear: () => say('\r\x1b[K'),
  };
}

/** @param {unknown} error @returns {RemeshError} */
function knownError(error) {
  return error instanceof RemeshError
    ? error : new RemeshError('INTERNAL', legible(error), 'Please report this as a bug.');
}

/** What, where, what to do, and the code, in one line. @param {unknown} error */
export function errorInWords(error) {
  const { message, hint, code } = knownError(error);
  return `${`${message} ${hint}`.replace(/\s+/g, ' ').trim()} [${code}]`;
}

/** @param {unknown} error */
export function exitStatusOf(error) {
  return ourFault.has(knownError(error).code) ? 1 : 2;
}

/** Ignores errors of streams that have failed already: the writer has got the error. */
export function outliveClosedPipes() {
  for (const stream of [process.stdout, process.stderr]) stream.on('error', () => {});
}

/** The error as an object, for `--json`. @param {unknown} error */
export function failureFrom(error) {
  const { code, message, hint } = knownError(error);
  return { code, message, hint };
}

/** @param {number} seconds */
function timeInWords(seconds) {
  if (seconds < 60) return `${Math.ceil(seconds)} s`;
  return seconds < 3600 ? `${Math.ceil(seconds / 60)} min` : `${(seconds / 3600).toFixed(1)} h`;
}

/**
 * One bar for many files, with the time that is left if they are all alike.
 * @param {boolean} quiet @param {number} count
 */
export function progressOfMany(quiet, count) {
  if (quiet || !process.stderr.isTTY) {
    return { listener: () => undefined, done() {}, clear() {} };
  }
  const begin = performance.now();
  /** @type {Map<number, number>} of those that run */
  const fractions = new Map();
  let finished = 0;
  const bar = progressBar(quiet);
  const show = () => {
    const running = [...fractions.values()].reduce((sum, fraction) => sum + fraction, 0);
    const fraction = (finished + running) / count;
    const left = ((performance.now() - begin) / 1000) * ((1 - fraction) / fraction);
    const time = fraction > 0.02 ? `, ${timeInWords(left)} left` : '';
    bar.onProgress?.({ phase: `${finished} of ${count} files${time}`, fraction });
  };
  return {
    listener: (/** @type {number} */ number) =>
      (/** @type {import('../base/messages.js').ProgressEvent} */ { fraction }) => {
        fractions.set(number, fraction);
        show();
      },
    done(/** @type {number} */ number) {
      fractions.delete(number);
      finished += 1;
      show();
    },
    clear: bar.clear,
  };
}
