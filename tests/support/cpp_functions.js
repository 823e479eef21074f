// SPDX-License-Identifier: MIT
// The functions that a C++ source defines: name, line, lines and parameters. There is no parser:
// braces are counted, in code formatted by clang-format (a space before a body, none before an
// initializer).

/** The text with comments, literals and directives blanked; every line keeps its place. */
function bare(text) {
  const comment = /\/\/.*|\/\*[^]*?\*\//;
  const literal = /R"\([^]*?\)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'/;
  const directive = /^#(?:.*\\\n)*.*/;
  const noise = [comment, literal, directive].map(({ source }) => source).join('|');
  return text.replace(/(?<=\d)'(?=\d)/g, '_')
    .replace(new RegExp(noise, 'gm'), (part) => part.replace(/[^\n]/g, ' '));
}

/** The position at which the bracket that opens at `open` closes. */
function closing(text, open) {
  const pairs = { '{': '}', '(': ')' };
  let depth = 0;
  for (let i = open; i < text.length; i += 1) {
    if (text[i] === text[open]) depth += 1;
    else if (text[i] === pairs[text[open]]) depth -= 1;
    if (depth === 0) return i;
  }
  return text.length;
}

/** Number of items of a list: commas inside brackets of any kind do not separate items. */
function itemsIn(list) {
  if (list.trim() === '') return 0;
  let depth = 0;
  let items = 1;
  for (const [i, letter] of [...list].entries()) {
    const isArrow = letter === '>' && list[i - 1] === '-';
    if ('([{<'.includes(letter)) depth += 1;
    else if (')]}>'.includes(letter) && !isArrow) depth -= 1;
    else if (letter === ',' && depth === 0) items += 1;
  }
  return items;
}

/** The name and number of parameters of the function that a head declares; undefined if none. */
function signature(head) {
  const named = /(operator\s*(?:\(\)|\w+|[^\s\w(]+)|[\w~]+)\s*\(/g;
  const noNames = /^(?:decltype|noexcept|alignas|requires|void|bool|int|double)$/;
  for (const match of head.matchAll(named)) {
    if (noNames.test(match[1])) continue;
    const open = match.index + match[0].length - 1;
    return { name: match[1], parameters: itemsIn(head.slice(open + 1, closing(head, open))) };
  }
  return undefined;
}

/** The kind of block that a brace after this head opens. */
function kindOf(head) {
  if (/^\s*(?:inline )?namespace\b|^\s*extern\b/.test(head)) return 'scope';
  const outside = head.replace(/\([^]*\)/, '()');
  if (/[\w>]$/.test(head) || / =\s*$| = /.test(outside)) return 'initializer';
  if (/\b(?:class|struct|union|enum)\b/.test(head) && !outside.includes('(')) return 'scope';
  return 'function';
}

/**
 * @param {string} text
 * @returns {{ name: string, line: number, lines: number, parameters: number }[]} in their order
 */
export function cppFunctions(text) {
  const code = bare(text);
  const lineOf = (place) => code.slice(0, place).split('\n').length;
  const functions = [];
  let start = 0;
  for (let i = 0; i < code.length; i += 1) {
    if (code[i] === '(') {
      i = closing(code, i);
    } else if (code[i] === ';' || code[i] === '}') {
      start = i + 1;
    } else if (code[i] === '{') {
      start += /^\s*(?:public|private|protected):|/.exec(code.slice(start, i))[0].length;
      const head = code.slice(start, i);
      const kind = kindOf(head);
      const found = kind === 'function' && signature(head);
      const end = kind === 'scope' ? i : closing(code, i);
      if (found) {
        const line = lineOf(start + code.slice(start).search(/\S/));
        functions.push({ ...found, line, lines: lineOf(end) - line + 1 });
      }
      if (kind !== 'initializer') start = end + 1;
      i = end;
    }
  }
  return functions;
}
