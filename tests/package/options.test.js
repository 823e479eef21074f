// SPDX-License-Identifier: MIT
// The one table of options, and all that is made from it.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import { remesh } from 'remesher';
import {
  checkOptions, defaultOf, inJavaScript, optionTable,
} from 'remesher/options';

import { helpText, parseCommandLine } from '../../dist/cli/cli_arguments.js';
import { instantiate } from '../../dist/worker/engine.js';
import { torus } from '../support/shapes.js';
import { filesUnder, readText } from '../support/tree.js';

const refused = (options, code, pattern) => assert.throws(() => checkOptions(options), (error) => {
  assert.equal(error.code, code);
  assert.match(`${error.message} ${error.hint}`, pattern);
  return true;
});

test('defaults of the table are those of the core', async () => {
  const wasm = await readFile(new URL('../../dist/remesher.wasm', import.meta.url));
  const instance = await instantiate(
    { engine: 'whole', module: await WebAssembly.compile(wasm) });
  const core = instance.defaultOptions();
  // What the core does not know: a preset is options of the table by the time that it is called,
  // units have become numbers, files are compressed after it, and slabs are asked for with a file.
  const outside = ['preset', 'units', 'compress', 'slabs', 'slab'];
  const names = optionTable.map(({ name }) => name).filter((name) => !outside.includes(name));
  assert.deepEqual(Object.keys(core).sort(), names.sort());
  for (const { name, default: value } of optionTable) {
    if (outside.includes(name)) continue;
    if (core[name] !== null) assert.equal(value, core[name], name);
    else assert.ok(value === undefined || value === 'off' || typeof value === 'object', name);
  }
});

test('a default that depends on the scheme is the core’s own: it changes no byte', async () => {
  const byScheme = optionTable.filter(({ default: value }) => typeof value === 'object');
  assert.ok(byScheme.length > 0);
  // A tube of eight sides, so that edges are features to one scheme only.
  const surface = torus({ columns: 60, rows: 8 });
  const positionsWith = async (/** @type {import('remesher').RemeshOptions} */ options) =>
    (await remesh(surface, { vertices: 300, worker: false, ...options })).mesh.positions;
  for (const [scheme, otherScheme] of [['best', 'rounds'], ['rounds', 'best']]) {
    const untold = await positionsWith({ scheme });
    for (const option of byScheme) {
      const { name } = option;
      const [own, other] = [scheme, otherScheme].map((one) => defaultOf(option, one));
      assert.deepEqual(await positionsWith({ scheme, [name]: own }), untold, `${scheme} ${name}`);
      assert.notDeepEqual(await positionsWith({ scheme, [name]: other }), untold,
        `${scheme} ${name}: the shape shows no difference`);
    }
  }
});

test('every default passes its own check', () => {
  for (const option of optionTable) {
    for (const scheme of ['best', 'rounds']) {
      const value = defaultOf(option, scheme);
      if (value !== undefined) checkOptions({ [option.name]: value });
    }
  }
});

test('ranges hold at their ends', () => {
  for (const { name, min, max, above, needs = [{}] } of optionTable) {
    const others = Object.fromEntries(Object.entries(needs[0])
      .map(([other, values]) => [other, values === true ? 1 : values[0]]));
    if (min !== undefined) {
      checkOptions({ ...others, [name]: min });
      refused({ [name]: min - 1 }, 'INVALID_OPTION', new RegExp(`^${name} must be`));
    }
    if (max !== undefined) {
      checkOptions({ ...others, [name]: max });
      if (max < 1000) refused({ [name]: max + 1 }, 'INVALID_OPTION', /must be/);
    }
    if (above !== undefined) refused({ [name]: above }, 'INVALID_OPTION', /above/);
  }
});

test('values of the wrong type are refused', () => {
  refused({ vertices: 10.5 }, 'INVALID_OPTION', /whole number/);
  refused({ vertices: '10' }, 'INVALID_OPTION', /a whole number from 1 to \d+, not '10'/);
  refused({ vertices: Object.create(null) }, 'INVALID_OPTION', /not an object/);
  refused({ ratio: NaN }, 'INVALID_OPTION', /NaN/);
  refused({ scheme: 'fast' }, 'INVALID_OPTION', /best, rounds/);
  refused({ scheme: ['best'] }, 'INVALID_OPTION', /best, rounds, not Array/);
  refused({ scheme: { toString: () => 'best' } }, 'INVALID_OPTION', /not Object/);
  refused({ splitObtuse: 1 }, 'INVALID_OPTION', /true or false/);
  refused({ density: [1, 2] }, 'INVALID_OPTION', /Float32Array/);
  refused({ featureEdges: [[1]] }, 'INVALID_OPTION', /pairs/);
  refused({ featureEdges: new Uint32Array(3) }, 'INVALID_OPTION', /pairs/);
});

