// SPDX-License-Identifier: MIT
// An independent reader and writer, Assimp's command line: what it writes is read right, and it
// reads right what we write, in PLY and STL, text and binary.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { convertFile, inspect } from 'remesher';

import { distinctPositions, offText, torus } from '../support/shapes.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-assimp-'));
after(() => rmSync(folder, { recursive: true }));

const { positions, indices } = torus({ columns: 16, rows: 12, radius: 8, tube: 3 });
// Sixteenths have few digits: they are the same numbers in text.
const mesh = { positions: positions.map((x) => Math.round(16 * x) / 16), indices };
const text = new TextEncoder().encode(offText(mesh));

/** @param {string[]} words */
const assimp = (...words) => execFileSync('assimp', words,
  { cwd: folder, encoding: 'utf8', timeout: 60_000, stdio: ['ignore', 'pipe', 'pipe'] });

/** Ours, in a format. @param {string} name */
async function write(name) {
  const { bytes } = await convertFile(text, { name: 'torus.off', output: name });
  writeFileSync(join(folder, name), bytes);
}

/** The triangles of a file by the places of their corners, in an order that all files have. */
async function trianglesIn(name) {
  const { bytes } = await convertFile(readFileSync(join(folder, name)), { name, output: 'off' });
  const lines = new TextDecoder().decode(bytes).split('\n').slice(1)
    .filter((line) => line !== '' && !line.startsWith('#')).map((line) => line.split(' '));
  const [[vertices, faces], ...rows] = lines;
  const places = rows.slice(0, Number(vertices)).map((row) => row.slice(0, 3).map(Math.fround));
  const triangles = rows.slice(Number(vertices)).map((row) => {
    const corners = row.slice(1, 4).map((i) => places[Number(i)].join(' '));
    const first = corners.indexOf([...corners].sort()[0]);
    return [...corners.slice(first), ...corners.slice(0, first)].join(', ');
  });
  assert.equal(triangles.length, Number(faces));
  return triangles.sort();
}

const original = (async () => {
  await write('original.ply');
  return trianglesIn('original.ply');
})();

for (const [format, name] of Object.entries({
  ply: 'text.ply', plyb: 'binary.ply', stl: 'text.stl', stlb: 'binary.stl',
})) {
  test(`what Assimp writes as ${format} is read right`, async () => {
    const expected = await original;
    writeFileSync(join(folder, 'torus.off'), text);
    assimp('export', 'torus.off', name, `-f${format}`);
    assert.deepEqual(await trianglesIn(name), expected);
    const { input } = await inspect(readFileSync(join(folder, name)), { name });
    assert.deepEqual([input.vertices, input.boundaryEdges, input.eulerCharacteristic],
      [distinctPositions(mesh.positions), 0, 0]);
  });
}

for (const name of ['ours.ply', 'ours.stl', 'ours.3mf']) {
  test(`Assimp reads our ${name} right`, async () => {
    await write(name);
    const said = assimp('info', name);
    assert.equal(Number(/Faces:\s+(\d+)/.exec(said)?.[1]), mesh.indices.length / 3);
    // What it has read, in binary PLY, which we have just seen ourselves read.
    assimp('export', name, `read_${name}.ply`, '-fplyb');
    assert.deepEqual(await trianglesIn(`read_${name}.ply`), await original);
  });
}
