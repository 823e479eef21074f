// SPDX-License-Identifier: MIT
// What a person sees who hovers over the package's functions and options in an editor.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, describe, test } from 'node:test';

import {
  bakeNames, defaultOf, inJavaScript, optionTable, rangeInWords, repairNames,
} from 'remesher/options';

import { Editor } from '../../support/editor.js';
import { readText, root } from '../../support/tree.js';

/** Each function's parameters and what it gives, as a program would have to know them. */
const functions = {
  init: 'init(options?: InitOptions): Promise<void>',
  remesh: 'remesh(mesh: Mesh, options?: RemeshOptions & RunOptions): Promise<RemeshResult>',
  remeshScene: 'remeshScene(parts: PlacedMesh[], options?: RemeshOptions & RunOptions): '
    + 'Promise<RemeshSceneResult>',
  remeshFile: 'remeshFile(bytes: Bytes, options?: RemeshOptions & FileOptions & OutputOptions '
    + '& RunOptions): Promise<RemeshFileResult>',
  repair: 'repair(mesh: Mesh, options?: RepairOptions & RunOptions): Promise<RepairResult>',
  repairFile: 'repairFile(bytes: Bytes, options?: RepairOptions & FileOptions & OutputOptions '
    + '& RunOptions): Promise<RepairFileResult>',
  boolean: 'boolean(a: Mesh, b: Mesh, operation: BooleanOperation, options?: RunOptions): '
    + 'Promise<BooleanResult>',
  booleanFiles: 'booleanFiles(a: Bytes, b: Bytes, operation: BooleanOperation, '
    + 'options?: OperandOptions & OutputOptions & RunOptions): Promise<BooleanFilesResult>',
  bake: 'bake(high: Mesh, low: Mesh, options?: BakeOptions & RunOptions): Promise<BakeResult>',
  bakeFile: 'bakeFile(high: Bytes, low: Bytes, options?: BakeOptions & BakeFileOptions & '
    + 'OutputOptions & RunOptions): Promise<AtlasFileResult>',
  unwrap: 'unwrap(mesh: Mesh, options?: UnwrapOptions & RunOptions): Promise<UnwrapResult>',
  unwrapFile: 'unwrapFile(bytes: Bytes, options?: UnwrapOptions & FileOptions & OutputOptions & '
    + 'RunOptions): Promise<AtlasFileResult>',
  convertFile: 'convertFile(bytes: Bytes, options?: ConvertOptions & FileOptions & OutputOptions '
    + '& RunOptions): Promise<ConvertFileResult>',
  inspect: 'inspect(bytesOrMesh: Bytes | Mesh, options?: InspectOptions & FileOptions & '
    + 'RunOptions): Promise<Inspection>',
};

const program = [
  `import { ${Object.keys(functions).join(', ')} } from 'remesher';`,
  ...Object.keys(functions).map((name) => `${name};`),
  'remesh({ positions: new Float32Array(9), indices: new Uint32Array(3) }, {',
  ...optionTable.map(({ name }) => `  ${name}: undefined,`),
  '  signal: undefined,',
  '  onProgress: undefined,',
  '  worker: undefined,',
  '});',
  '',
].join('\n');

/** A value of an option, as TypeScript. */
function valueOf({ type, choices, min, above }) {
  if (choices) return `'${choices[0]}'`;
  const values = { boolean: 'true', shares: '[0.5]', floats: 'new Float32Array(3)',
    pairs: '[[0, 1]]', indices: '[0, 1]',
    guides: "[{ points: [[0, 0, 0], [1, 0, 0]], kind: 'direction' }]" };
  return values[type] ?? String(min ?? above + 1);
}

const mesh = '{ positions: new Float32Array(9), indices: new Uint32Array(3) }';
const bytes = 'new Uint8Array(9)';
const ofRun = { signal: 'new AbortController().signal', onProgress: '({ phase, fraction }) => '
  + '{ phase.trim(); fraction.toFixed(); }', worker: 'false' };
