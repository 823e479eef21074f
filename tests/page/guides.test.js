// SPDX-License-Identifier: MIT
// The laws of lines that are drawn on a model: which are closed, what the rubber takes, the ring
// that goes on behind, and the file for the command line.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  areStrokes, guidesOf, isRound, mirrored, objOf, segmentsOf, thinned, without,
} from '../../web/model/guides.js';
import { ringOf } from '../../web/survey/ring.js';
import { torus } from '../support/shapes.js';

/** A soup as STL has it: every triangle has corners of its own. */
function soupOf({ positions, indices }) {
  return { positions: Float32Array.from([...indices].flatMap((v) =>
    [...positions.subarray(3 * v, 3 * v + 3)])), polygons: null,
  indices: Uint32Array.from(indices, (_, i) => i) };
}

const circle = (share) => Array.from({ length: 20 }, (_, i) => {
  const turn = 2 * Math.PI * share * i / 19;
  return [Math.cos(turn), Math.sin(turn), 0];
});

test('a line is closed if its ends are near each other', () => {
  assert.ok(isRound(circle(0.95)));
  assert.ok(!isRound(circle(0.6)) && !isRound([[0, 0, 0], [1, 0, 0]]));
});

test('points that are too near are left out, the ends never', () => {
  const points = [[0, 0, 0], [0.1, 0, 0], [1, 0, 0], [1.95, 0, 0], [2, 0, 0]];
  assert.deepEqual(thinned(points, 0.5), [[0, 0, 0], [1, 0, 0], [2, 0, 0]]);
});

test('the rubber takes the lines that it touches, sides that close a loop as well', () => {
  const loop = { kind: 'loop', points: [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]] };
  const line = { kind: 'direction', points: loop.points };
  assert.deepEqual(without([loop, line], [0, 1, 0.1], 0.2), [line]);
  assert.deepEqual(without([loop, line], [2.1, 1, 0], 0.2), []);
  assert.deepEqual(without([loop, line], [1, 1, 0], 0.2), [loop, line]);
  assert.deepEqual(mirrored(mirrored(line, 0.3), 0.3), line);
  assert.equal(segmentsOf([loop, line], 'loop').length, 4 * 6);
  assert.equal(segmentsOf([loop, line], 'direction').length, 3 * 6);
});

test('strokes are told from other lists', () => {
  const stroke = { kind: 'loop', points: [[0, 0, 0], [1, 0, 0], [1, 1, 0]] };
  assert.ok(areStrokes([]) && areStrokes([stroke]));
  for (const wrong of [null, {}, [null], [{}], [{ ...stroke, kind: 'ring' }],
    [{ ...stroke, points: stroke.points.slice(1) }], [{ ...stroke, points: [[0, 0], [1, 1]] }],
    [stroke, { kind: 'direction', points: [[0, 0, 0]] }]]) {
    assert.equal(areStrokes(wrong), false, JSON.stringify(wrong));
  }
});

test('guides are where the model is, and the file has the same', () => {
  const strokes = [{ kind: 'loop', points: [[0, 0, 0], [1, 0, 0], [1, 1, 0]] },
    { kind: 'direction', points: [[0, 0, 0], [0, 0, 1]] }];
  const [loop, line] = guidesOf(strokes, [100, 0, 0.5]);
  assert.deepEqual(loop.points, [[100, 0, 0.5], [101, 0, 0.5], [101, 1, 0.5], [100, 0, 0.5]]);
  assert.deepEqual(objOf([loop, line]).split('\n'), ['o loop 1', 'v 100 0 0.5', 'v 101 0 0.5',
    'v 101 1 0.5', 'v 100 0 0.5', 'l 1 2 3 4', 'o direction 2', 'v 100 0 0.5', 'v 100 0 1.5',
    'l 5 6', '']);
});

test('the ring is the one part of the cut that the line is on, and closes', () => {
  const soup = soupOf(torus());
  // The plane y = 0 cuts the tube twice, on the right and on the left.
  const ring = ringOf(soup, { through: [2, 0, 0.8], normal: [0, 1, 0] });
  assert.ok(ring.length > 20);
  for (const [x, y, z] of ring) {
    assert.ok(x > 0 && Math.abs(y) < 1e-6 && Math.abs(Math.hypot(x - 2, z) - 0.8) < 0.02);
  }
  const steps = ring.map((point, i) =>
    Math.hypot(...point.map((value, k) => value - ring[(i + 1) % ring.length][k])));
  assert.ok(Math.max(...steps) < 0.25, 'each point is beside the next, the last beside the first');
});

test('of an open surface no ring closes where the cut ends at its rim', () => {
  const { positions, indices } = torus();
  const open = cutOpen({ positions, indices });
  assert.equal(ringOf(soupOf(open), { through: [2, 0, 0.8], normal: [0, 1, 0] }), null);
});

/** Without the triangles at the inner side of the tube. */
function cutOpen({ positions, indices }) {
  const kept = [];
  for (let i = 0; i < indices.length; i += 3) {
    const reach = Math.hypot(positions[3 * indices[i]], positions[3 * indices[i] + 1]);
    if (reach > 1.3) kept.push(...indices.subarray(i, i + 3));
  }
  return { positions, indices: Uint32Array.from(kept) };
}
