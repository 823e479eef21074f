// SPDX-License-Identifier: MIT
// The command line: what it writes and where, and how it fails.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import {
  chmodSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync,
} from 'node:fs';
import promises from 'node:fs/promises';
import { syncBuiltinESMExports } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { parseCommandLine } from '../../dist/cli/cli_arguments.js';
import { errorInWords, exitStatusOf } from '../../dist/cli/terminal.js';
import { referencesOf } from '../../dist/codecs/resources.js';
import { withInput } from '../../dist/files/input.js';
import { root } from '../support/tree.js';
import { offText, torus } from '../support/shapes.js';

const cli = join(root, 'dist/cli/cli.js');
const folder = mkdtempSync(join(tmpdir(), 'remesher-cli-'));
after(() => rmSync(folder, { recursive: true }));

const inFolder = (name) => join(folder, name);
const write = (name, content) => writeFileSync(inFolder(name), content);
const read = (name) => readFileSync(inFolder(name), 'utf8');
const run = (...words) =>
  spawnSync(process.execPath, [cli, ...words], { cwd: folder, encoding: 'utf8' });

/** Fails with this status and one line on standard error that matches; writes nothing. */
function failsWith(status, pattern, ...words) {
  const before = readdirSync(folder).sort();
  const result = run(...words);
  assert.equal(result.status, status, result.stderr);
  assert.equal(result.stdout, '');
  assert.match(result.stderr, /^remesher: [^\n]+\n$/);
  assert.match(result.stderr, pattern);
  assert.deepEqual(readdirSync(folder).sort(), before);
}

const tetrahedron = 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n';
write('torus.off', offText(torus()));

test('a file is remeshed to the exact count; standard output stays empty', () => {
  const { status, stdout, stderr } = run('torus.off', '-o', 'out.off', '--vertices', '700');
  assert.equal(status, 0, stderr);
  assert.equal(stdout, '');
  assert.match(stderr, /output: 1400 triangles, 700 vertices/);
  assert.match(read('out.off'), /^OFF\s+700 1400/);
});

test('where shape was lost it is said, with what keeps more of it', () => {
  const words = (/** @type {string} */ vertices) => run('torus.off', '-o', 'out.off', '--vertices',
    vertices, '--quality', 'draft').stderr;
  assert.match(words('30'), /some shape was lost: more triangles .* --max-error/);
  assert.doesNotMatch(words('1100'), /shape was lost/);
});

test('two bodies become one file; a file that was read is not written over', () => {
  write('tetrahedron.off', tetrahedron);
  const words = ['torus.off', 'tetrahedron.off', '-o', 'both.stl'];
  const { status, stdout, stderr } = run('union', ...words);
  assert.deepEqual([status, stdout], [0, ''], stderr);
  assert.match(stderr, /union, both bodies as one: 0 triangles cut/);
  assert.equal(readFileSync(inFolder('both.stl')).length, 84 + 50 * (4 + 2 * 48 * 24));
  const { boolean, input } = JSON.parse(run('union', ...words, '--json').stdout);
  assert.deepEqual([boolean.operation, input.components], ['union', 2]);
  failsWith(2, /one of the files that were read/, 'union', 'torus.off', 'tetrahedron.off', '-o',
    'tetrahedron.off');
  failsWith(2, /have no volume in common/, 'intersect', ...words.slice(0, 3), 'none.stl');
});

test('--quiet says nothing', () => {
  const { status, stdout, stderr } = run('torus.off', '-o', 'out.off', '--ratio=.5', '--quiet');
  assert.deepEqual([status, stdout, stderr], [0, '', '']);
});

test('--json is the whole report and nothing else on standard output', () => {
  const { status, stdout, stderr } =
    run('torus.off', '-o', 'out.obj', '--vertices', '600', '--scheme', 'rounds', '--json');
  assert.equal(status, 0, stderr);
  assert.equal(stderr, '');
  const report = JSON.parse(stdout);
  assert.deepEqual(Object.keys(report).sort(), ['card', 'chosen', 'diagonal', 'fidelity',
    'input', 'memory', 'output', 'phases', 'prefer', 'stopped', 'timings', 'version', 'warnings']);
  assert.equal(report.output.vertices, 600);
  assert.equal(report.chosen.rule, 'rounds');
  assert.ok(report.fidelity.hausdorff > 0 && report.fidelity.hausdorff < 2);
  assert.ok(report.memory.peakBytes > 0);
});

