// SPDX-License-Identifier: MIT
// The one error that callers see, and the list of its codes: the same as ErrorCode's in
// src/base/error.h, in the same order (a test compares them).

export const errorCodes = /** @type {const} */ ([
  'INTERNAL', // our fault
  'CANCELLED', // the run was stopped from inside
  'OUT_OF_MEMORY', // beyond what WebAssembly or the machine has
  'INVALID_OPTION', // an option's value is out of range, or two contradict each other
  'UNKNOWN_OPTION', // no option has this name
  'UNKNOWN_FORMAT', // neither extension nor content is one we read or write
  'EMPTY_FILE', // no bytes
  'PARSE_ERROR', // the bytes are not what the format promises
  'MISSING_RESOURCE', // a file refers to another that was not given
  'UNSUPPORTED', // valid, but beyond what we read
  'INVALID_MESH', // arrays of the wrong type or length, or no closed body
  'INDEX_OUT_OF_RANGE', // a triangle names a vertex that is not there
  'NON_FINITE', // NaN or infinity among the coordinates
  'NO_TRIANGLES', // nothing to remesh
  'TARGET_TOO_SMALL', // fewer vertices asked for than the surface needs
  'TARGET_BELOW_CURVES', // fewer vertices asked for than the feature curves need
  'INPUT_UNREADABLE', // command line: cannot open the input
  'OUTPUT_UNWRITABLE', // command line: cannot write the output
]);

/** @typedef {typeof errorCodes[number]} ErrorCode */

/** What went wrong, for people (`message`), for programs (`code`), and what to do (`hint`). */
export class RemeshError extends Error {
  /**
   * @param {ErrorCode} code
   * @param {string} message
   * @param {string} [hint]
   * @param {{ cause?: unknown }} [options]
   */
  constructor(code, message, hint = '', options = undefined) {
    super(message, options);
    this.name = 'RemeshError';
    /** @type {ErrorCode} */
    this.code = code;
    /** @type {string} */
    this.hint = hint;
  }
}

/** @typedef {{ code: ErrorCode, message: string, hint: string }} Failure an error on its way */

/** @param {unknown} error @returns {Failure} */
export function failureFrom(error) {
  if (error instanceof RemeshError) {
    return { code: error.code, message: error.message, hint: error.hint };
  }
  return { code: 'INTERNAL', message: String(error), hint: '' };
}

/** The error again, at the other end. @param {Failure} failure */
export const errorFrom = ({ code, message, hint }) => new RemeshError(code, message, hint);

/** The error that an aborted signal rejects with. @param {string} [why] */
export function abortError(why) {
  return new DOMException(why ?? 'The run was cancelled.', 'AbortError');
}
