// SPDX-License-Identifier: MIT
// Pseudo-random numbers, the same for the same seed [Marsaglia 2003, xorshift32].

export class Dice {
  #state;

  /** @param {number} seed */
  constructor(seed) {
    this.#state = (Math.imul(seed, 2654435761) ^ 0x5bd1e995) >>> 0 || 1;
    for (let i = 0; i < 8; i += 1) this.#next();
  }

  #next() {
    let state = this.#state;
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    this.#state = state >>> 0;
    return this.#state / 2 ** 32;
  }

  /** A number in [low, high). */
  number(low = 0, high = 1) {
    return low + (high - low) * this.#next();
  }

  /** A whole number from low to high, both included. */
  whole(low, high) {
    return low + Math.floor((high - low + 1) * this.#next());
  }

  chance(share) {
    return this.#next() < share;
  }

  pick(list) {
    return list[this.whole(0, list.length - 1)];
  }
}
