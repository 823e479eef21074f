// SPDX-License-Identifier: MIT
// Foreign text in messages: short, and nothing that a terminal obeys. The core is held to the same
// cases in tests/unit/base/legible_test.cpp.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { convertFile, inspect, remesh, remeshFile } from 'remesher';

import { legible } from '../../dist/base/legible.js';
import { carriers } from '../support/attacks.js';
import { offText, torus } from '../support/shapes.js';

test('what can be read stays as it is', () => {
  for (const text of ['', 'wood.png', 'a b/ä-日本.obj', 'C:\\x', '🦊 %20', '~^`']) {
    assert.equal(legible(text), text);
  }
  assert.equal(legible('x'.repeat(120)), 'x'.repeat(120));
});

test('what a terminal obeys is spelled out', () => {
  const cases = {
    '\x1b[2J': '\\u{1b}[2J',
    'a\r\nb\tc': 'a\\u{d}\\u{a}b\\u{9}c',
    '\0end': '\\u{0}end',
    '\x7f': '\\u{7f}',
    '\x9b': '\\u{9b}',
    'gnp.\u202e': 'gnp.\\u{202e}',
    '\ufeff': '\\u{feff}',
    '\u{e0041}': '\\u{e0041}',
    '\ud800': '\\u{d800}',
  };
  for (const [text, shown] of Object.entries(cases)) assert.equal(legible(text), shown);
});

test('of a long text the two ends are shown', () => {
  for (const length of [121, 500, 5000, 1_000_000]) {
    const shown = legible(`begin${'x'.repeat(length - 9)}.png`);
    assert.equal(shown.length, 120);
    assert.match(shown, /^beginx+…x+\.png$/);
  }
  // What is spelled out is long as it is shown.
  for (const length of [31, 100, 100_000]) assert.equal(legible('\0'.repeat(length)).length, 120);
});

const nasty = `\x1b]0;title\x07\r\n\u202e${'x'.repeat(50_000)}`;
const bytesOf = (text) => new TextEncoder().encode(text);
const mesh = { positions: new Float32Array(9), indices: new Uint32Array(3) };

/** Each way in which text from outside can come into a message. */
const ways = {
  'the name of a file': () => remeshFile(bytesOf('hello'), { name: `${nasty}.off` }),
  'the name of a file that is empty': () => inspect(new Uint8Array(), { name: nasty }),
  'the name of an output': () => remeshFile(bytesOf(offText(torus())),
    { name: 'a.off', output: `${nasty}.doc` }),
  'the word of an OFF': () => inspect(bytesOf(`OFF\n1 1 0\n${nasty.replace('\r\n', '')}`),
    { name: 'a.off' }),
  'the word of an OBJ': () => inspect(bytesOf(`v 0 0 ${nasty.replace('\r\n', '')}`),
    { name: 'a.obj' }),
  'the corner of a face': () => inspect(bytesOf(`v 0 0 0\nf 1x${nasty.replace('\r\n', '')}`),
    { name: 'a.obj' }),
  'the keyword of a PLY': () => inspect(
    bytesOf(`ply\nformat ascii 1.0\n${nasty.replace('\r\n', '')}\nend_header\n`),
    { name: 'a.ply' }),
  'a URI': () => inspect(carriers['buffer.gltf'](nasty), { name: 'a.gltf' }),
  'the URI of something compressed': () => inspect(bytesOf(JSON.stringify({ asset: {},
    extensionsUsed: ['KHR_draco_mesh_compression'], buffers: [{ uri: nasty }] })),
  { name: 'a.gltf' }),
  'the name of an option': () => remesh(mesh, { [nasty]: 1 }),
  'the name of an option of a file': () => inspect(bytesOf(''), { [nasty]: 1 }),
  'the value of an option': () => remesh(mesh, { scheme: nasty }),
  'an attribute': () => remesh({ ...mesh, attributes: { [nasty]: 1 } }),
  'a resource': () => inspect(bytesOf('OFF'), { name: 'a.off', resources: { [nasty]: 1 } }),
};

/** @param {string} text */
function assertLegible(text) {
  assert.ok(text.length < 500, `${text.length} characters`);
  // eslint-disable-next-line no-control-regex
  assert.doesNotMatch(text, /[\u0000-\u001f\u007f-\u009f\u202e]/);
}

for (const [way, fail] of Object.entries(ways)) {
  test(`${way} is quoted in a legible way`, async () => {
    await assert.rejects(fail, (error) => {
      assertLegible(error.message);
      assertLegible(error.hint);
      return error.code !== 'INTERNAL';
    });
  });
}

test('warnings are legible', async () => {
  const { warnings } = await convertFile(carriers['image.gltf'](nasty), { name: 'a.gltf' });
  assert.equal(warnings.length, 1);
  assertLegible(warnings[0].message);
  const library = await convertFile(carriers['library.obj'](nasty.replace('\r\n', '')),
    { name: 'a.obj' });
  assert.equal(library.warnings.length, 1);
  assertLegible(library.warnings[0].message);
});
