// SPDX-License-Identifier: MIT
// Undo and redo over plain states: a state is what JSON says of it.

/** The steps that are remembered. */
const most = 200;

/** @template State */
export class Timeline {
  /** @type {string[]} */
  #states = [];
  #at = -1;

  /** Forgets all, and begins with this. @param {State} state */
  begin(state) {
    this.#states = [JSON.stringify(state)];
    this.#at = 0;
  }

  /** A new state after the present one; what had been undone is gone. The same again is no step.
   * @param {State} state */
  add(state) {
    const text = JSON.stringify(state);
    if (text === this.#states[this.#at]) return;
    this.#states = [...this.#states.slice(0, this.#at + 1), text].slice(-most);
    this.#at = this.#states.length - 1;
  }

  /** @param {1 | -1} step */
  can(step) {
    return this.#states[this.#at + step] !== undefined;
  }

  /** Goes back or forth. @param {1 | -1} step @returns {State | null} null: there is nothing */
  go(step) {
    if (!this.can(step)) return null;
    this.#at += step;
    return JSON.parse(this.#states[this.#at]);
  }
}
