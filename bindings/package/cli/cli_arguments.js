// SPDX-License-Identifier: MIT
// Parses the command line by the option table, and makes the help from it.

import { extname } from 'node:path';

import { RemeshError } from '../base/errors.js';
import { formats, inWords } from '../base/formats.js';
import { legible } from '../base/legible.js';
import { lengthFrom, pixelsFrom, takesLength } from '../base/lengths.js';
import { nearest } from '../base/nearest.js';
import { isFolder } from './plan.js';
import {
  bakeNames, checkOptions, checkOwn, checkValue, convertNames, defaultInWords, optionTable,
  repairNames, unwrapNames,
} from '../base/options.js';

/** @typedef {import('../base/messages.js').BooleanOperation} BooleanOperation */
/** @typedef {import('../base/options.js').Option} Option */

/**
 * @typedef {object} CommandLine
 * @property {'remesh' | 'convert' | 'repair' | 'inspect' | 'bake' | 'unwrap' | BooleanOperation
 *   | 'help' | 'version'}
 *   command
 * @property {string[]} inputs one, or the two of a Boolean, unless the output is a folder
 * @property {string} onto the file that remesher bake paints onto
 * @property {string} output
 * @property {string} format for output to '-' and to a folder
 * @property {string} card the file for the report card; empty: none
 * @property {string | undefined} root the folder below which a model may name other files
 * @property {boolean} force
 * @property {boolean} skipExisting
 * @property {number} jobs how many at once; 0: as many as there are cores
 * @property {boolean} json
 * @property {boolean} quiet
 * @property {string | undefined} guides the file that option guides comes from
 * @property {Record<string, unknown>} options
 */

/** The flags that are the command line's own. */
const ownFlags = [
  { flag: '-o, --output FILE', help: 'where to write; - is standard output' },
  { flag: '--onto FILE',
    help: 'of remesher bake: the model that is painted; it keeps its triangles' },
  { flag: '--format F', help: `${inWords(formats)}: the format written to - or to a folder` },
  { flag: '--root DIR', help: 'the folder below which a model may name other files (default: '
    + 'the model’s own)' },
  { flag: '--card FILE.md', help: 'write a page on the run: what was before and after' },
  { flag: '--jobs N', help: 'many files: so many at once (default: the cores)' },
  { flag: '--force', help: 'replace files beside the output, and of many files the results, that '
    + 'are there already' },
  { flag: '--skip-existing', help: 'many files: leave out those whose results are there' },
  { flag: '--json', help: 'the report, and nothing else, on standard output' },
  { flag: '--quiet', help: 'no progress bar, no report in words' },
  { flag: '-h, --help', help: 'this text' },
  { flag: '--version', help: 'the version' },
];

/** `--vertices` of '--vertices N'. @param {Option} option */
function flagOf(option) {
  return option.flag?.split(' ')[0];
}

const tableFlags = new Map(optionTable.flatMap((option) => {
  const flags = [flagOf(option), option.alias].filter((flag) => flag !== undefined);
  return flags.map((flag) => /** @type {const} */ ([flag, option]));
}));
const valueFlags = ['-o', '--output', '--onto', '--format', '--card', '--root', '--jobs'];
const plainFlags = ['--force', '--skip-existing', '--json', '--quiet', '-h', '--help', '--version'];

/** @param {string} message @param {string} [hint] */
function wrongUse(message, hint = 'remesher --help lists the options.') {
  return new RemeshError('INVALID_OPTION', message, hint);
}

/** @param {Option} option @param {string} text */
function valueFrom(option, text) {
  const numberOf = (/** @type {string} */ word) => (word.trim() === '' ? NaN : Number(word));
  const isNumber = (option.type === 'integer' || option.type === 'number') && text !== option.word
    && !(takesLength(option) && lengthFrom(text));
  const shareOf = (/** @type {string} */ word) => (pixelsFrom(word) ? word.trim() : numberOf(word));
  const value = option.type === 'shares' ? text.split(',').map(shareOf)
    : isNumber ? numberOf(text) : text;
  checkValue(option, value, String(flagOf(option)), Number.isFinite(value) ? value : text);
  return value;
}

/** @param {string} flag */
function unknownFlag(flag) {
  const meant = nearest(flag, [...tableFlags.keys(), ...valueFlags, ...plainFlags]);
  return new RemeshError('UNKNOWN_OPTION', `There is no option ${legible(flag)}.`,
    meant ? `Did you mean ${meant}?` : 'remesher --help lists the options.');
}

