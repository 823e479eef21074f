// SPDX-License-Identifier: MIT
// Which C++ files can be compiled as one: most of what a tool does to a file it does to the
// headers, which files in company share.
import { withIncludes } from './cpp_sources.js';
import { readText } from './tree.js';

const mostFiles = 70;

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
    const name = words.match(/(?<!::|\w)(\w+)\s*$/)?.[1];
    if (!name || !all.endsWith('(')) return name ?? [];
    return `${name}(${parameterTypes(text.slice(index + all.length))})`;
  });
  const constants = [...text.matchAll(/^(?:constexpr|const|static|inline)\b[^;]*;/gm)]
    .flatMap(([all]) => [...all.matchAll(/(\w+) = /g)].map(([, name]) => name));
  return [...new Set([...first, ...constants])];
}

/** The types that our headers in a file define, which none of its company may have for itself. */
export function typesInHeaders(/** @type {string} */ file) {
  const headers = withIncludes(file).filter((part) => part.endsWith('.h'));
  return headers.flatMap((part) => [...readText(part)
    .matchAll(/^(?:struct|class|enum class|enum) (\w+)[^;]*?\{/gm)].map(([, name]) => name));
}

/** The constants within a file's functions, which would hide those that its company has outside. */
export function innerConstants(/** @type {string} */ text) {
  return [...text.matchAll(/^ +(?:static )?constexpr [^=;]*?\b(k[A-Z]\w*) = /gm)]
    .map(([, name]) => name);
}

const share = (/** @type {Set<string>} */ taken, /** @type {string[]} */ names) =>
  names.some((name) => taken.has(name));

/**
 * The files in groups, in which no two define one name, and none defines what another has within.
 * A file with macros of its own stays alone, since it may want headers read in its own way.
 * @param {readonly string[]} files
 * @param {(file: string) => string} [read]
 * @param {(file: string) => string[]} [within]
 * @returns {string[][]}
 */
export function inCompany(files, read = readText, within = typesInHeaders) {
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
    let group = groups.find(({ members, taken, seen }) => members.length < mostFiles
      && !share(taken, own) && !share(taken, others) && !share(seen, own));
    if (!group) groups.push(group = { members: [], taken: new Set(), seen: new Set() });
    group.members.push(file);
    for (const name of own) group.taken.add(name);
    for (const name of others) group.seen.add(name);
  }
  return [...alone, ...groups.map(({ members }) => members)];
}