const ofFile = { name: "'a.obj'", resources: `{ 'a.mtl': ${bytes} }` };
const ofOutput = { output: "'glb'" };
const ofTable = Object.fromEntries(optionTable.map((option) => [option.name, valueOf(option)]));
const ofRepair = Object.fromEntries(repairNames.map((name) => [name, ofTable[name]]));
const ofBake = Object.fromEntries(bakeNames.map((name) => [name, ofTable[name]]));
const source = { wasmUrl: "'a.wasm'", wasmBinary: 'new ArrayBuffer(8)' };

/** Per function what it takes before its options, and each option with a value. */
const takes = {
  init: ['', { ...source, arrays: "{ wasmUrl: 'b.wasm' }" }],
  remesh: [mesh, { ...ofTable, ...ofRun }],
  remeshScene: [`[{ mesh: ${mesh} }]`, { ...ofTable, ...ofRun }],
  remeshFile: [bytes, { ...ofTable, ...ofRun, ...ofFile, ...ofOutput }],
  repair: [mesh, { ...ofRepair, ...ofRun }],
  repairFile: [bytes, { ...ofRepair, ...ofRun, ...ofFile, ...ofOutput }],
  boolean: [`${mesh}, ${mesh}, 'union'`, ofRun],
  booleanFiles: [`${bytes}, ${bytes}, 'subtract'`, { nameA: "'a.obj'", nameB: "'b.stl'",
    resourcesA: `{ 'a.mtl': ${bytes} }`, resourcesB: '{}', ...ofRun, ...ofOutput }],
  bake: [`${mesh}, ${mesh}`, { ...ofBake, ...ofRun }],
  bakeFile: [`${bytes}, ${bytes}`, { ...ofBake, ...ofRun, ...ofFile, ...ofOutput,
    nameLow: "'b.obj'", resourcesLow: '{}' }],
  unwrap: [mesh, { textureSize: ofTable.textureSize, ...ofRun }],
  unwrapFile: [bytes, { textureSize: ofTable.textureSize, ...ofRun, ...ofFile, ...ofOutput }],
  convertFile: [bytes, { ...ofRun, ...ofFile, ...ofOutput, compress: "'draco'", units: "'in'" }],
  inspect: [bytes, { faults: 'true', edges: 'false', ...ofRun, ...ofFile }],
};

/** A call with each option of each function. */
const calls = Object.entries(takes).flatMap(([name, [first, options]]) =>
  Object.entries(options).flatMap(([option, value]) => ['', 'pool.'].map((owner) =>
    `${owner}${name}(${first}${first && ', '}{ ${option}: ${value} });`)));

/** What the compiler says of these lines, in place of the program. */
function compiled(folder, lines) {
  writeFileSync(join(folder, 'program.ts'), [
    `import { ${Object.keys(functions).join(', ')} } from 'remesher';`,
    "import { Pool } from 'remesher/pool';", 'const pool = new Pool();', ...lines].join('\n'));
  return spawnSync(process.execPath,
    [join(root, 'node_modules/typescript-7/bin/tsc'), '--noEmit', '-p', folder],
    { encoding: 'utf8', timeout: 120_000 });
}

/** Where a line of the program begins with these characters. */
function placeOf(beginning) {
  const line = program.split('\n').findIndex((text) => text.trim().startsWith(beginning));
  return { line, character: program.split('\n')[line].indexOf(beginning) + 1 };
}

/** Words as they are read, however an editor breaks its lines. */
const flat = (text) => text.replace(/\s+/g, ' ');

/** Calls with all options at once. */
const whole = Object.entries(takes).map(([name, [first, options]]) =>
  `${name}(${first}${first && ', '}{ ${Object.entries(options).map((pair) => pair.join(': '))
    .join(', ')} });`);

/** An option may be undefined, whatever the settings. */
const undecided = Object.entries(takes).map(([name, [first, options]]) =>
  `${name}(${first}${first && ', '}{ ${Object.keys(options).map((key) => `${key}: undefined`)
    .join(', ')} });`);

const settings = {
  'nodenext, in Node': { module: 'nodenext', exactOptionalPropertyTypes: true,
    lib: ['es2022'], types: ['node'], typeRoots: [join(root, 'node_modules/@types')] },
  'nodenext, in browsers': { module: 'nodenext', customConditions: ['browser'] },
  'bundler, in Node': { module: 'esnext', moduleResolution: 'bundler', customConditions: ['node'] },
  'bundler, in browsers': { module: 'esnext', moduleResolution: 'bundler' },
};

