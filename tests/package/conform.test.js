// SPDX-License-Identifier: MIT
// Common faces: bodies that touch share their triangles there, and stay bodies by themselves.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { convertFile, remesh, remeshFile } from 'remesher';

import { rejectsWith } from '../support/errors.js';

/** The corners of a box, and its quads as seen from outside. */
const quads = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
const cornersOf = ([x, y, z], [u, v, w]) =>
  [[x, y, z], [u, y, z], [u, v, z], [x, v, z], [x, y, w], [u, y, w], [u, v, w], [x, v, w]];

/** @param {{ name: string, box: number[][], turn?: number }[]} bodies turn: of the diagonals */
function objText(bodies) {
  return bodies.map(({ name, box, turn = 0 }, i) => [`o ${name}`,
    ...cornersOf(...box).map((corner) => `v ${corner.join(' ')}`),
    ...quads.flatMap((quad) => [[0, 1, 2], [0, 2, 3]].map((triangle) =>
      `f ${triangle.map((k) => 8 * i + 1 + quad[(k + turn) % 4]).join(' ')}`))].join('\n'))
    .join('\n');
}

const bodies = [{ name: 'plate', box: [[0, 0, 0], [4, 4, 1]] },
  { name: 'block', box: [[1, 1, 1], [2.5, 2, 3]], turn: 1 },
  { name: 'apart', box: [[6, 0, 0], [7, 1, 1]] }];
const file = new TextEncoder().encode(objText(bodies));

/** Per object its triangles, as the coordinates of their corners, the least first. */
function trianglesByObject(bytes) {
  const [corners, objects] = [[], new Map()];
  let current = [];
  for (const line of new TextDecoder().decode(bytes).split('\n')) {
    const [kind, ...rest] = line.split(' ');
    if (kind === 'v') corners.push(rest.join(' '));
    if (kind === 'o') objects.set(rest[0], current = []);
    if (kind === 'f') current.push(rest.map((v) => corners[Number.parseInt(v, 10) - 1]));
  }
  return objects;
}

const inOrder = (triangle) => {
  const first = triangle.indexOf([...triangle].sort()[0]);
  return [0, 1, 2].map((k) => triangle[(first + k) % 3]).join();
};

/** Edges along which the triangles do not run once in each direction. */
function openEdges(triangles) {
  const ways = new Map();
  for (const triangle of triangles) {
    triangle.forEach((from, k) => {
      const way = `${from},${triangle[(k + 1) % 3]}`;
      ways.set(way, (ways.get(way) ?? 0) + 1);
    });
  }
  return [...ways].filter(([way, count]) =>
    count !== 1 || ways.get(way.split(',').reverse().join()) !== 1).length;
}

test('objects of a file share their common face, and keep their names', async () => {
  const { bytes, report } = await remeshFile(file, { name: 'bodies.obj', output: 'obj',
    conform: true, vertices: 900, worker: false });
  const objects = trianglesByObject(bytes);
  assert.deepEqual([...objects.keys()], bodies.map(({ name }) => name));
  for (const triangles of objects.values()) assert.equal(openEdges(triangles), 0);
  const own = new Set(objects.get('plate').map(inOrder));
  const common = objects.get('block').filter(([a, b, c]) => own.has(inOrder([a, c, b])));
  assert.ok(common.length > 10);
  assert.deepEqual([report.conform.faces, report.conform.triangles], [1, common.length]);
  assert.ok(Math.abs(report.conform.area - 1.5) < 1e-6);
  assert.equal(report.output.vertices, 900);
  assert.equal(new Set([...objects.values()].flat(2)).size, 900);
  assert.equal(report.output.components, 3);
});

test('nodes of a common face are written once', async () => {
  const { bytes, report } = await remeshFile(file, { name: 'bodies.obj', output: 'msh',
    preset: 'simulation', conform: true, maxEdge: 0.5, worker: false });
  assert.equal(report.preset.repair, undefined);
  assert.equal(report.output.wanted.maxEdge.missed, 0);
  const words = new TextDecoder().decode(bytes).split('\n');
  const [, nodes] = words[words.indexOf('$Nodes') + 1].split(' ').map(Number);
  assert.equal(nodes, report.output.vertices);
  const converted = await convertFile(bytes, { name: 'a.msh', output: 'obj', worker: false });
  assert.ok(converted.bytes.length > 0);
});

test('the pieces of arrays are bodies', async () => {
  const corners = bodies.slice(0, 2).map(({ box }) => cornersOf(...box)).flat();
  const indices = [0, 8].flatMap((first) => quads.flatMap(([a, b, c, d]) =>
    [a, b, c, a, c, d].map((v) => first + v)));
  const mesh = { positions: new Float64Array(corners.flat()), indices: new Uint32Array(indices) };
  const { report, mesh: made } = await remesh(mesh,
    { conform: true, vertices: 400, worker: false });
  assert.equal(report.conform.faces, 1);
  assert.equal(report.output.nonManifoldEdges, 0);
  assert.ok(made.positions.length / 3 > 400);
});

test('what a common face cannot have is refused in a sentence', async () => {
  const given = { name: 'bodies.obj', output: 'obj', conform: true, worker: false };
  const refused = [{ repair: 'auto' }, { quads: true }, { lods: [0.5] }, { prefer: 'shape' }];
  for (const others of refused) {
    await rejectsWith(remeshFile(file, { ...given, ...others }), 'INVALID_OPTION',
      /conform.*exclude each other/);
  }
});
