// SPDX-License-Identifier: MIT
// The reader that judges written files without the engine reads right, and measures right.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { files } from '../fuzz/made_files.js';
import { joined, moved, shapes, welded } from '../fuzz/made_shapes.js';
import { scenes } from '../fuzz/made_scenes.js';
import { Dice } from '../fuzz/dice.js';
import { GltfMaker } from '../support/gltf.js';
import { closedPieces, isSound, treeOf, windingAt } from '../support/independent/bodies.js';
import { distances } from '../support/independent/distance.js';
import { orient2, orient3 } from '../support/independent/exact.js';
import { figuresOf } from '../support/independent/figures.js';
import { trianglesMeet } from '../support/independent/meeting.js';
import { readFile } from '../support/independent/read.js';
import { borderOf, chordLength, crossingsOf, loopsOf, orderedLoop, piecesOf, placeOf, surfaceOf,
  volumeOf }
  from '../support/independent/surface.js';

const encode = (text) => new TextEncoder().encode(text);
const read = (file) => readFile(file.bytes, file);

/** A shape of plain lists as a surface. */
const surface = ({ positions, triangles }) => surfaceOf([{ quads: 0,
  positions: Float64Array.from(positions.flat()), triangles: Uint32Array.from(triangles.flat()) }]);

const allTriangles = ({ triangles }) => Array.from({ length: triangles.length / 3 }, (_, t) => t);
const near = (a, b, far = 1e-6) => assert.ok(Math.abs(a - b) <= far, `${a} is not ${b}`);

test('every format gives the same figures of the same surface', () => {
  const ball = shapes.ball(3);
  const once = Object.entries(files).filter(([kind]) => kind !== 'instanced');
  for (const [kind, write] of once) {
    const figures = figuresOf(read(write(ball)));
    const { vertices, triangles, components, boundaryEdges, nonManifoldEdges, crossings } = figures;
    assert.deepEqual(
      { vertices, triangles, components, boundaryEdges, nonManifoldEdges, crossings },
      { vertices: 56, triangles: 108, components: 1, boundaryEdges: 0, nonManifoldEdges: 0,
        crossings: 0 }, kind);
    near(figures.minAngle.mean, figuresOf(read(files.obj(ball))).minAngle.mean, 0.01);
  }
  const zipped = files.stl(ball);
  assert.equal(figuresOf(readFile(gzipSync(zipped.bytes), { name: 'made.stl.gz' })).triangles, 108);
});

test('polygons, negative numbers and materials of OBJ are read', () => {
  const text = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red paint\nf -4/1 -3/2 -2/3 \\\n -1/4\n'
    + 'v 2 0 0 # v 9 9 9\nf 2//1 5//1 3//1\nusemtl unused\n';
  const { parts: [part], materials } = read({ name: 'a.OBJ', bytes: encode(text) });
  assert.deepEqual(part.faces, [[0, 1, 2, 3], [1, 4, 2]]);
  assert.deepEqual([...part.triangles], [0, 1, 2, 0, 2, 3, 1, 4, 2]);
  assert.equal(part.quads, 1);
  assert.deepEqual([...materials], ['red paint']);
  assert.throws(() => read({ name: 'a.obj', bytes: encode('v 0 0 0\nf 1 2 3\n') }),
    /vertex 2 of 1/);
});

test('quads of glTF, levels of detail and mirrored nodes are read', () => {
  const maker = new GltfMaker();
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0);
  const primitive = { attributes: { POSITION: maker.add(positions, 'VEC3') },
    indices: maker.addIndices(Uint16Array.of(0, 1, 2, 0, 2, 3, 4, 5, 1, 2, 1, 5)),
    extensions: { FB_ngon_encoding: {} } };
  maker.show([primitive]);
  maker.tree.extensionsUsed = ['FB_ngon_encoding', 'MSFT_lod'];
  maker.tree.meshes.push({ primitives: [{ attributes: primitive.attributes }] });
  maker.tree.nodes = [{ mesh: 0, scale: [-1, 2, 1], translation: [0, 0, 5],
    extensions: { MSFT_lod: { ids: [1] } } }, { mesh: 1 }];
  const { parts: [part], levels } = read(maker.glb());
  assert.deepEqual(part.faces, [[0, 3, 2, 1], [4, 1, 5], [2, 5, 1]]);
  assert.deepEqual([...part.positions.subarray(6, 9)], [-1, 2, 5]);
  assert.equal(levels[0][0].triangles.length, 6);
  assert.throws(() => {
    maker.tree.extensionsUsed.push('KHR_draco_mesh_compression');
    read(maker.glb());
  }, /KHR_draco/);
});

