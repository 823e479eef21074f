// SPDX-License-Identifier: MIT
// Foreign text inside a message of ours: names and lines of files from anywhere may be of any
// length, and may hold what a terminal obeys or what turns the rest of a line around. The core's
// base/legible.h does the same, and is held to the same cases.

const longest = 120;
const headLength = 80;

// What shows nothing but does something: controls, marks of direction, ends of lines, tags; and
// halves of pairs, which no encoding can write.
const invisible = new RegExp('[\\u0000-\\u001f\\u007f-\\u009f\\u00ad\\u061c\\u180e'
  + '\\u200b-\\u200f\\u2028-\\u202e\\u2060-\\u206f\\ufeff\\ufff9-\\ufffb'
  + '\\u{e0000}-\\u{e007f}\\p{Cs}]', 'gu');

/**
 * As they are shown. Of a long text only what can be is looked at: its two ends.
 * @param {string} text
 */
function charactersOf(text) {
  const end = 4 * longest;
  const ends = text.length > 2 * end ? text.slice(0, end) + text.slice(-end) : text;
  return Array.from(ends.replace(invisible, (character) =>
    `\\u{${Number(character.codePointAt(0)).toString(16)}}`));
}

/**
 * The text with control characters and invisible ones as \u{1b}; so in at most 120 characters, the
 * middle left out of a longer one.
 * @param {unknown} text
 */
export function legible(text) {
  const characters = charactersOf(String(text));
  const surplus = characters.length - longest;
  if (surplus > 0) characters.splice(headLength, surplus + 1, '…');
  return characters.join('');
}