/**
 * Splits `--flag=value`, and gives each flag the word that follows if it needs one.
 * @param {readonly string[]} words
 */
function* tokens(words) {
  for (let i = 0; i < words.length; i += 1) {
    const word = words[i];
    if (word === '-' || !word.startsWith('-')) {
      yield { flag: '', value: word };
      continue;
    }
    const [, flag, inline] = /^(--?[^=]*)(?:=(.*))?$/s.exec(word) ?? [];
    const option = tableFlags.get(flag);
    const isPlain = plainFlags.includes(flag) || option?.type === 'boolean';
    if (!isPlain && !option && !valueFlags.includes(flag)) throw unknownFlag(flag);
    if (isPlain && inline !== undefined) throw wrongUse(`${flag} takes no value.`);
    const value = isPlain ? '' : inline ?? words[(i += 1)];
    if (value === undefined) throw wrongUse(`${flag} needs a value.`);
    yield { flag, value };
  }
}

/** @param {string} text */
function jobsFrom(text) {
  const jobs = Number(text);
  if (Number.isInteger(jobs) && jobs >= 1 && jobs <= 1024) return jobs;
  throw wrongUse(`--jobs must be a whole number from 1 to 1024, not '${legible(text)}'.`);
}

/** @param {string} text */
function formatFrom(text) {
  const name = text.replace(/^\./, '').toLowerCase();
  const format = formats.find((known) => known === name);
  if (format) return format;
  throw wrongUse(`--format must be ${inWords(formats)}, not '${legible(text)}'.`);
}

/** The lines themselves are read with the model. @param {CommandLine} line @param {string} file */
function setGuides(line, file) {
  line.guides = file;
  line.options.guides = [];
}

/** @param {CommandLine} line @param {string} flag @param {string} value */
function setOwn(line, flag, value) {
  if (flag === '-o' || flag === '--output') line.output = value;
  if (flag === '--onto') line.onto = value;
  if (flag === '--format') line.format = formatFrom(value);
  if (flag === '--card') line.card = value;
  if (flag === '--root') line.root = value;
  if (flag === '--jobs') line.jobs = jobsFrom(value);
  if (flag === '--force') line.force = true;
  if (flag === '--skip-existing') line.skipExisting = true;
  if (flag === '--json') line.json = true;
  if (flag === '--quiet') line.quiet = true;
  if (flag === '-h' || flag === '--help') line.command = 'help';
  if (flag === '--version') line.command = 'version';
}

const commands = /** @type {const} */ (
  ['convert', 'repair', 'inspect', 'bake', 'unwrap', 'union', 'subtract', 'intersect']);

/** @param {string} command @returns {command is BooleanOperation} */
export function isBoolean(command) {
  return ['union', 'subtract', 'intersect'].includes(command);
}

/** @param {CommandLine} line @param {readonly string[]} names */
function setNames(line, names) {
  const command = commands.find((name) => name === names[0]);
  const inputs = command ? names.slice(1) : names;
  if (line.command === 'help' || line.command === 'version') return;
  if (inputs.length === 0) {
    throw wrongUse('No input file is given.', 'Use: remesher <input> -o <output> [options]');
  }
  if (inputs.includes('-')) {
    throw wrongUse('Standard input is not read.', 'Give a file, or /dev/stdin.');
  }
  line.inputs = [...inputs];
  if (command) line.command = command;
}

/** @param {string} word @param {string} meant a command, or remesh */
function unknownCommand(word, meant) {
  return wrongUse(`There is no command ${legible(word)}.`,
    meant === 'remesh' ? 'To remesh, leave it out: remesher <input> -o <output> [options]'
      : `Did you mean remesher ${meant}?`);
}

/** @param {CommandLine} line */
function checkInputs({ command, inputs, output, skipExisting, jobs }) {
  if (isBoolean(command)) {
    checkOperands({ command, inputs, output });
    checkAlone({ skipExisting, jobs });
    return;
  }
  const [first, second] = inputs;
  if (command !== 'inspect' && isFolder(output)) return;
  if (second !== undefined) {
    const meant = extname(first) === '' && nearest(first, [...commands, 'remesh']);
    if (meant) throw unknownCommand(first, meant);
    throw wrongUse(`There are two input files, ${legible(first)} and ${legible(second)}.`,
      command === 'inspect' ? 'Inspect one after the other.'
        : 'Name the output with -o <output>; for many files let it end in /.');
  }
  checkAlone({ skipExisting, jobs });
}

