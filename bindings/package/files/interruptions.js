// SPDX-License-Identifier: MIT
// Undoes unfinished work when the process is asked to end in the middle of it: by Ctrl+C, a polite
// kill, a closed terminal, an error that nobody caught. The signal then does what it always does.

const signals = /** @type {const} */ (['SIGINT', 'SIGTERM', 'SIGHUP']);

/** @type {Set<() => void>} */
const undoings = new Set();

/** Undoes the last begun first, since it may be a part of another. */
function undoAll() {
  for (const undo of [...undoings].reverse()) undo();
  undoings.clear();
}

/** @param {NodeJS.Signals} signal */
function end(signal) {
  undoAll();
  watch('off');
  process.kill(process.pid, signal);
}

/** @param {'on' | 'off'} way */
function watch(way) {
  for (const signal of signals) process[way](signal, end);
  process[way]('exit', undoAll);
}

/**
 * @template Result
 * @param {() => void} undo done at once, if the process ends before the body does
 * @param {() => Promise<Result>} body
 * @returns {Promise<Result>}
 */
export async function undoneIfInterrupted(undo, body) {
  if (undoings.size === 0) watch('on');
  undoings.add(undo);
  try {
    return await body();
  } finally {
    undoings.delete(undo);
    if (undoings.size === 0) watch('off');
  }
}
