// SPDX-License-Identifier: MIT
// Guides: lines that quads follow, given as arrays or in files.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { remesh } from 'remesher';

import { flatGuides } from '../../bindings/package/base/guides.js';
import { guidesFrom } from '../../bindings/package/codecs/guides_file.js';
import { rejectsWith } from '../support/errors.js';
import { offText, torus } from '../support/shapes.js';

const folder = mkdtempSync(join(tmpdir(), 'guides-'));
after(() => rmSync(folder, { recursive: true }));

// About the z axis.
const [radius, tube] = [2, 0.8];
const ring = torus({ radius, tube });

/** A circle round the tube of the torus, in the half plane at this angle about its axis. */
function roundTube(angle, count = 24) {
  return Array.from({ length: count }, (_, i) => {
    const turn = 2 * Math.PI * i / count;
    const out = radius + tube * Math.cos(turn);
    return [out * Math.cos(angle), out * Math.sin(angle), tube * Math.sin(turn)];
  });
}

/**
 * The sides of quads whose ends both lie in the half plane of the angle: whether they are one
 * closed chain, and how many there are. Reads nothing but places and polygons.
 */
function chainAt(angle, places, polygons) {
  const isOn = (v) => {
    const [x, y] = places[v];
    const across = x * Math.sin(angle) - y * Math.cos(angle);
    return Math.abs(across) < 0.01 && x * Math.cos(angle) + y * Math.sin(angle) > 0;
  };
  const beside = new Map();
  for (const polygon of polygons) {
    polygon.forEach((a, i) => {
      const b = polygon[(i + 1) % polygon.length];
      if (!isOn(a) || !isOn(b)) return;
      beside.set(a, (beside.get(a) ?? new Set()).add(b));
      beside.set(b, (beside.get(b) ?? new Set()).add(a));
    });
  }
  const [start] = beside.keys();
  const seen = new Set();
  for (let v = start; v !== undefined && !seen.has(v);) {
    seen.add(v);
    v = [...beside.get(v)].find((next) => !seen.has(next));
  }
  const isClosed = seen.size > 2 && seen.size === beside.size
    && [...beside.values()].every((ends) => ends.size === 2);
  return { isClosed, sides: seen.size };
}

const angle = 0.7;
const asked = { quads: true, vertices: 900, symmetry: 'off' };

test('a loop is found again as a closed chain of sides', async () => {
  const found = async (options) => {
    const { mesh, report } = await remesh(ring, { ...asked, ...options });
    const places = Array.from({ length: mesh.positions.length / 3 },
      (_, i) => [...mesh.positions.subarray(3 * i, 3 * i + 3)]);
    const quads = Array.from({ length: mesh.quads.length / 4 },
      (_, i) => [...mesh.quads.subarray(4 * i, 4 * i + 4)]);
    return { ...chainAt(angle, places, quads), report };
  };
  for (const more of [{}, { exact: true }]) {
    const { isClosed, sides, report } = await found(
      { ...more, guides: [{ points: roundTube(angle), kind: 'loop' }] });
    assert.ok(isClosed && sides >= 6, `${sides} sides`);
    assert.ok(!report.warnings.some(({ code }) => code === 'GUIDES_NOT_KEPT'));
    if (more.exact) assert.equal(report.output.vertices, 900);
  }
});

test('the command line takes them from a file; without quads it says what is missing', () => {
  const file = (name, text) => {
    writeFileSync(join(folder, name), text);
    return join(folder, name);
  };
  const model = file('ring.off', offText(ring));
  const points = roundTube(angle);
  const lines = file('lines.obj', [...points.map((point) => `v ${point.join(' ')}`), 'o belt',
    `l ${points.map((_, i) => i + 1).join(' ')} 1`, ''].join('\n'));
  const out = join(folder, 'out.obj');
  const run = (...words) => spawnSync(process.execPath,
    ['dist/cli/cli.js', model, '-o', out, '--vertices', '900', ...words], { encoding: 'utf8' });
  const refused = run('--guides', lines);
  assert.equal(refused.status, 2);
  assert.match(refused.stderr, /--guides needs --quads\. Add --quads\./);
  const missing = run('--quads', '--guides', join(folder, 'none.obj'));
  assert.equal(missing.status, 2);
  assert.match(missing.stderr, /none\.obj cannot be read/);
  const done = run('--quads', '--symmetry', 'off', '--guides', lines);
  assert.equal(done.status, 0, done.stderr);
  const rows = readFileSync(out, 'utf8').split('\n').map((row) => row.trim().split(/\s+/));
  const places = rows.filter(([word]) => word === 'v').map(([, ...point]) => point.map(Number));
  const quads = rows.filter(([word]) => word === 'f')
    .map(([, ...corners]) => corners.map((corner) => Number.parseInt(corner, 10) - 1));
  assert.ok(chainAt(angle, places, quads).isClosed);
});