test('inspect reports, in words and as JSON, and writes nothing', () => {
  const before = readdirSync(folder).sort();
  const words = run('inspect', 'torus.off').stdout;
  assert.match(words, /^input: 2304 triangles, 1152 vertices, 1 component, closed\n/);
  assert.match(words, /\n {2}diagonal of the bounding box: 8\.0\d*, in the file’s own unit\n/);
  const report = JSON.parse(run('inspect', 'torus.off', '--json').stdout);
  assert.equal(report.input.eulerCharacteristic, 0);
  assert.equal(report.output, undefined);
  assert.deepEqual(readdirSync(folder).sort(), before);
});

test('convert changes the format and nothing else', () => {
  const { status, stdout, stderr } = run('convert', 'torus.off', '-o', 'converted.obj');
  assert.deepEqual([status, stdout, stderr], [0, '', '']);
  assert.equal(read('converted.obj').match(/^v /gm).length, 1152);
  assert.equal(read('converted.obj').match(/^f /gm).length, 2304);
  const piped = run('convert', 'converted.obj', '-o', '-', '--format', 'off');
  assert.match(piped.stdout, /^OFF\s+1152 2304/);
  assert.deepEqual(JSON.parse(run('convert', 'torus.off', '-o', 'x.obj', '--json').stdout),
    { warnings: [] });
});

test('- is standard output, in the format asked for', () => {
  const { status, stdout, stderr } =
    run('torus.off', '-o', '-', '--format', 'obj', '--vertices', '200');
  assert.equal(status, 0, stderr);
  assert.equal(stdout.match(/^v /gm).length, 200);
});

test('a reader that closes the pipe early is no failure', async () => {
  const child = spawn(process.execPath, [cli, 'torus.off', '-o', '-', '--format', 'obj'],
    { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });
  child.stdout.destroy();
  const errors = [];
  child.stderr.on('data', (data) => errors.push(data));
  const status = await new Promise((resolve) => child.on('exit', resolve));
  assert.equal(status, 0, Buffer.concat(errors).toString());
});

