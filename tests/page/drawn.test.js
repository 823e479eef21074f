// SPDX-License-Identifier: MIT
// What the page computes to draw surfaces: the outlines, strokes and colours of quads, and normals.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remesh } from 'remesher';
import {
  Box3, BoxGeometry, BufferAttribute, BufferGeometry, Color, Group, Mesh, MeshStandardMaterial,
  Texture, Vector3,
} from 'three';

import { angleColors } from '../../web/base/colors.js';
import { irregularVertices } from '../../web/survey/irregular.js';
import { strokesOf } from '../../web/survey/strokes.js';
import { measureDistances, Surface } from '../../web/survey/surface.js';
import { withNormals } from '../../web/triangles/normals.js';
import { outlineOf, polygonsOf } from '../../web/triangles/polygons.js';
import { soupOf } from '../../web/triangles/soup.js';
import { colorByAngle } from '../../web/triangles/triangle_angles.js';
import { clearance } from '../../web/view/clearance.js';
import { ModelView } from '../../web/view/model_view.js';
import { torus } from '../support/shape_files.js';
import { torus as torusArrays } from '../support/shapes.js';

/** A mesh as the loader makes it of a file whose triangles are polygons. */
function polygonMesh(positions, indices) {
  const mesh = new Mesh(new BufferGeometry()
    .setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3))
    .setIndex(new BufferAttribute(Uint32Array.from(indices), 1)));
  mesh.userData.gltfExtensions = { FB_ngon_encoding: {} };
  mesh.geometry.userData.polygons = polygonsOf(mesh);
  return mesh;
}

test('quads are drawn without diagonals, and dots are where not four of them meet', async () => {
  const { mesh: { positions, indices }, report } =
    await remesh(torusArrays(), { quads: true, vertices: 400 });
  const mesh = polygonMesh(positions, indices);
  const { polygons } = mesh.geometry.userData;
  const { count, irregular } = report.output.quads;
  assert.equal(polygons.length - 1, count);
  assert.equal(outlineOf(mesh.geometry, polygons).length / 2, 2 * count, 'an edge for two quads');
  const { edges: { first } } = await inspect({ positions, indices }, { edges: true });
  const { valences, places } = irregularVertices(soupOf([mesh]), first);
  assert.equal(valences.length, irregular);
  assert.equal(places.length, 3 * irregular);
  // Around a ring those of fewer and of more quads cancel.
  assert.equal(valences.reduce((sum, valence) => sum + 4 - valence, 0), 0);
  delete mesh.userData.gltfExtensions;
  assert.equal(polygonsOf(mesh), null);
});

test('a normal map that is all there is to see is seen on clay', () => {
  const views = [{}, { map: new Texture() }].map((more) => {
    const mesh = new Mesh(new BoxGeometry(), new MeshStandardMaterial(
      { normalMap: new Texture(), ...more }));
    new ModelView({ scene: new Group().add(mesh), bounds: new Box3().setFromObject(mesh),
      origin: new Vector3(), front: null }, 'red', null).setShading('plain');
    return mesh.material;
  });
  assert.ok(views[0].normalMap, 'the relief');
  assert.equal(views[1].normalMap, null, 'of what has colours the triangles are looked at');
  assert.ok(views.every(({ color, map }) => color.getHexString() === 'ff0000' && !map));
});

test('a quad has two strokes through its middle, along its directions and within it', () => {
  // A square's side, and a rectangle of twice the height beside it; a triangle has none.
  const mesh = polygonMesh([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 2, 0, 1, 2, 0],
    [0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 6, 2, 5, 6]);
  const strokes = strokesOf(soupOf([mesh]));
  assert.equal(strokes.length, 2 * 2 * 6);
  const middles = [[0.5, 0.5, 0], [1.5, 1, 0]];
  for (let i = 0; i < 4; i += 1) {
    const [from, to] = [strokes.subarray(6 * i, 6 * i + 3), strokes.subarray(6 * i + 3, 6 * i + 6)];
    const [across, along] = [0, 1].map((axis) => Math.abs(to[axis] - from[axis]));
    assert.ok(Math.min(across, along) < 1e-6, 'along one side, at right angles to the other');
    const side = i > 1 && along > across ? 2 : 1;
    assert.ok(Math.max(across, along) > side / 2 && Math.max(across, along) < side);
    from.forEach((value, axis) =>
      assert.ok(Math.abs((value + to[axis]) / 2 - middles[i >> 1][axis]) < 1e-6));
  }
});