test('a mesh shown twice counts once, and in the world twice', () => {
  const figures = figuresOf(read(scenes.uneven(shapes.box(1))));
  assert.equal(figures.triangles, 12);
  assert.equal(figures.surface.triangles.length, 72);
  assert.equal(figures.crossingsAcross, 0);
  const [left, right] = read(scenes.halves(shapes.box(2))).parts;
  const twice = { parts: [left, { ...right, positions: left.positions,
    triangles: left.triangles }] };
  assert.equal(figuresOf(twice).crossingsAcross, 2 * left.triangles.length / 3);
});

test('open edges, edges of more triangles, pieces, loops and volumes are counted', () => {
  const sheet = surface(shapes['flat sheet'](2));
  assert.equal(borderOf(sheet).open.length, 16);
  const [loop] = loopsOf(sheet, borderOf(sheet).open);
  near(loop.length, 4);
  const around = orderedLoop(loop.edges).map((v) => placeOf(sheet, v));
  assert.equal(around.length, 16);
  near(chordLength(around, 16), 4);
  near(chordLength(around, 4), 4);
  assert.ok(chordLength(around, 3) < 3.6);
  const boxes = surface(shapes['two boxes that touch along an edge'](1));
  assert.deepEqual([borderOf(boxes).open.length, borderOf(boxes).nonManifold], [0, 1]);
  near(volumeOf(boxes, allTriangles(boxes)), 2);
  assert.equal(piecesOf(boxes).length, 1);
  assert.equal(closedPieces(boxes).length, 1);
  const far = surface(moved(shapes.box(2), [1e6, 0, 0]));
  near(volumeOf(far, allTriangles(far)), 1);
  assert.equal(piecesOf(surface(shapes['two balls'](2))).length, 2);
  assert.equal(closedPieces(sheet).length, 0);
});

test('winding numbers tell bodies, cavities and the outside', () => {
  const hollow = surface(shapes['a shell in a shell'](6));
  const tree = treeOf(hollow, allTriangles(hollow));
  assert.equal(windingAt(tree, [0.95, 0.03, 0.02]), 1);
  assert.equal(windingAt(tree, [0.1, 0.2, 0.3]), 0);
  assert.equal(windingAt(tree, [3, 0.2, 0.3]), 0);
  const sound = (shape) => isSound(figuresOf({ parts: [{ quads: 0, faces: [],
    positions: Float64Array.from(shape.positions.flat()),
    triangles: Uint32Array.from(shape.triangles.flat()) }] }));
  assert.ok(sound(shapes['a shell in a shell'](3)));
  assert.ok(sound(shapes['two balls'](3)));
  assert.ok(!sound(joined(shapes.ball(3), moved(shapes.ball(2), [0.1, 0, 0]))), 'crossing');
  const inside = { ...shapes.ball(2), positions: shapes.ball(2).positions
    .map((p) => p.map((x) => x / 2)) };
  assert.ok(!sound(joined(shapes.ball(3), inside)), 'a body in a body');
  assert.ok(!sound({ ...inside, triangles: inside.triangles.map(([a, b, c]) => [a, c, b]) }));
  assert.ok(!sound(shapes.sheet(2)));
});

test('signs are exact where rounding would decide', () => {
  const e = 2 ** -52;
  assert.equal(orient2([0, 0], [1, 1], [0.5, 0.5 + e / 2], [0, 1]), 1);
  assert.equal(orient2([0.1, 0.1], [0.3, 0.3], [0.7, 0.7], [0, 1]), 0);
  const plane = [[0.1, 0.2, 0.7], [0.4, -0.3, 0.7], [0.9, 0.6, 0.7]];
  assert.equal(orient3(...plane, [0.3, 0.3, 0.7]), 0);
  assert.notEqual(orient3(...plane, [0.3, 0.3, 0.7 + e]), 0);
  assert.equal(orient3(...plane, [0.3, 0.3, 0.7 + e]), -orient3(...plane, [0.3, 0.3, 0.7 - e]));
  assert.equal(orient3([5e-324, 0, 0], [0, 5e-324, 0], [0, 0, 1e300], [0, 0, 0]), 1);
});

