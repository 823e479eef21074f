// SPDX-License-Identifier: MIT
// Finds groups ("companies") of C++ files that can be compiled as one. A tool spends most of its
// time on the headers, which the files of a company share.
import { dirname } from 'node:path';

import { includeFolders, withIncludes } from './cpp_sources.js';
import { readText } from './tree.js';

/** Larger groups would be no faster, and take much memory. */
const mostFiles = 140;

/**
 * The types of a function's parameters. Types that the same literal can stand for count as one.
 * @param {string} text from behind the parenthesis
 */
function parameterTypes(text) {
  return text.slice(0, text.indexOf(')')).split(/,(?![^<]*>)/)
    .map((one) => one.replace(/ = .*/s, '').trim().replace(/(?<=[\s&*>])\w+$/, ''))
    .map((type) => type.replace(/\s+/g, ' ').trim())
    .map((type) => type.replace(/^(const )?std::string(_view)?&?$/, 'text')).join();
}

/**
 * The names that a file defines outside functions and classes, without members. A function's name
 * includes its parameters' types, so that overloads differ.
 */
export function definedNames(text) {
  const head = /^(?!namespace|using namespace|template|TEST_CASE|#|\/|\})(\w[^(={;[\n]*)[(={;[]/gm;
  const first = [...text.matchAll(head)].flatMap(({ 0: all, 1: words, index }) => {
    const name = words.replace(/ : .*/, '').match(/(?<!::|\w)(\w+)\s*$/)?.[1];
    if (!name || !all.endsWith('(')) return name ?? [];
    return `${name}(${parameterTypes(text.slice(index + all.length))})`;
  });
  const constants = [...text.matchAll(/^(?:constexpr|const|static|inline)\b[^;]*;/gm)]
    .flatMap(([all]) => [...all.matchAll(/(\w+) = /g)].map(([, name]) => name));
  return [...new Set([...first, ...constants])];
}

/**
 * A file's text with its private names made unique, so that other files of the company may use the
 * same names. A name that the file also uses as a member's is not changed.
 * @param {string} file @param {string} text
 * @param {string} headers text of our headers that it includes: names in them are not private
 */
export function renamed(file, text, headers) {
  const shared = new Set([...headers.matchAll(/\w+/g), ...text.matchAll(/(?<=\.|->|::)\w+/g)]
    .map(([word]) => word));
  const own = definedNames(text).map((name) => name.replace(/\(.*/s, ''))
    .filter((name) => !shared.has(name));
  if (own.length === 0) return text;
  const place = file.replace(/\.cpp$/, '').split(/\W|_/)
    .map((word) => word.charAt(0).toUpperCase() + word.slice(1)).join('');
  return text.replace(new RegExp(`(?<!^#.*)\\b(${own.join('|')})\\b`, 'gm'), `$1Of${place}`);
}

/** A file's text for its company. A file that includes another from its own folder stays as it is,
 * because a copy elsewhere would not find the other. */
export function textInCompany(/** @type {string} */ file) {
  const text = readText(file);
  const isBound = /^#include "[^/"]+"/m.test(text) && !includeFolders.includes(dirname(file));
  const headers = () => withIncludes(file).filter((part) => part !== file).map(readText).join();
  return isBound ? text : renamed(file, text, headers());
}

/** Names that our headers in a file define, and that no other file of its company may define:
 * types, and functions with their parameters' types. */
export function namesInHeaders(/** @type {string} */ file) {
  const headers = withIncludes(file).filter((part) => part.endsWith('.h')).map(readText);
  return headers.flatMap((text) => {
    const types = text.matchAll(/^(?:struct|class|enum class|enum) (\w+)[^;]*?\{/gm);
    const functions = text.match(/^inline [^;{]*/gm) ?? [];
    return [...[...types].map(([, name]) => name),
      ...functions.flatMap(definedNames).filter((name) => name.endsWith(')'))];
  });
}

/** The constants within a file's functions, which would hide constants outside functions in other
 * files of its company. */
export function innerConstants(/** @type {string} */ text) {
  return [...text.matchAll(/^ +(?:static )?constexpr [^=;]*?\b(k[A-Z]\w*) = /gm)]
    .map(([, name]) => name);
}

const share = (/** @type {Set<string>} */ taken, /** @type {string[]} */ names) =>
  names.some((name) => taken.has(name));

/**
 * Puts the files into groups of similar size. In a group no two files define the same name, and no
 * file defines a name that another has within. A file that defines macros stays alone, because its
 * macros may change how headers are read.
 * @param {readonly string[]} files
 * @param {(file: string) => string} [read]
 * @param {(file: string) => string[]} [within]
 * @returns {string[][]}
 */
export function inCompany(files, read = textInCompany, within = namesInHeaders) {
  const wanted = Math.ceil(files.length / mostFiles);
  const alone = [];
  const groups = [];
  for (const file of files) {
    const text = read(file);
    if (/^#define/m.test(text)) {
      alone.push([file]);
      continue;
    }
    const own = definedNames(text);
    const others = within(file).filter((name) => !own.includes(name));
    const fitting = groups.filter(({ members, taken, seen }) => members.length < mostFiles
      && !share(taken, own) && !share(taken, others) && !share(seen, own));
    let group = fitting.find(({ members }) => members.length < files.length / wanted)
      ?? (groups.length < wanted ? undefined : fitting[0]);
    if (!group) groups.push(group = { members: [], taken: new Set(), seen: new Set() });
    group.members.push(file);
    for (const name of own) group.taken.add(name);
    for (const name of others) group.seen.add(name);
  }
  return [...alone, ...groups.map(({ members }) => members)];
}