test('help and version', () => {
  assert.match(run('--help').stdout, /--vertices N/);
  const { version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  assert.equal(run('--version').stdout, `${version}\n`);
});

test('wrong words are named, with what to do', () => {
  failsWith(2, /No input file.*Use:/);
  const isRefused = (pattern, ...words) => assert.throws(() => parseCommandLine(words),
    (error) => exitStatusOf(error) === 2 && pattern.test(errorInWords(error)));
  isRefused(/No output file.*Add -o/, 'torus.off');
  isRefused(/no command reapir.*mean remesher repair/, 'reapir', 'torus.off', '-o', 'x.off');
  isRefused(/no command remesh\..*leave it out/, 'remesh', 'torus.off', '-o', 'x.off');
  isRefused(/two input files, a\.off/, 'a.off', 'torus.off', '-o', 'x.off');
  isRefused(/--edge\b.*Did you mean --edge-length/, 'torus.off', '-o', 'x.off', '--edge', '2');
  isRefused(/--vertexes.*Did you mean --vertices/,
    'torus.off', '-o', 'x.off', '--vertexes', '3');
  isRefused(/--vertices needs a value/, 'torus.off', '-o', 'x.off', '--vertices');
  isRefused(/--vertices must be a whole number.*not 'many'/,
    'torus.off', '-o', 'x.off', '--vertices', 'many');
  isRefused(/--vertices must be .*not 0/, 'torus.off', '-o', 'x.off', '--vertices', '0');
  isRefused(/--gap must be .* above 0, up to 20, or a length like 0\.1mm, not 200/,
    'torus.off', '-o', 'x.off', '--gap', '200');
  isRefused(/--gradation must be a number above 1/, 'torus.off', '-o', 'x.off',
    '--gradation', '1');
  isRefused(/two input files, torus\.off and b\.off/, 'torus.off', 'b.off', '-o', 'x.off');
  isRefused(/--json takes no value/, 'torus.off', '-o', 'x.off', '--json=1');
  isRefused(/exclude each other/, 'torus.off', '-o', 'x.off', '--vertices', '9', '--ratio', '1');
  isRefused(/needs a format/, 'torus.off', '-o', '-');
  isRefused(/--vertices does not belong there/,
    'convert', 'torus.off', '-o', 'x.obj', '--vertices', '9');
  isRefused(/--ratio does not belong there/, 'inspect', 'torus.off', '--ratio', '1');
  isRefused(/--root needs a value/, 'torus.off', '-o', 'x.off', '--root');
  isRefused(/both want standard output/, 'torus.off', '-o', '-', '--format', 'obj', '--json');
  isRefused(/Standard input is not read\. Give a file/, '-', '-o', 'x.off');
});

test('values of the wrong kind are shown as they were written', () => {
  const isRefused = (flag, value) => assert.throws(
    () => parseCommandLine(['torus.off', '-o', 'x.glb', flag, value]),
    (error) => error.message.startsWith(`${flag} must be `)
      && error.message.endsWith(`, not '${value}'.`));
  isRefused('--lods', 'half');
  isRefused('--lods', '0.5,-1');
  isRefused('--lods', '');
  isRefused('--vertices', '');
  isRefused('--format', 'fbx');
});

test('an output’s name tells the format, and nothing else may tell another', () => {
  const isRefused = (pattern, ...words) => assert.throws(() => parseCommandLine(words),
    (error) => exitStatusOf(error) === 2 && pattern.test(errorInWords(error)));
  isRefused(/output result has no extension.* end in \.glb/, 'torus.off', '-o', 'result');
  isRefused(/--format obj and the output x\.glb contradict/,
    'convert', 'torus.off', '-o', 'x.glb', '--format', 'obj');
  assert.equal(parseCommandLine(['a.off', '-o', 'x.GLB', '--format', '.glb']).format, 'glb');
});

test('what new textures are like is not said of those that are kept', () => {
  const parsed = (...words) => parseCommandLine(['a.glb', '-o', 'b.glb', ...words]);
  for (const words of [['--texture-size', '64'], ['--texture-format', 'png']]) {
    const hint = new RegExp(`^${words[0]} .* Add --textures bake\\.`);
    for (const textures of [[], ['--textures', 'keep']]) {
      assert.throws(() => parsed(...words, ...textures),
        (error) => exitStatusOf(error) === 2 && hint.test(errorInWords(error)));
    }
    assert.equal(parsed(...words, '--textures', 'bake').options.textures, 'bake');
  }
});

test('inspect writes no file, and takes one', () => {
  failsWith(2, /inspect writes no file/, 'inspect', 'torus.off', '-o', 'x.off');
  failsWith(2, /inspect writes no file/, 'inspect', 'torus.off', '--format', 'obj');
  failsWith(2, /two input files.* one after the other/, 'inspect', 'torus.off', 'b.off');
});

const badFiles = {
  'empty.off': ['', /empty\.off/],
  'text.glb': ['hello', /text\.glb/],
  'faceless.obj': ['v 0 0 0\nv 1 0 0\nv 0 1 0\n', /faceless\.obj/],
  'nan.obj': ['v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', /nan\.obj/],
  'infinite.off': [tetrahedron.replace('1 0 0', '1e999 0 0'), /infinite\.off/],
  'range.obj': ['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n', /range\.obj/],
  'flat.off': ['OFF\n3 2 0\n0 0 0\n1 0 0\n2 0 0\n3 0 0 1\n3 1 1 2\n', /flat\.off/],
  'short.off': [tetrahedron.slice(0, 60), /short\.off/],
  'odd.xyz': ['1 2 3\n', /odd\.xyz/],
};
for (const [name, [content, pattern]] of Object.entries(badFiles)) {
  test(`${name} is refused in one line, and what was there stays`, () => {
    write(name, content);
    write('kept.off', 'kept');
    failsWith(2, pattern, name, '-o', 'kept.off');
    assert.equal(read('kept.off'), 'kept');
  });
}

test('impossible targets are refused', () => {
  failsWith(2, /3 vertices/, 'torus.off', '-o', 'never.off', '--vertices', '3');
});

test('an input that is not there, or a folder, is refused', () => {
  failsWith(2, /nothere\.off cannot be read: there is no such file/, 'nothere.off', '-o', 'x.off');
  mkdirSync(inFolder('sub'), { recursive: true });
  failsWith(2, /sub cannot be read: it is a folder\. For all .* end in \//, 'sub', '-o', 'x.off');
});

test('a file that may not be read has no wrong name', async (t) => {
  const denied = Object.assign(new Error('denied'), { code: 'EACCES' });
  t.mock.method(promises, 'open', () => Promise.reject(denied));
  syncBuiltinESMExports();
  const error = await withInput(inFolder('torus.off'), async () => {})
    .catch((refusal) => refusal);
  t.mock.restoreAll();
  syncBuiltinESMExports();
  assert.match(errorInWords(error), /torus\.off cannot be read: permission is denied\. \[/);
});

test('an output that cannot be written is refused, and leaves nothing behind', () => {
  failsWith(2, /nowhere.x\.off cannot be written: there is no such file or folder/,
    'torus.off', '-o', 'nowhere/x.off', '--vertices', '100');
  failsWith(2, /odd\.doc/, 'torus.off', '-o', 'odd.doc');
  mkdirSync(inFolder('folder.off'), { recursive: true });
  failsWith(2, /folder\.off cannot be written/, 'torus.off', '-o', 'folder.off',
    '--vertices', '100');
  assert.deepEqual(readdirSync(inFolder('folder.off')), []);
});

test('what lies beside the input is read, and the result brings its own', () => {
  mkdirSync(inFolder('beside'), { recursive: true });
  write('beside/m.mtl', 'newmtl red\nKd 1 0 0\n');
  const faces = [...tetrahedron.matchAll(/^3 (\d) (\d) (\d)$/gm)]
    .map(([, ...corners]) => `f ${corners.map((c) => Number(c) + 1).join(' ')}`);
  const places = tetrahedron.split('\n').slice(2, 6).map((line) => `v ${line}`);
  write('beside/t.obj', ['mtllib m.mtl', ...places, 'usemtl red', ...faces, ''].join('\n'));
  mkdirSync(inFolder('out'), { recursive: true });
  const { status, stderr } =
    run('beside/t.obj', '-o', 'out/t.obj', '--vertices', '40', '--scheme', 'rounds');
  assert.equal(status, 0, stderr);
  assert.match(read('out/t.obj'), /^usemtl red$/m);
  const [, library] = read('out/t.obj').match(/^mtllib (.+)$/m);
  assert.match(read(`out/${library}`), /newmtl red/);
});

test('references are found in every format that has them', () => {
  const bytes = (text) => new TextEncoder().encode(text);
  const json = '{"buffers":[{"uri":"a.bin"},{"uri":"data:,"},{}],"images":[{"uri":"b c.png"}]}';
  assert.deepEqual(referencesOf('x.gltf', bytes(json)), ['a.bin', 'b c.png']);
  const glb = new Uint8Array(20 + json.length);
  const view = new DataView(glb.buffer);
  view.setUint32(0, 0x46546c67, true);
  view.setUint32(12, json.length, true);
  glb.set(bytes(json), 20);
  assert.deepEqual(referencesOf('x.GLB', glb), ['a.bin', 'b c.png']);
  assert.deepEqual(referencesOf('x.obj', bytes('mtllib a b.mtl \r\nv 0 0 0\n')),
    ['a b.mtl', 'a', 'b.mtl']);
  const blanks = ' '.repeat(1_000_000); // would take an hour if it took time squared
  assert.deepEqual(referencesOf('x.obj', bytes(`mtllib a${blanks}b${blanks}\n${blanks}`)),
    [`a${blanks}b`, 'a', 'b']);
  assert.deepEqual(referencesOf('x.obj', bytes('mtllib \nmtllib\n mtllib\ta.mtl\r')), ['a.mtl']);
  assert.deepEqual(referencesOf('x.mtl', bytes('map_Kd -s 1 2 3 -o .5 -clamp on -mm 0 1 a b.png\r\n'
    + 'map_Bump no.png\n norm n.png\nmap_Ke -s\nmap_Ke\n')), ['a b.png', 'n.png']);
  assert.deepEqual(referencesOf('x.gltf', bytes('{')), []);
  // The bytes decide, not the name.
  assert.deepEqual(referencesOf('x.off', bytes(json)), ['a.bin', 'b c.png']);
});

test('the command can be run as it is', () => {
  chmodSync(cli, 0o755);
  assert.ok(existsSync(cli));
  assert.equal(spawnSync(cli, ['--version']).status, 0);
});