/** Triangles by lists of corners; equal corners get equal numbers. */
function meets(one, other) {
  const all = [...one, ...other];
  const ids = all.map((p) => all.findIndex((q) => q.join() === p.join()));
  const triangle = (at, from) => ({ at: at.map((p) => Float64Array.from(p)),
    ids: ids.slice(from, from + 3) });
  const answers = [trianglesMeet(triangle(one, 0), triangle(other, 3)),
    trianglesMeet(triangle(other, 3), triangle(one, 0))];
  assert.equal(answers[0], answers[1]);
  return answers[0];
}

test('triangles meet, touch and miss', () => {
  const flat = [[0, 0, 0], [4, 0, 0], [0, 4, 0]];
  assert.ok(meets(flat, [[1, 1, -1], [1, 1, 1], [2, 1, 1]]), 'through');
  assert.ok(meets(flat, [[1, 1, 0], [1, 1, 1], [2, 1, 1]]), 'a corner touches');
  assert.ok(!meets(flat, [[1, 1, 2 ** -60], [1, 1, 1], [2, 1, 1]]), 'just above');
  assert.ok(meets(flat, [[2, 0, 0], [2, -1, 0], [3, -1, 0]]), 'a corner on a side, in one plane');
  assert.ok(!meets(flat, [[5, 5, 0], [6, 5, 0], [5, 6, 0]]), 'apart in one plane');
  assert.ok(meets(flat, [[-9, -9, 0], [9, -9, 0], [0, 30, 0]]), 'inside another, in one plane');
  assert.ok(!meets(flat, [[0, 0, 0], [4, 0, 0], [0, 0, 4]]), 'a common side');
  assert.ok(!meets(flat, [[0, 0, 0], [4, 0, 0], [0, -4, 0]]), 'a common side, in one plane');
  assert.ok(meets(flat, [[0, 0, 0], [4, 0, 0], [1, 1, 0]]), 'folded over a common side');
  assert.ok(!meets(flat, [[0, 0, 0], [-4, 0, 0], [0, -4, 0]]), 'a common corner');
  assert.ok(!meets(flat, [[0, 0, 0], [-4, 1, 3], [-4, 1, -3]]), 'a common corner, across');
  assert.ok(meets(flat, [[0, 0, 0], [1, 1, 3], [1, 1, -3]]), 'a common corner, through');
  assert.ok(meets(flat, [[0, 0, 0], [1, 1, 0], [1, 1, 3]]), 'a side in the other triangle');
  assert.ok(meets(flat, [[0, 0, 0], [8, 0, 0], [4, -4, 0]]), 'a side along a side');
  assert.ok(meets(flat, [[0, 4, 0], [0, 0, 0], [4, 0, 0]]), 'the same');
});

test('crossings are those that all pairs have', () => {
  const dice = new Dice(7);
  const point = () => [0, 1, 2].map(() => dice.whole(0, 4));
  const positions = Array.from({ length: 60 }, point);
  const triangles = Array.from({ length: 90 }, () =>
    [0, 1, 2].map(() => dice.whole(0, positions.length - 1)));
  const soup = surface(welded({ positions, triangles }));
  const found = crossingsOf(soup);
  const groups = allTriangles(soup);
  assert.deepEqual([...crossingsOf(soup, groups).keys()].sort(), [...found.keys()].sort());
  assert.equal(crossingsOf(soup, groups.map(() => 0)).size, 0);
  assert.ok(found.size > 40 && found.size <= groups.length);
  const balls = surface(joined(shapes.ball(3), moved(shapes.ball(3), [1, 0.1, 0.2])));
  const crossed = crossingsOf(balls);
  assert.ok(crossed.size > 20);
  for (const [s, t] of crossed) assert.ok((s < 108) !== (t < 108));
});

test('distances are those of the shapes', () => {
  const [ball, larger] = [1, 1.1].map((factor) => surface({ ...shapes.ball(4),
    positions: shapes.ball(4).positions.map((p) => p.map((x) => factor * x)) }));
  const { there, back } = distances(larger, ball);
  near(there.distance, 0.1, 0.004);
  near(back.distance, 0.1, 0.004);
  assert.equal(distances(ball, ball).there.distance < 1e-9, true);
});
