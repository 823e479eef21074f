// SPDX-License-Identifier: MIT
// The named constants of the core. Their number is printed by `npm run figures` and has no limit.
import { coreRooms } from './rooms.js';
import { filesUnder, readText } from './tree.js';

/** The named constants that a C++ text defines. @param {string} text @returns {string[]} */
export function constantsIn(text) {
  const code = text.replace(/\/\/.*$/gm, '');
  const statements = code.matchAll(
    /\b(?:constexpr|const (?:double|float))\b[^;{()]*\bk[A-Z]\w*\s*(?:=|\{)[^;]*;/g);
  return [...statements].flatMap(([statement]) =>
    [...statement.matchAll(/\b(k[A-Z]\w*)\s*(?:=(?!=)|\{)/g)].map(([, name]) => name));
}

/**
 * A C++ text in which a named constant has another value; nothing if it does not define this
 * constant exactly once.
 * @param {string} text @param {string} name @param {string} value as C++ writes it
 */
export function withConstant(text, name, value) {
  if (constantsIn(text).filter((one) => one === name).length !== 1) return undefined;
  const definition = new RegExp(
    `^([^/\\n]*\\b${name}\\s*=\\s*)[^,;]*|^([^/\\n]*\\b${name}\\{)[^}]*`, 'm');
  return text.replace(definition, (_, assigned, braced) => `${assigned ?? braced}${value}`);
}

/** The number of constants in each room of the core. @returns {[string, number][]} */
export function constantsOfRooms() {
  const rooms = [...new Set(Object.keys(coreRooms).map((room) => room.split('/')[0]))];
  return rooms.filter((room) => room !== '')
    .map((room) => [room, filesUnder(`src/${room}`, /\.(h|cpp)$/)
      .reduce((sum, file) => sum + constantsIn(readText(file)).length, 0)]);
}
