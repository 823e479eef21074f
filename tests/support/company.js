// SPDX-License-Identifier: MIT
// Which C++ files can be compiled as one: most of what a tool does to a file it does to the
// headers, which files in company share.
import { readText } from './tree.js';

const mostFiles = 14;

/** The names that a file gives to things outside of functions and classes. */
export function definedNames(text) {
  const head = /^(?!namespace|using namespace|template|TEST_CASE|#|\/|\})(\w[^(={;[\n]*)[(={;[]/gm;
  const first = [...text.matchAll(head)]
    .map(([, words]) => words.match(/(\w+)\s*$/)?.[1]).filter(Boolean);
  const constants = [...text.matchAll(/^(?:constexpr|const|static|inline)\b[^;]*;/gm)]
    .flatMap(([all]) => [...all.matchAll(/(\w+) = /g)].map(([, name]) => name));
  return [...new Set([...first, ...constants])];
}

/**
 * The files in groups, in which no two define one name. A file with macros of its own stays alone,
 * since it may want headers read in its own way.
 * @param {readonly string[]} files
 * @param {(file: string) => string} [read]
 * @returns {string[][]}
 */
export function inCompany(files, read = readText) {
  const alone = [];
  const groups = [];
  for (const file of files) {
    const text = read(file);
    if (/^#define/m.test(text)) {
      alone.push([file]);
      continue;
    }
    const names = definedNames(text);
    let group = groups.find(({ members, taken }) => members.length < mostFiles
      && !names.some((name) => taken.has(name)));
    if (!group) groups.push(group = { members: [], taken: new Set() });
    group.members.push(file);
    for (const name of names) group.taken.add(name);
  }
  return [...alone, ...groups.map(({ members }) => members)];
}