/** @param {Pick<CommandLine, 'skipExisting' | 'jobs'>} line */
function checkAlone({ skipExisting, jobs }) {
  if (skipExisting || jobs > 0) {
    throw wrongUse(`${jobs > 0 ? '--jobs' : '--skip-existing'} is for many files.`,
      'Let the output end in /.');
  }
}

/** @param {CommandLine} line */
function checkCard({ command, card, output }) {
  if (card === '' || command === 'help' || command === 'version') return;
  if (command !== 'remesh' && command !== 'repair') {
    throw wrongUse(`remesher ${command} has no --card: only remeshing and repair write one.`);
  }
  if (isFolder(output)) {
    throw wrongUse('--card takes a single input file.', 'With --json each has its card.');
  }
  if (!/\.(md|markdown|txt)$/i.test(card)) {
    throw wrongUse(`The card ${legible(card)} is a text.`, 'Let it end in .md.');
  }
}

/** @param {Pick<CommandLine, 'command' | 'inputs' | 'output'>} line */
function checkOperands({ command, inputs, output }) {
  const use = `Use: remesher ${command} <a> <b> -o <output>`;
  if (inputs.length !== 2) {
    throw wrongUse(`remesher ${command} takes two input files, not ${inputs.length}.`, use);
  }
  if (isFolder(output)) {
    throw wrongUse(`remesher ${command} writes one file, and ${legible(output)} is a folder.`, use);
  }
}

/** The name of a single output tells the format. @param {CommandLine} line */
function checkName({ output, format }) {
  const extension = extname(output).slice(1).toLowerCase();
  if (extension === '') {
    throw wrongUse(`The output ${legible(output)} has no extension, which would tell the format.`,
      `Let it end in .${format || 'glb'}, say; or in /, for many files.`);
  }
  if (format !== '' && format !== extension) {
    throw wrongUse(`--format ${format} and the output ${legible(output)} contradict each other.`,
      `Let it end in .${format}, or leave out --format.`);
  }
}

/** @param {Pick<CommandLine, 'command' | 'inputs' | 'onto' | 'output'>} line */
function checkOnto({ command, inputs, onto, output }) {
  const use = 'Use: remesher bake <high> --onto <low> -o <output>';
  if (command !== 'bake') {
    if (onto !== '') throw wrongUse('--onto is for remesher bake.', use);
    return;
  }
  if (onto === '') throw wrongUse('remesher bake needs the model to paint onto.', use);
  if (inputs.length > 1) {
    throw wrongUse(`remesher bake takes one model to paint from, not ${inputs.length}.`, use);
  }
  if (isFolder(output)) {
    throw wrongUse(`remesher bake writes one file, and ${legible(output)} is a folder.`, use);
  }
}

/** The names of the options that a command takes; undefined: all but those of single commands.
 * @param {CommandLine} line */
function namesOf({ command }) {
  if (command === 'bake') return bakeNames;
  return command === 'unwrap' ? unwrapNames : undefined;
}

/** @param {CommandLine} line */
function checkOutput(line) {
  const foreign = optionTable.find(({ name }) => line.options[name] !== undefined);
  if (foreign && isBoolean(line.command)) {
    throw wrongUse(`remesher ${line.command} does not remesh: ${flagOf(foreign)} does not belong `
      + 'there.');
  }
  const unfit = optionTable.find(({ name }) => line.options[name] !== undefined
    && !(line.command === 'convert' && convertNames.some((own) => own === name)));
  if (unfit && (line.command === 'convert' || line.command === 'inspect')) {
    throw wrongUse(`remesher ${line.command} changes no triangles: ${flagOf(unfit)} does not `
      + 'belong there.');
  }
  const alien = optionTable.find(({ name }) =>
    line.options[name] !== undefined && !repairNames.some((own) => own === name));
  if (alien && line.command === 'repair') {
    throw wrongUse(`remesher repair does not remesh: ${flagOf(alien)} does not belong there.`);
  }
  if (line.command === 'inspect' && line.output + line.format !== '') {
    throw wrongUse('remesher inspect writes no file.', 'Leave out -o and --format.');
  }
  if (['inspect', 'help', 'version'].includes(line.command)) return;
  if (line.output === '') throw wrongUse('No output file is given.', 'Add -o <output>.');
  if (line.output === '-' && line.format === '') {
    throw wrongUse('Output to - needs a format.', `Add --format ${inWords(formats)}.`);
  }
  if (line.output === '-' && line.json) {
    throw wrongUse('--json and -o - both want standard output.', 'Write to a file instead.');
  }
  if (line.output !== '-' && !isFolder(line.output)) checkName(line);
}