test('a guide far from the surface is named, with its distance', async () => {
  const away = { points: [[9, 9, 9], [9, 9, 8]], name: 'cloud' };
  const { report } = await remesh(ring, { ...asked, vertices: 300, guides: [away] });
  const far = report.warnings.find(({ code }) => code === 'GUIDES_FAR_AWAY');
  assert.match(far.message, /cloud \(by \d+ %\)/);
});

test('a guide that is not a line is refused in a sentence', async () => {
  for (const [guides, sentence] of [
    [[[[0, 0, 0]]], /guide 1 has fewer than two points/],
    [[{ points: [[0, 0, 0], [1, 0]] }], /point of guide 1 does not have three coordinates/],
    [[{ points: new Float64Array(7), name: 'arc' }], /guide arc has 7 coordinates/],
    [[[[0, 0, 0], [1, 0, Number.NaN]]], /coordinate of guide 1 is not a finite number/],
    [[{ points: [[0, 0, 0], [1, 0, 0]], kind: 'loop' }], /loop 1 has fewer than three points/],
    [[{ points: [[0, 0, 0], [1, 0, 0]], kind: 'ring' }], /'ring'.*'direction' or 'loop'/],
    [['line'], /guide 1 has no list of points|guide 1 is not a line/],
  ]) await rejectsWith(remesh(ring, { ...asked, guides }), 'INVALID_OPTION', sentence);
  await rejectsWith(remesh(ring, { guides: [roundTube(0)] }), 'INVALID_OPTION',
    /guides needs quads/);
});

test('plain lines are guides: those that return are loops', () => {
  const [line, loop] = flatGuides([[[0, 0, 0], [1, 0, 0]],
    new Float64Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0])]);
  assert.deepEqual([line.kind, line.name], ['direction', '1']);
  assert.deepEqual([loop.kind, loop.name], ['loop', '2']);
  assert.deepEqual(flatGuides([line, loop]), [line, loop]);
});

const encoded = (text) => new TextEncoder().encode(text);

test('lines of an OBJ file: sides one by one, numbers from the end, names that decide', () => {
  const text = 'v 0 0 0\nv 1 0 0\nv 1 1 0\ng rim\nl 1 2\nl 2 3\nl 3 1\n'
    + 'o direction of hair\nl -3 -2 -1 -3\no edge loop\nl 1/1 2/2 \\\n 3/3\n';
  const guides = guidesFrom({ name: 'a.obj', bytes: encoded(text) });
  assert.deepEqual(guides.map(({ kind, name, points }) => [kind, name, points.length / 3]),
    [['loop', 'rim', 4], ['direction', 'direction of hair', 4], ['loop', 'edge loop', 3]]);
  const refused = (content, sentence) =>
    assert.throws(() => guidesFrom({ name: 'a.obj', bytes: encoded(content) }), sentence);
  refused('v 0 0 0\nl 1 2\n', /line 2 names vertex 2, which is not there/);
  refused('v 0 0 0\nf 1 1 1\n', /there is no line in it/);
});

test('line primitives of a glTF file, where their nodes place them', () => {
  const numbers = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0]);
  const uri = `data:application/octet-stream;base64,${
    Buffer.from(numbers.buffer).toString('base64')}`;
  const primitive = (mode) => ({ attributes: { POSITION: 0 }, mode });
  const tree = { asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }],
    nodes: [{ translation: [0, 0, 5], children: [1] },
      { mesh: 0, scale: [2, 2, 2], name: 'cuff' }],
    meshes: [{ primitives: [primitive(2), primitive(3), primitive(4)] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }],
    bufferViews: [{ buffer: 0, byteLength: 36 }], buffers: [{ uri, byteLength: 36 }] };
  const guides = guidesFrom({ name: 'a.gltf', bytes: encoded(JSON.stringify(tree)) });
  assert.deepEqual(guides.map(({ kind, name }) => [kind, name]),
    [['loop', 'cuff'], ['direction', 'cuff']]);
  assert.deepEqual([...guides[1].points], [0, 0, 5, 2, 0, 5, 2, 2, 5]);
  assert.deepEqual([...guides[0].points.slice(-3)], [0, 0, 5]);
  tree.accessors[0].sparse = {};
  assert.throws(() => guidesFrom({ name: 'a.gltf', bytes: encoded(JSON.stringify(tree)) }),
    /compressed or sparse/);
});
