// SPDX-License-Identifier: MIT
// Dials are the algorithm's named constants that somebody chose. Each dial needs evidence, so their
// number may only fall.
import { filesUnder, readText } from './tree.js';

/** The rooms of src that are the algorithm, and the most dials that they may have together. */
export const algorithm = ['mesh', 'geometry', 'original', 'remesh', 'simplify', 'textures'];
export const mostDials = 426;

/** How many named constants a C++ text defines. @param {string} text */
export function dialsIn(text) {
  const code = text.replace(/\/\/.*$/gm, '');
  const statements = code.matchAll(
    /\b(?:constexpr|const (?:double|float))\b[^;{()]*\bk[A-Z]\w*\s*(?:=|\{)[^;]*;/g);
  return [...statements].reduce((sum, [statement]) =>
    sum + [...statement.matchAll(/\bk[A-Z]\w*\s*(?:=(?!=)|\{)/g)].length, 0);
}

/** The dials of each room of the algorithm. @returns {[string, number][]} */
export function dialsOfRooms() {
  return algorithm.map((room) => [room, filesUnder(`src/${room}`, /\.(h|cpp)$/)
    .reduce((sum, file) => sum + dialsIn(readText(file)), 0)]);
}
