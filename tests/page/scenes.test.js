// SPDX-License-Identifier: MIT
// The laws of the documentation's live figures: what they draw is what the text beside them says.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect } from 'remesher';

import { circleThrough, flips } from '../../web/scenes/delaunay_flip.js';
import { flattened, grownDisk, loopAround } from '../../web/scenes/disk_patch.js';
import { cross } from '../../web/scenes/plane.js';
import { cleaned, lighter, printable, quads, simulated } from '../../web/scenes/jobs.js';
import { generated, overlapping, plate, scan } from '../../web/scenes/made.js';
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

test('the models of the guides are what their captions say', async () => {
  const looked = async (mesh) => {
    const { input, faults } = await inspect(mesh, { faults: true });
    return { open: input.boundaryEdges, pieces: input.components, angle: input.minAngle.worst,
      crossings: faults.selfIntersections, shells: faults.innerShells };
  };
  const [rough, bodies, loose, part] =
    await Promise.all([scan(), overlapping(), generated(), plate()].map(looked));
  assert.deepEqual({ ...rough, angle: 0 },
    { open: 0, pieces: 1, angle: 0, crossings: 0, shells: 0 });
  assert.ok(bodies.open > 0 && bodies.pieces === 2 && bodies.crossings > 0);
  assert.deepEqual({ ...loose, angle: 0 },
    { open: 0, pieces: 6, angle: 0, crossings: 0, shells: 1 });
  assert.ok(part.angle < 1 && part.open === 0 && part.crossings === 0, 'sound, but of needles');
});

test('each job of the guides is done, and its words are its figures', async () => {
  const light = await lighter(1000);
  assert.equal(light.polygons.indices.length / 3, 1000);
  assert.match(light.words, /^14,400 triangles became 1,000, at most 0\.\d+ %/);
  assert.match((await printable()).words, /Open edges: 48 before, 0 after.* 0 after\.$/);
  const { words } = await simulated(0.12);
  const [, before, after] = /: ([\d.]+)° before, ([\d.]+)° after/.exec(words);
  assert.ok(before < 1 && after >= 20, `${before}, ${after}`);
  assert.match((await cleaned(1000)).words, / became 1 with (1,000|9\d\d)\.$/);
});

test('quads follow the guide of their figure', async () => {
  const off = ({ polygons: { positions, quads: faces } }) => {
    // How far sides are from the slant of the line, for those that are nearer to it than the rest.
    const slants = [];
    for (let i = 0; i < faces.length; i += 4) {
      for (const [a, b] of [[0, 1], [1, 2]]) {
        const [p, q] = [a, b].map((k) => [0, 1, 2].map((axis) =>
          positions[3 * faces[i + k] + axis]));
        slants.push(slantOf(p, q));
      }
    }
    return slants.filter((slant) => slant > 0.05 && slant < Math.PI / 2 - 0.05).length
      / slants.length;
  };
  const [plain, led] = [off(await quads(500, 0)), off(await quads(500, 3))];
  assert.ok(led > 1.2 * plain, `${led} of the sides are aslant, ${plain} without the guide`);
});

/** The angle of a side with the rings round the tube. */
function slantOf([x, y, z], [u, v, w]) {
  const turn = Math.atan2(y, x);
  const around = (v - y) * Math.cos(turn) - (u - x) * Math.sin(turn);
  const across = Math.hypot(u - x + around * Math.sin(turn), v - y - around * Math.cos(turn),
    w - z);
  return Math.atan2(Math.abs(around), across);
}
