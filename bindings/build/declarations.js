// SPDX-License-Identifier: MIT
// TypeScript declarations that tsc does not read from the sources: the type of the options is made
// from their table, so that an editor shows each option's row.

import {
  defaultInWords, inJavaScript, optionTable, rangeInWords,
} from '../package/base/options.js';
import { takesLength, units } from '../package/base/lengths.js';

/** @typedef {import('../package/base/options.js').Option} Option */

/** @type {Record<Option['type'], string>} */
const plainTypes = {
  integer: 'number',
  number: 'number',
  boolean: 'boolean',
  choice: 'string',
  shares: 'readonly number[] | Float64Array | readonly `${number}px`[]',
  floats: 'Float32Array',
  indices: 'Uint32Array | readonly number[]',
  pairs: 'Uint32Array | ReadonlyArray<readonly [number, number]>',
  guides: 'ReadonlyArray<GuideOrLine>',
};

const lengthType = `\`\${number}\${${units.map((unit) => `'${unit}'`).join(' | ')}}\``;

/** @param {Option} option */
function typeOf(option) {
  if (option.choices) return option.choices.map((choice) => `'${choice}'`).join(' | ');
  return plainTypes[option.type] + (takesLength(option) ? ` | ${lengthType}` : '')
    + (option.word ? ` | '${option.word}'` : '');
}

/** Adds a full stop, and a capital unless a name or a sign comes first. @param {string} text */
const sentence = (text) => `${text.replace(/^[a-z]+(?!:)\b/, capitalized)}.`;

/** @param {string} word */
const capitalized = (word) => word[0].toUpperCase() + word.slice(1);

/** A value as JavaScript source. @param {unknown} value */
const spelled = (value) => (typeof value === 'string' ? `'${value}'` : String(value));

/** The lines that an editor shows: text, range and unit, default. @param {Option} option */
export function documentationOf(option) {
  const unit = option.unit ? `, in ${option.unit}` : '';
  const value = defaultInWords(option, spelled);
  return [sentence(inJavaScript(option.help)), '', sentence(rangeInWords(option) + unit),
    ...(value ? ['', `@default \`${value}\``] : [])];
}

/** The text of base/remesh_options.d.ts. */
export function optionDeclarations() {
  const members = optionTable.map((option) => [
    '  /**',
    ...documentationOf(option).map((line) => `   * ${line}`.trimEnd()),
    '   */',
    `  ${option.name}?: ${typeOf(option)} | undefined;`,
  ].join('\n'));
  return [
    '// SPDX-License-Identifier: MIT',
    '// Made of the table in options.js.',
    '',
    "import type { GuideOrLine } from './guides.js';",
    '',
    '/** What to make of a mesh. Every option may be left out. */',
    'export interface RemeshOptions {',
    members.join('\n\n'),
    '}',
    '',
  ].join('\n');
}

/**
 * Replaces aliases of an `import()` by plain imports. An alias would hide the type behind it from
 * editors and from the reference.
 * @param {string} text as tsc writes it
 */
export function withPlainImports(text) {
  return text.replace(/^export type (\w+) = import\((['"].+['"])\)\.\1;$/gm,
    'import type { $1 } from $2;\nexport type { $1 };');
}

/** What only the library of browsers declares, in words of every library. */
const ofBrowsers = Object.entries({ BufferSource: 'ArrayBuffer | ArrayBufferView',
  'WebAssembly.Module': 'object', Worker: 'object' });

/**
 * Programs without the library of browsers can be compiled with these declarations, and under
 * `exactOptionalPropertyTypes` an option may be undefined, as it may when the program runs.
 * @param {string} text as tsc writes it
 */
export function withPlainTypes(text) {
  return text.split('\n').map((line) => {
    if (/^\s*(\/\*\*|\*)/.test(line)) return line;
    const plain = ofBrowsers.reduce((words, [name, type]) =>
      words.replace(new RegExp(`(?<=: |=> |<)${name}\\b`, 'g'), type), line);
    return plain.replace(/^(\s+\w+\?: )(.*);$/, (whole, name, type) => {
      if (/ \| undefined$/.test(type)) return whole;
      return `${name}${type.includes('=>') ? `(${type})` : type} | undefined;`;
    });
  }).join('\n');
}

/** A text, escaped for a cell of a Markdown table. @param {string} text */
const cell = (text) => text.replaceAll('|', '\\|');

/** @param {Option} option */
function optionRow(option) {
  const { name, flag, help, unit } = option;
  const value = defaultInWords(option, spelled);
  const range = rangeInWords(option) + (unit ? `, in ${unit}` : '');
  return [`\`${name}\``, flag ? `\`${flag}\`` : '', help, range, value && `\`${value}\``].map(cell);
}

/** The table of options as a page of the reference. */
export function optionsPage() {
  const rows = [
    ['option', 'command line', 'meaning', 'values', 'default'],
    Array.from({ length: 5 }, () => '---'),
    ...optionTable.map(optionRow),
  ];
  return [
    '---', 'title: Options', '---', '', '# Options', '',
    'In JavaScript they are properties of {@link RemeshOptions}. Where two values are given, the',
    'second holds with the scheme `rounds`.', '',
    ...rows.map((row) => `| ${row.join(' | ')} |`), '',
  ].join('\n');
}