test('Node and browsers are given the same functions', async () => {
  const [inNode, inBrowsers] = await Promise.all(
    [import('remesher'), import('../../../dist/index.js')]);
  assert.deepEqual(Object.keys(inNode), Object.keys(inBrowsers));
  assert.deepEqual(Object.keys(inNode).sort(), [...Object.keys(functions), 'RemeshError'].sort());
  const arrays = await Promise.all([import('remesher/arrays'), import('../../../dist/arrays.js')]);
  assert.deepEqual(...arrays.map((module) => Object.keys(module)));
  assert.deepEqual(Object.keys(arrays[0]).filter((name) => !(name in inNode)), []);
});

/** A folder of a program that uses the package. @param {object} options of the compiler */
function folderWith(options) {
  const folder = mkdtempSync(join(tmpdir(), 'remesher-types-'));
  mkdirSync(join(folder, 'node_modules'));
  symlinkSync(root, join(folder, 'node_modules/remesher'));
  writeFileSync(join(folder, 'package.json'), '{ "type": "module" }');
  writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify({
    compilerOptions: { strict: true, target: 'es2022', lib: ['es2022', 'dom'], types: [],
      ...options },
  }));
  return folder;
}

for (const [name, options] of Object.entries(settings)) {
  describe(name, async () => {
    const folder = folderWith(options);
    const file = join(folder, 'program.ts');
    writeFileSync(file, program);
    const editor = await Editor.open(folder);
    editor.show(file, program);
    after(() => {
      editor.close();
      rmSync(folder, { recursive: true });
    });

    test('a function shows its parameters by name, and what it does', async () => {
      for (const [word, signature] of Object.entries(functions)) {
        const shown = flat(await editor.hover(file, placeOf(`${word};`)));
        assert.ok(shown.includes(`function ${signature}`), shown);
        assert.doesNotMatch(shown, /import\(/);
        const documented = new RegExp(`\\/\\*\\*\\n((?: \\*.*\\n)+)export function ${word}\\(`)
          .exec(readText('bindings/package/index.js'));
        const [first] = documented[1].replace(/^ \* ?/gm, '').split('\n\n');
        assert.ok(shown.includes(flat(first).trim()), shown);
        assert.match(shown, /@param `\w+` — \S.*@returns — \S/);
      }
    });

    test('an option shows its text, range, unit and default', async () => {
      for (const option of optionTable) {
        const shown = flat(await editor.hover(file, placeOf(`${option.name}:`)));
        assert.ok(shown.includes(`RemeshOptions.${option.name}?: `), shown);
        const expected = [inJavaScript(option.help).slice(1), rangeInWords(option).slice(1),
          option.unit ?? ''];
        for (const words of expected) assert.ok(shown.includes(words), `${words}: ${shown}`);
        for (const choice of option.choices ?? []) assert.ok(shown.includes(`"${choice}"`), shown);
        for (const scheme of ['best', 'rounds']) {
          const value = defaultOf(option, scheme);
          if (value === undefined) assert.doesNotMatch(shown, /@default/);
          else assert.match(shown, new RegExp(`@default.*${value}`));
        }
      }
    });

    test('each option of each function compiles, alone and with all others, and no other', () => {
      const { status, stdout } = compiled(folder, [...calls, ...whole, ...undecided]);
      assert.equal(status, 0, stdout);
      assert.match(compiled(folder, [`repair(${mesh}, { vertices: 9 });`]).stdout,
        /'vertices' does not exist/);
      writeFileSync(file, program);
    });

    test('what belongs to the call shows its text', async () => {
      assert.match(await editor.hover(file, placeOf('signal')), /AbortSignal[^]*AbortError/);
      assert.match(await editor.hover(file, placeOf('onProgress')), /ProgressEvent[^]*progress of/);
      assert.match(await editor.hover(file, placeOf('worker')), /boolean[^]*calling thread/);
    });
  });
}
