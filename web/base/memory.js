// SPDX-License-Identifier: MIT
// Values that the browser keeps for the next visit. The page also works if nothing is kept.

const prefix = 'remesher.';

/** @param {string} name @returns {string | null} */
export function recall(name) {
  try {
    return localStorage.getItem(prefix + name);
  } catch {
    return null;
  }
}

/** @param {string} name @param {string | null} value null: forgets it */
export function remember(name, value) {
  try {
    if (value === null) localStorage.removeItem(prefix + name);
    else localStorage.setItem(prefix + name, value);
  } catch {
    // Storage is full or forbidden: the visit itself does not need it.
  }
}
