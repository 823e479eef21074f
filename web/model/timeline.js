// SPDX-License-Identifier: MIT
// Undo and redo over plain states. States are kept and compared as JSON.

/** Largest number of remembered states. */
const most = 200;

/** @template State */
export class Timeline {
  /** @type {string[]} */
  #states = [];
  #at = -1;

  /** Forgets all states, and begins with this state. @param {State} state */
  begin(state) {
    this.#states = [JSON.stringify(state)];
    this.#at = 0;
  }

  /** Adds a state after the present one and drops the undone states. An equal state is not added.
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

  /** Goes back or forth. @param {1 | -1} step @returns {State | null} null: no state there */
  go(step) {
    if (!this.can(step)) return null;
    this.#at += step;
    return JSON.parse(this.#states[this.#at]);
  }
}