test('an unknown name is refused, and the nearest named', () => {
  refused({ vertexes: 3 }, 'UNKNOWN_OPTION', /Did you mean vertices\?/);
  refused({ splitobtuse: true }, 'UNKNOWN_OPTION', /splitObtuse/);
});

/** A value of an option that is not its default; the first of those that are wanted. */
function sample({ type, choices, default: standard, min = 1 }, wanted = true) {
  if (wanted !== true) return wanted[0];
  if (type === 'boolean') return true;
  if (type === 'choice') return choices.find((choice) => choice !== standard);
  if (type === 'shares') return [0.5];
  if (type === 'floats') return new Float32Array(1);
  if (type === 'indices') return [0];
  if (type === 'guides') return [[[0, 0, 0], [1, 0, 0]]];
  return type === 'pairs' ? [[0, 1]] : Math.max(min, 1);
}

const optionNamed = (name) => optionTable.find((option) => option.name === name);

test('an option without what it needs is refused, and the sentence names both', () => {
  const needy = optionTable.filter(({ needs }) => needs);
  assert.ok(needy.length > 5);
  for (const option of needy) {
    const others = Object.keys(option.needs[0]);
    const sentence = new RegExp(`^${option.name} needs ${others[0]}\\b.*\\.$`);
    refused({ [option.name]: sample(option) }, 'INVALID_OPTION', sentence);
    for (const needs of option.needs) {
      const given = Object.entries(needs).map(([name, wanted]) =>
        [name, sample(optionNamed(name), wanted)]);
      checkOptions({ ...Object.fromEntries(given), [option.name]: sample(option) });
    }
  }
});

test('options that exclude each other are refused in a sentence that names both', () => {
  const strict = optionTable.filter(({ excludes }) => excludes);
  assert.ok(strict.length > 3);
  for (const option of strict) {
    for (const [other, wanted] of Object.entries(option.excludes.others)) {
      const own = option.excludes.value ?? sample(option);
      const given = { [option.name]: own, [other]: sample(optionNamed(other), wanted) };
      refused(given, 'INVALID_OPTION',
        new RegExp(`^${option.name}\\b.* and ${other}\\b.* exclude each other: .*\\.$`));
    }
  }
});

test('the sentences are in the words of the caller', () => {
  const flag = (option) => `--${option.name}`;
  const said = (given, label) => {
    try {
      checkOptions(given, label && { label });
    } catch (error) {
      return `${error.message} ${error.hint}`;
    }
    return '';
  };
  assert.equal(said({ sheets: 'drop' }),
    "sheets needs repair: 'wrap', 'solid' or 'auto'. Add repair: 'wrap'.");
  assert.equal(said({ sheets: 'drop' }, flag),
    '--sheets needs --repair wrap, solid or auto. Add --repair wrap.');
  assert.equal(said({ exact: true }), 'exact needs quads: true. Add quads: true.');
  assert.equal(said({ exact: true }, flag), '--exact needs --quads. Add --quads.');
  assert.match(said({ prefer: 'shape', quads: true }, flag), /^--prefer shape and --quads exclude/);
});

test('what is not set does not travel', () => {
  assert.deepEqual(checkOptions({ vertices: undefined, maxError: 'off' }), {});
});

test('arrays are copied into the form the core reads', () => {
  const density = new Float32Array([1, 2]);
  const checked = checkOptions({ density, featureEdges: [[0, 1], [1, 2]] });
  assert.notEqual(checked.density, density);
  assert.deepEqual(checked.density, density);
  assert.deepEqual(checked.featureEdges, new Uint32Array([0, 1, 1, 2]));
});

/** Flags that an option needs beside it. @param {{ needs?: readonly object[] }} option */
const beside = ({ needs: [others] = [{}] }) => Object.entries(others).flatMap(([name, wanted]) => {
  const { flag, type } = optionNamed(name);
  return type === 'boolean' ? [flag] : [flag.split(' ')[0], wanted === true ? '1' : wanted[0]];
});

