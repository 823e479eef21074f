// SPDX-License-Identifier: MIT
// The laws of the figures in "How it works": what they draw is what the text beside them says.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { circleThrough, flips } from '../../web/scenes/delaunay_flip.js';
import { flattened, grownDisk, loopAround } from '../../web/scenes/disk_patch.js';
import { cross } from '../../web/scenes/plane.js';
import { polarMap } from '../../web/scenes/polar_map.js';
import { evenAreas } from '../../web/scenes/relocation.js';
import { Solid } from '../../web/scenes/solid.js';

const near = (a, b) => Math.abs(a - b) < 1e-9;
const solid = await Solid.made({ vertices: 300, adaptivity: 0 });

test('the polar map keeps the lengths of edges and the proportions of angles', () => {
  const middle = [0, 0, 1];
  const ring = [[1, 0, 0], [0.5, 1, 0.2], [-1, 0.6, 0], [-0.7, -1, 0.4], [0.6, -0.9, 0]];
  const flat = polarMap(middle, ring);
  flat.forEach((p, i) => assert.ok(near(Math.hypot(...p), Math.hypot(ring[i][0], ring[i][1],
    ring[i][2] - 1)), `edge ${i}`));
  const spokes = ring.map((p) => [p[0], p[1], p[2] - 1]);
  const between = (list, i) => {
    const [p, q] = [list[i], list[(i + 1) % list.length]];
    const product = p.reduce((sum, x, k) => sum + x * q[k], 0);
    return Math.acos(product / Math.hypot(...p) / Math.hypot(...q));
  };
  const ratios = flat.map((_, i) => between(flat, i) / between(spokes, i));
  assert.ok(ratios.every((ratio) => near(ratio, ratios[0])), `${ratios}`);
});

test('a patch is a disk, and its map to the unit disk folds nothing over', () => {
  for (const middle of [0, 90, 222]) {
    const patch = grownDisk(solid, middle, 12);
    assert.ok(patch.length > 20);
    const loop = loopAround(patch), places = flattened(solid, patch);
    for (const v of loop) assert.ok(near(Math.hypot(...places.get(v)), 1));
    for (const t of patch) assert.ok(cross(...t.map((v) => places.get(v))) > 0);
  }
});

test('of the two ways to cut a quadrilateral exactly one has empty circles', () => {
  const corners = [[-0.9, -0.1], [0, -0.75], [0.95, 0.1], [0.1, 0.6]];
  assert.notEqual(flips(corners), flips([...corners.slice(1), corners[0]]));
  const { middle, radius } = circleThrough(...corners);
  for (const p of corners.slice(0, 3)) {
    assert.ok(near(Math.hypot(p[0] - middle[0], p[1] - middle[1]), radius));
  }
});

test('no place near the one of even areas has areas nearer to their mean', () => {
  const ring = [[0.9, 0], [0.75, 0.55], [0.3, 0.75], [-0.9, 0.4], [-0.6, -0.7], [0.7, -0.6]];
  const off = (at) => {
    const areas = ring.map((p, i) => cross(at, p, ring[(i + 1) % ring.length]));
    const mean = areas.reduce((sum, area) => sum + area, 0) / areas.length;
    return areas.reduce((sum, area) => sum + (area - mean) ** 2, 0);
  };
  const [x, y] = evenAreas(ring);
  for (const [dx, dy] of [[0.01, 0], [-0.01, 0], [0, 0.01], [0, -0.01]])
    assert.ok(off([x + dx, y + dy]) > off([x, y]));
});
