// SPDX-License-Identifier: MIT
// Makes foreign text legible inside our messages: names and lines of files from anywhere may be of
// any length, and may hold characters that a terminal obeys or that turn the rest of a line around.
// The core's base/legible.h does the same, and is tested by the same cases.

const longest = 120;
const headLength = 80;

// Characters that show nothing but do something: controls, marks of direction, ends of lines, tags;
// and halves of surrogate pairs, which no encoding can write.
const invisible = new RegExp('[\\u0000-\\u001f\\u007f-\\u009f\\u00ad\\u061c\\u180e'
  + '\\u200b-\\u200f\\u2028-\\u202e\\u2060-\\u206f\\ufeff\\ufff9-\\ufffb'
  + '\\u{e0000}-\\u{e007f}\\p{Cs}]', 'gu');

/**
 * The characters as they are shown. Of a long text only the two ends are looked at: no more can be
 * shown.
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
