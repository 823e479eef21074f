// SPDX-License-Identifier: MIT
// Which C++ files can be compiled as one: most of what a tool does to a file it does to the
// headers, which files in company share.
import { withIncludes } from './cpp_sources.js';
import { readText } from './tree.js';

const mostFiles = 70;

/** The names that a file gives to things outside of functions and classes; not to their members. */
export function definedNames(text) {
  const head = /^(?!namespace|using namespace|template|TEST_CASE|#|\/|\})(\w[^(={;[\n]*)[(={;[]/gm;
  const first = [...text.matchAll(head)]
    .map(([, words]) => words.match(/(?<!::|\w)(\w+)\s*$/)?.[1]).filter(Boolean);
  const constants = [...text.matchAll(/^(?:constexpr|const|static|inline)\b[^;]*;/gm)]
    .flatMap(([all]) => [...all.matchAll(/(\w+) = /g)].map(([, name]) => name));
  return [...new Set([...first, ...constants])];
}

/** The types that our headers in a file define, which none of its company may have for itself. */
function typesInHeaders(/** @type {string} */ file) {
  const headers = withIncludes(file).filter((part) => part.endsWith('.h'));
  return headers.flatMap((part) => [...readText(part)
    .matchAll(/^(?:struct|class|enum class|enum) (\w+)[^;]*?\{/gm)].map(([, name]) => name));
}

const share = (/** @type {Set<string>} */ taken, /** @type {string[]} */ names) =>
  names.some((name) => taken.has(name));

/**
 * The files in groups, in which no two define one name, and none defines what a header of another
 * does. A file with macros of its own stays alone, since it may want headers read in its own way.
 * @param {readonly string[]} files
 * @param {(file: string) => string} [read]
 * @param {(file: string) => string[]} [inHeaders]
 * @returns {string[][]}
 */
export function inCompany(files, read = readText, inHeaders = typesInHeaders) {
  const alone = [];
  const groups = [];
  for (const file of files) {
    const text = read(file);
    if (/^#define/m.test(text)) {
      alone.push([file]);
      continue;
    }
    const own = definedNames(text);
    const others = inHeaders(file).filter((name) => !own.includes(name));
    let group = groups.find(({ members, taken, seen }) => members.length < mostFiles
      && !share(taken, own) && !share(taken, others) && !share(seen, own));
    if (!group) groups.push(group = { members: [], taken: new Set(), seen: new Set() });
    group.members.push(file);
    for (const name of own) group.taken.add(name);
    for (const name of others) group.seen.add(name);
  }
  return [...alone, ...groups.map(({ members }) => members)];
}