/** @param {readonly string[]} words @returns {CommandLine} */
export function parseCommandLine(words) {
  /** @type {CommandLine} */
  const line = {
    command: 'remesh', inputs: [], onto: '', output: '', format: '', card: '', root: undefined,
    force: false, skipExisting: false, jobs: 0, json: false, quiet: false, guides: undefined,
    options: {},
  };
  const names = [];
  for (const { flag, value } of tokens(words)) {
    const option = tableFlags.get(flag);
    if (option?.type === 'guides') setGuides(line, value);
    else if (option?.type === 'boolean') line.options[option.name] = true;
    else if (option) line.options[option.name] = valueFrom(option, value);
    else if (flag === '') names.push(value);
    else setOwn(line, flag, value);
  }
  setNames(line, names);
  checkOnto(line);
  if (line.command === 'repair') line.options.repair ??= 'auto';
  checkOutput(line);
  if (line.inputs.length > 0) checkInputs(line);
  checkCard(line);
  const label = (/** @type {Option} */ option) => flagOf(option) ?? option.name;
  const own = namesOf(line);
  if (own) {
    line.options = checkOwn(line.options,
      { names: own, others: [], what: `remesher ${line.command}`, label });
    return line;
  }
  const checked = checkOptions(line.options, { label });
  if (line.options.preset === undefined) line.options = checked;
  return line;
}

/** @param {string} flag @param {string} text */
function helpRow(flag, text) {
  const indent = ' '.repeat(26);
  const lines = [''];
  for (const word of text.split(' ')) {
    const last = lines.length - 1;
    if (`${lines[last]} ${word}`.length > 72) lines.push(word);
    else lines[last] = `${lines[last]} ${word}`.trim();
  }
  return `  ${flag.padEnd(23)} ${lines.join(`\n${indent}`)}`;
}

/** @param {Option} option */
function optionHelp(option) {
  const flag = option.choices
    ? `${flagOf(option)} ${option.choices.join('|')}`
    : `${option.flag}${option.alias ? `, ${option.alias}` : ''}`
      + `${option.word ? `|${option.word}` : ''}`;
  const value = option.type === 'boolean' ? '' : defaultInWords(option);
  const shown = value && ` (default: ${value})`;
  const length = takesLength(option) ? ', or a length like 0.1mm' : '';
  const unit = option.unit ? `; ${option.unit}${length}` : '';
  const text = `${option.help}${unit}${shown}`;
  return flag.length > 22 ? `  ${flag}\n${helpRow('', text)}` : helpRow(flag, text);
}

/** Headings of the help, by the option that each stands before. */
const headings = /** @type {Record<string, string>} */ ({ preset: 'For a purpose:',
  vertices: 'How many, and how long:', scheme: 'Triangles, and how near they are:', quads: 'Quads:',
  textures: 'Textures:', repair: 'Repair:', lods: 'Levels of detail, and size of files:' });

export function helpText() {
  const rows = optionTable.filter(({ flag }) => flag).flatMap((option) => [
    ...(headings[option.name] ? ['', headings[option.name]] : []), optionHelp(option)]);
  return [
    'remesher horse.obj -o horse.glb --vertices 10000       exactly so many vertices',
    'remesher figure.glb -o small.glb --preset asset --faces 5000',
    'remesher repair scan.stl -o closed.stl                 for printing; nothing else changes',
    'remesher part.stl -o mesh.msh --preset simulation --units mm --edge-length 2mm',
    'remesher head.obj -o quads.obj --preset quads --faces 3000',
    '',
    'remesher <input> -o <output> [options]     remesh a file',
    'remesher repair <input> -o <output>        only repair it, as --repair says',
    'remesher convert <input> -o <output>       only change the format',
    'remesher union|subtract|intersect <a> <b> -o <output>',
    '                                           both bodies, a without b, or their common part',
    'remesher bake <high> --onto <low> -o <output>',
    '                                           paint one model onto another, as .glb or .gltf',
    'remesher unwrap <input> -o <output>        new texture coordinates only',
    'remesher <inputs> -o <folder>/ [options]   many files, folders, patterns like scans/*.obj',
    'remesher inspect <input> [--json]          report on a file, change nothing',
    '',
    `The formats follow the extensions: ${formats.map((name) => `.${name}`).join(' ')};`,
    'each is read from a .gz too.',
    ...rows,
    '',
    'The command line:',
    ...ownFlags.map(({ flag, help }) => helpRow(flag, help)),
    '',
    'Exit status: 0 done; 2 the arguments or the file are at fault; 1 our fault.',
    '',
  ].join('\n');
}
