// SPDX-License-Identifier: MIT
// Values that the browser keeps for the next visit. The page also works if nothing is kept. Other
// programs, older versions of the page and the visitor can change what is kept, so every value is
// checked when it is read, and forgotten if it does not fit.

const prefix = 'remesher.';

/** Longer texts are not even parsed, in UTF-16 units. */
const longest = 2 ** 21;

/** @param {string} key @returns {string | null} */
function read(key) {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** @param {string} key @param {string | null} text null: forgets it */
function write(key, text) {
  try {
    if (text === null) localStorage.removeItem(key);
    else localStorage.setItem(key, text);
  } catch {
    // Storage is full or forbidden: the visit itself does not need it.
  }
}

/** One kept value. @template Value */
export class Setting {
  #key;
  #valueOf;

  /** @param {string} name
   * @param {(text: string) => Value | undefined} valueOf the value that a kept text stands for;
   *   undefined, or an error, if it stands for none */
  constructor(name, valueOf) {
    this.#key = prefix + name;
    this.#valueOf = valueOf;
  }

  /** The kept value; undefined if there is none. A text that stands for no value is forgotten.
   * @returns {Value | undefined} */
  recall() {
    const text = read(this.#key);
    if (text === null) return undefined;
    try {
      const value = text.length <= longest ? this.#valueOf(text) : undefined;
      if (value !== undefined) return value;
    } catch {
      // Not the text of any value.
    }
    write(this.#key, null);
    return undefined;
  }

  /** @param {string | null} text null, or too long a text: forgets the value */
  remember(text) {
    write(this.#key, text === null || text.length > longest ? null : text);
  }
}

/** A setting with one value besides its default; the default is not stored.
 * @param {string} name @param {string} other the text of the other value */
export const switchSetting = (name, other) =>
  new Setting(name, (text) => (text === other ? other : undefined));