test('a square is coloured as good, and the longer the slant of a quad the worse', () => {
  const reds = angleColors.map((color) => Math.fround(new Color(color).r));
  const steps = [0, 0.3, 0.6, 3].map((slant) => {
    const mesh = polygonMesh([0, 0, 0, 1, 0, 0, 1 + slant, 1, 0, slant, 1, 0], [0, 1, 2, 0, 2, 3]);
    const corners = mesh.geometry.toNonIndexed();
    colorByAngle(corners, mesh.geometry.userData.polygons);
    const { array } = corners.getAttribute('color');
    for (let i = 3; i < array.length; i += 3) assert.equal(array[i], array[0], 'one colour a quad');
    return reds.indexOf(array[0]);
  });
  // 90°, then arctan 0.3 off it, and so on.
  assert.deepEqual(steps, [5, 4, 2, 0]);
});

/** A geometry of three.js. */
function geometryOf({ positions, triangles }) {
  const geometry = new BufferGeometry().setIndex(triangles.flat());
  return geometry.setAttribute('position',
    new BufferAttribute(Float32Array.from(positions.flat()), 3));
}

/** A box of twelve triangles over eight corners. */
const box = { positions: [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, i >> 2]),
  triangles: [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 6, 7],
    [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]] };

test('normals follow bends, and break at creases', async () => {
  const { attributes: { position, normal } } = await withNormals(geometryOf(box));
  assert.equal(normal.count, 36);
  for (let i = 0; i < 36; i += 1) {
    const own = [normal.getX(i), normal.getY(i), normal.getZ(i)];
    const axis = own.findIndex((value) => Math.abs(value) === 1);
    assert.deepEqual(own.filter((_, k) => k !== axis).map(Math.abs), [0, 0]);
    assert.equal(own[axis], 2 * position.getComponent(i, axis) - 1, 'outwards');
  }
  const ring = torus(80, 60);
  const smooth = await withNormals(geometryOf(ring));
  assert.equal(smooth.attributes.normal.count, ring.positions.length);
  ring.positions.forEach(([x, y, z], i) => {
    const share = 1 - 2 / Math.hypot(x, z);  // from the middle of the tube outwards
    const exact = [share * x / 0.8, y / 0.8, share * z / 0.8];
    const cosine = exact.reduce((sum, value, k) =>
      sum + value * smooth.attributes.normal.getComponent(i, k), 0);
    assert.ok(cosine > 0.999, `${cosine}`);
  });
});

test('a model that fills its part of the canvas is behind neither toolbar nor edge', () => {
  const bar = 54;  // pixels from the toolbar's upper edge to the canvas's lower one
  for (let height = 180; height <= 1200; height += 20) {
    const { free, lift } = clearance(height);
    const [top, bottom] = [-1, 1].map((side) => height * (0.5 - lift + side * free / 2));
    assert.ok(top >= 0 && bottom <= height - bar, `${height}: from ${top} to ${bottom}`);
    assert.ok(free >= 0.5, `${free} of ${height}`);
  }
  const { free, lift } = clearance(0);  // a canvas that is not laid out yet
  assert.ok(free > 0 && Number.isFinite(lift));
});

test('of a scan a part of the places is measured, and its distances are spread like all', () => {
  const surfaceOf = ({ positions, indices }, shift = 0) =>
    new Surface({ positions: Float32Array.from(positions, (x) => x + shift),
      indices: Uint32Array.from(indices), polygons: null });
  const [result, original] = [surfaceOf(torusArrays(), 0.01),
    surfaceOf(torusArrays({ columns: 120, rows: 60 }))];
  const how = { known: null, isRepair: false };
  const [all, some] = [1e9, 3000].map((most) => measureDistances(result, original, how, most));
  const sum = (bins) => bins.reduce((total, share) => total + share, 0);
  assert.ok(Math.abs(sum(some.bins) - 1) < 1e-9);
  assert.ok(some.place.distance <= all.place.distance);
  assert.ok(some.place.distance > 0.9 * all.place.distance);
  assert.deepEqual(some.values, all.values, 'of the result every vertex');
});