test('every flag is the kebab case of its name, is parsed, and is in the help', () => {
  for (const option of optionTable.filter(({ flag }) => flag)) {
    const flag = `--${option.name.replace(/[A-Z]/g, (c) => `-${c.toLowerCase()}`)}`;
    assert.equal(option.flag.split(' ')[0], flag);
    assert.ok(helpText().includes(`  ${flag} `) || helpText().includes(`  ${flag}\n`), flag);
    const value = option.choices?.[0] ?? (option.type === 'boolean' ? undefined : '2');
    if (option.name === 'adaptivity') continue; // there is no 2
    const words = ['in.off', '-o', 'out.off', flag, ...(value === undefined ? [] : [value]),
      ...beside(option)];
    assert.ok(option.name in parseCommandLine(words).options, flag);
  }
});

test('a flag may have an alias, which the help shows', () => {
  const aliased = optionTable.filter(({ alias }) => alias);
  assert.ok(aliased.some(({ name }) => name === 'faces'));
  for (const { name, alias } of aliased) {
    assert.equal(parseCommandLine(['a', '-o', 'b.off', alias, '7']).options[name], 7);
    assert.ok(helpText().includes(`, ${alias}`));
  }
});

test('flags take their value as the next word or after =', () => {
  assert.equal(parseCommandLine(['a', '-o', 'b.off', '--ratio', '0.5']).options.ratio, 0.5);
  assert.equal(parseCommandLine(['a', '-o', 'b.off', '--ratio=0.5']).options.ratio, 0.5);
  const { options } = parseCommandLine(['a', '-o', 'b.off', '--feature-angle', 'off']);
  assert.equal(options.featureAngle, 'off');
});

test('sentences name options as programs do in JavaScript, by flags on the command line', () => {
  const sentences = {
    'Thicken them: --sheets thicken.': "Thicken them: sheets: 'thicken'.",
    'Near: --weld 0.001 joins them.': 'Near: weld: 0.001 joins them.',
    'Ask for one of them: --textures, --lods.': 'Ask for one of them: textures, lods.',
    'Ask for a file each: --lod-files.': 'Ask for a file each: lodFiles.',
    'With --prefer shape, or --prefer otherwise.': "With prefer: 'shape', or prefer otherwise.",
    'my--weld 3.obj and --nothing': 'my--weld 3.obj and --nothing',
  };
  for (const [flags, names] of Object.entries(sentences)) assert.equal(inJavaScript(flags), names);
  const cases = [{ holesUpTo: 5, repair: 'solid' }, { lodFiles: true },
    { sheets: 'drop', repair: 'holes' }, { cavities: true, repair: 'wrap' }];
  for (const options of cases) {
    assert.throws(() => checkOptions(options), ({ hint }) => /^Add \w+/.test(hint)
      && !hint.includes('--'));
    const words = Object.entries(options).flatMap(([name, value]) => {
      const flag = optionTable.find((option) => option.name === name).flag.split(' ')[0];
      return value === true ? [flag] : [flag, String(value)];
    });
    assert.throws(() => parseCommandLine(['a.glb', '-o', 'b.glb', ...words]), ({ hint }) =>
      /^Add --[a-z-]+( [a-z]+)?\.$/.test(hint));
  }
});

test('a flag in a sentence of the core is one of the table, so that JavaScript can say its name',
  () => {
    const flags = new Set(optionTable.map(({ flag }) => flag?.split(' ')[0]));
    for (const path of filesUnder('src', /\.cpp$/)) {
      for (const [text] of readText(path).matchAll(/"(?:[^"\\\n]|\\.)*"/g)) {
        for (const [, flag] of text.matchAll(/(?<=^"|[\s(])(--[a-z][a-z-]*)/g)) {
          assert.ok(flags.has(flag), `${path}: ${text}`);
        }
      }
    }
  });

test('npm finds the package by what it does', () => {
  const { keywords } = JSON.parse(readText('package.json'));
  for (const word of ['simplify', 'decimate', 'retopology', 'quad', 'repair', 'watertight', 'lod',
    'bake', '3d-printing', 'three']) assert.ok(keywords.includes(word), word);
  assert.equal(new Set(keywords).size, keywords.length);
});
