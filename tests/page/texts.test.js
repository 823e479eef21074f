// SPDX-License-Identifier: MIT
// The page's words: none missing in any language, none left over, the same gaps to fill in each.
import assert from 'node:assert/strict';
import { basename } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { optionTable } from 'remesher/options';

import { errorCodes } from '../../bindings/package/base/errors.js';

import en from '../../web/texts/en.js';
import { withWords } from '../../web/words_in_place.js';
import { filesUnder, readText, root } from '../support/tree.js';

const others = filesUnder('web/texts', /\.js$/)
  .filter((file) => !/\/(en|(options|diagnostics)\/\w+)\.js$/.test(file));
const textsOf = async (file) => (await import(pathToFileURL(`${root}/${file}`))).default;

const inForm = optionTable.filter(({ flag, form }) => flag && form !== false);

/** What English has in the package's own table. */
const ofOptions = [
  ...inForm.flatMap(({ name }) => [`option.${name}`, `help.${name}`]),
  ...new Set(inForm.flatMap(({ unit }) => (unit ? [`unit.${unit}`] : []))),
];

const diagnostics = 'src/base/diagnostics.cpp';
const coreText = filesUnder('src', /\.(h|cpp)$/).filter((path) => path !== diagnostics)
  .map(readText).join('\n');
const found = (pattern) => [...new Set([...coreText.matchAll(pattern)].map(([, name]) => name))];

/** Of what the core says in English: codes of warnings have two words, attributes end in digits. */
const codes = found(/"([A-Z]+(?:_[A-Z]+)+)",\s*(?:\n\s*)?["*a-zA-Z]/g)
  .filter((code) => !errorCodes.includes(code));
const warnings = [...readText(diagnostics).matchAll(/"([A-Z_]+)", Severity::/g)]
  .map(([, code]) => code);

/** The reasons of the chooser's rules, but for rows that leave the mesh that is there. */
const rules = found(/\bRule\{\s*Decision::\w+,\s*"([\w-]+)"/g)
  .filter((name) => name !== 'as-made');

const ofMessages = [...rules.map((name) => `chosen.${name}`),
  ...warnings.map((code) => `warning.${code}`),
  ...errorCodes.map((code) => `fault.${code}`)];

/** The names in braces. */
const gaps = (text) => [...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name).sort();

test('there are other languages than English, and the page knows each', () => {
  assert.ok(others.length >= 2);
  const known = readText('web/base/i18n.js');
  const strange = others.filter((file) => !known.includes(`texts/${basename(file)}'`));
  assert.deepEqual(strange, []);
});

for (const file of others) {
  test(`${file} has every text and every option, and nothing else`, async () => {
    const texts = await textsOf(file);
    const wanted = [...Object.keys(en), ...ofOptions, ...ofMessages];
    const missing = wanted.filter((key) => !(key in texts));
    const left = Object.keys(texts).filter((key) => !wanted.includes(key));
    assert.deepEqual({ missing, left }, { missing: [], left: [] });
    for (const [key, text] of Object.entries(texts)) assert.ok(text.trim(), key);
  });

  test(`${file} fills the same gaps as English`, async () => {
    const texts = await textsOf(file);
    for (const key of Object.keys(en)) assert.deepEqual(gaps(texts[key]), gaps(en[key]), key);
  });
}

test('the table of diagnostics has the codes of all warnings, sorted, and no others', () => {
  assert.ok(codes.includes('NON_MANIFOLD_EDGES_SPLIT') && codes.includes('PARTS_MERGED'));
  assert.deepEqual(warnings, codes.sort());
});

test('every phase of a run has a name', () => {
  const made = filesUnder('bindings/package/textures', /\.js$/).map(readText).join('\n');
  const phases = [...found(/\bphase\("([^"]+)"/g),
    ...[...made.matchAll(/#tell\('([^']+)'/g)].map(([, name]) => name)];
  assert.ok(phases.includes('lower Hausdorff') && phases.includes('encode images'));
  assert.deepEqual(Object.keys(en).filter((key) => key.startsWith('phase.')).sort(),
    phases.map((phase) => `phase.${phase}`).sort());
});

test('every text of the page itself is there, and every text is used', () => {
  withWords(readText('web/index.html'));  // throws for one that is not
  const sources = filesUnder('web', /\.(js|html)$/).filter((file) => !file.includes('/texts/'))
    .map(readText).join('\n');
  const isMade = (key) => [...sources.matchAll(/`(\w[\w.-]*\.)\$\{/g)]
    .some(([, beginning]) => key.startsWith(beginning));
  const unused = Object.keys(en)
    .filter((key) => !sources.includes(`'${key}'`) && !sources.includes(`"${key}"`)
      && !isMade(key));
  assert.deepEqual(unused, []);
});

test('words are written into the page, and a missing one stops the build', () => {
  assert.equal(withWords('<p class="a" data-text="open"></p>'),
    `<p class="a" data-text="open">${en.open}</p>`);
  assert.equal(withWords('<a data-label="fit"></a>'),
    `<a data-label="fit" aria-label="${en.fit}"></a>`);
  assert.throws(() => withWords('<p data-text="no.such"></p>'), /no\.such/);
});

test('no text has words that only we understand, in any language and in the help', async () => {
  const insiders = new RegExp(['Algorithm(?:us|e)? 2', 'θ', 'valen[cz]', 'pass(?:es|ed)? through',
    'durchdring', 'traversent d’autres', 'Follow the options', 'scraps', '\\bmend'].join('|'), 'i');
  const texts = [...Object.entries(en), ...(await Promise.all(others.map(textsOf)))
    .flatMap(Object.entries), ...optionTable.map(({ name, help }) => [name, help])];
  assert.deepEqual(texts.filter(([, text]) => insiders.test(text)), []);
});
