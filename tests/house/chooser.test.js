// SPDX-License-Identifier: MIT
// src/README.md lists the rows by which a mesh is chosen, in their order: the list is the table's.
//   node tests/house/chooser.test.js --print   prints the list
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { filesUnder, readText } from '../support/tree.js';

/** `simplifiedNearer` → `simplified nearer` @param {string} name */
const inWords = (name) => name.replace(/(?<=.)([A-Z])/g, ' $1').toLowerCase();

/** The rows of the table in chooser.cpp. */
function rows() {
  const source = readText('src/remesh/schemes/chooser.cpp').replaceAll(/"\s+"/g, '');
  const [decided, taken] = [/Decision::(\w+),\s*"([\w-]+)"/, /Candidate::(\w+),\s*"(.*?)"/];
  const row =
    new RegExp(`Rule\\{\\s*${decided.source},\\s*\\{(.*?)\\},\\s*${taken.source}\\}`, 'gs');
  return [...source.matchAll(row)].map(([, decision, name, when, candidate, reason]) => ({
    decision: inWords(decision),
    name,
    when: [...when.matchAll(/(is|no)\(Fact::(\w+)\)/g)]
      .map(([, how, fact]) => (how === 'no' ? 'not ' : '') + inWords(fact)).join('; '),
    mesh: inWords(candidate),
    reason,
  }));
}

const list = () => ['| decision | rule | taken if | mesh | reason in the report |',
  '|---|---|---|---|---|', ...rows().map(({ decision, name, when, mesh, reason }) =>
    `| ${decision} | \`${name}\` | ${when} | ${mesh} | ${reason} |`)].join('\n');

if (process.argv.includes('--print')) console.log(list());

test('the list of rules in src/README.md is the table of the chooser', () => {
  assert.equal(rows().length, readText('src/remesh/schemes/chooser.cpp').match(/\bRule\{/g).length);
  assert.ok(readText('src/README.md').includes(list()),
    'node tests/house/chooser.test.js --print prints the list');
});

test('the owner of a decision answers each fact that its rows ask for, and no other', () => {
  /** @type {Map<string, string[]>} by file */
  const decided = new Map();
  for (const file of filesUnder('src', /(?<!schemes\/chooser)\.cpp$/)) {
    const decisions = [...readText(file).matchAll(/\bchoose\(\s*Decision::(\w+)/g)];
    if (decisions.length > 0) decided.set(file, decisions.map(([, name]) => inWords(name)));
  }
  assert.deepEqual([...decided.values()].flat().sort(),
    [...new Set(rows().map(({ decision }) => decision))].sort(), 'each has one owner');
  for (const [file, decisions] of decided) {
    const asked = rows().filter(({ decision }) => decisions.includes(decision))
      .flatMap(({ when }) => when.split('; ').map((fact) => fact.replace(/^not /, '')));
    const answered = [...readText(file).matchAll(/\bFact::(\w+)/g)]
      .map(([, fact]) => inWords(fact));
    assert.deepEqual([...new Set(answered)].sort(),
      [...new Set(asked)].filter(Boolean).sort(), file);
  }
});
