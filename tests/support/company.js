// SPDX-License-Identifier: MIT
// Which C++ files can be compiled as one: most of what a tool does to a file it does to the
// headers, which files in company share.
import { dirname } from 'node:path';

import { includeFolders, withIncludes } from './cpp_sources.js';
import { readText } from './tree.js';

/** More would be no faster, and take much memory. */
const mostFiles = 140;

/**
 * Of a function's parameters the types; those that a literal is taken for are one.
 * @param {string} text from behind the parenthesis
 */
function parameterTypes(text) {
  return text.slice(0, text.indexOf(')')).split(/,(?![^<]*>)/)
    .map((one) => one.replace(/ = .*/s, '').trim().replace(/(?<=[\s&*>])\w+$/, ''))
    .map((type) => type.replace(/\s+/g, ' ').trim())
    .map((type) => type.replace(/^(const )?std::string(_view)?&?$/, 'text')).join();
}

/**
 * The names that a file gives to things outside of functions and classes; not to their members.
 * Functions go by their parameters, too: with other ones they are others.
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
 * A file with other names for what it keeps to itself, so that all of its company may use the same.
 * What it says as a member's name, too, keeps it.
 * @param {string} file @param {string} text
 * @param {string} headers what it includes of ours: names that are there are not its own
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

/** Its text for company; elsewhere a file would not find what it includes from beside it. */
export function textInCompany(/** @type {string} */ file) {
  const text = readText(file);
  const isBound = /^#include "[^/"]+"/m.test(text) && !includeFolders.includes(dirname(file));
  const headers = () => withIncludes(file).filter((part) => part !== file).map(readText).join();
  return isBound ? text : renamed(file, text, headers());
}

/** What our headers in a file define, which none of its company may have for itself: types, and
 * functions by their parameters. */
export function namesInHeaders(/** @type {string} */ file) {
  const headers = withIncludes(file).filter((part) => part.endsWith('.h')).map(readText);
  return headers.flatMap((text) => {
    const types = text.matchAll(/^(?:struct|class|enum class|enum) (\w+)[^;]*?\{/gm);
    const functions = text.match(/^inline [^;{]*/gm) ?? [];
    return [...[...types].map(([, name]) => name),
      ...functions.flatMap(definedNames).filter((name) => name.endsWith(')'))];
  });
}

/** The constants within a file's functions, which would hide those that its company has outside. */
export function innerConstants(/** @type {string} */ text) {
  return [...text.matchAll(/^ +(?:static )?constexpr [^=;]*?\b(k[A-Z]\w*) = /gm)]
    .map(([, name]) => name);
}

const share = (/** @type {Set<string>} */ taken, /** @type {string[]} */ names) =>
  names.some((name) => taken.has(name));

/**
 * The files in groups of like size, in which no two define one name, and none defines what another
 * has within. A file with macros of its own stays alone, since it may want headers read in its own
 * way.
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
