// SPDX-License-Identifier: MIT
// remesher/three: every attribute comes back as what it was, on a surface that is what it was.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { remeshFile } from 'remesher';
import { quadEdges, quadsOf, remeshGeometry, remeshObject } from 'remesher/three';
import {
  BoxGeometry, BufferAttribute, BufferGeometry, CapsuleGeometry, ConeGeometry, DynamicDrawUsage,
  Float16BufferAttribute, Group, InstancedBufferAttribute, InstancedBufferGeometry, InstancedMesh,
  IntType, InterleavedBuffer, InterleavedBufferAttribute, Line, Matrix4, Mesh, MeshBasicMaterial,
  Points, SphereGeometry, Texture, TorusGeometry, Vector3,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

import { rejectsWith } from '../support/errors.js';
import { distinctPositions, eulerCharacteristic, sheet, torus } from '../support/shapes.js';
import { skinnedTorus } from '../support/skinned_torus.js';

const geometryOf = ({ positions, indices }) => new BufferGeometry()
  .setAttribute('position', new BufferAttribute(positions, 3))
  .setIndex(new BufferAttribute(indices, 1));
const places = ({ attributes: { position } }) => Array.from({ length: position.count },
  (_, i) => new Vector3().fromBufferAttribute(position, i));
const perPlace = (geometry, make) => places(geometry).flatMap(({ x, y, z }) => make(x, y, z));
const countOf = (geometry) => distinctPositions([...geometry.attributes.position.array]);
const plain = (geometry) =>
  ({ positions: geometry.attributes.position.array, indices: geometry.index.array });
const turned = (x, y) => [0.5 + x / 8, 0.5 + y / 8];

/** How far an attribute is, at most, from what it is as a function of the place. */
function worst(geometry, attribute, make) {
  const { itemSize } = attribute;
  return Math.max(...places(geometry).map(({ x, y, z }, i) => {
    const expected = make(x, y, z);
    return Math.max(...Array.from({ length: itemSize }, (_, k) => Math.abs(
      [attribute.getX, attribute.getY, attribute.getZ, attribute.getW][k].call(attribute, i)
        - expected[k])));
  }));
}

const typed = {
  'a Float32Array': (values) => new BufferAttribute(Float32Array.from(values), 2),
  'a Float64Array': (values) => new BufferAttribute(Float64Array.from(values), 2),
  'half floats': (values) => {
    const attribute = new Float16BufferAttribute(new Uint16Array(values.length), 2);
    for (let i = 0; i < attribute.count; i += 1) {
      attribute.setXY(i, values[2 * i], values[2 * i + 1]);
    }
    return attribute;
  },
  'normalised bytes': (values) =>
    new BufferAttribute(Uint8Array.from(values, (x) => Math.round(255 * x)), 2, true),
  'normalised shorts': (values) =>
    new BufferAttribute(Int16Array.from(values, (x) => Math.round(32767 * x)), 2, true),
  'an interleaved buffer': (values) => {
    const pairs = values.length / 2;
    const rows = Array.from({ length: pairs }, (_, i) => [9, values[2 * i], values[2 * i + 1]]);
    return new InterleavedBufferAttribute(
      new InterleavedBuffer(Float32Array.from(rows.flat()), 3), 2, 1);
  },
};
for (const [kind, make] of Object.entries(typed)) {
  test(`a geometry keeps ${kind}`, async () => {
    const original = geometryOf(torus());
    const attribute = make(perPlace(original, turned));
    attribute.name = 'named';
    if (attribute.data) attribute.data.setUsage(DynamicDrawUsage);
    else attribute.setUsage(DynamicDrawUsage);
    original.setAttribute('drift', attribute);
    const { geometry, report } = await remeshGeometry(original, { vertices: 700 });
    const { drift } = geometry.attributes;
    assert.deepEqual([report.output.vertices, geometry.attributes.position.count], [700, 700]);
    assert.equal(drift.array.constructor, attribute.array.constructor);
    assert.equal(drift.isFloat16BufferAttribute, attribute.isFloat16BufferAttribute);
    assert.deepEqual([drift.itemSize, drift.normalized, drift.name, drift.usage],
      [2, attribute.normalized, 'named', DynamicDrawUsage]);
    assert.ok(worst(geometry, drift, turned) < 0.012, `${worst(geometry, drift, turned)}`);
  });
}

test('a geometry keeps whole numbers whole, and their type on the GPU', async () => {
  const original = geometryOf(torus());
  const side = new BufferAttribute(Int32Array.from(perPlace(original, () => [-70000])), 1);
  side.gpuType = IntType;
  const { geometry } = await remeshGeometry(original.setAttribute('side', side));
  assert.ok(geometry.attributes.side.array instanceof Int32Array);
  assert.ok(geometry.attributes.side.array.every((value) => value === -70000));
  assert.equal(geometry.attributes.side.gpuType, IntType);
});

test('a geometry keeps name, user data, bounds and instances, its draw range not', async () => {
  const original = new InstancedBufferGeometry();
  const { positions, indices } = torus();
  original.setAttribute('position', new BufferAttribute(positions, 3));
  original.setIndex(new BufferAttribute(indices, 1));
  const offset = new InstancedBufferAttribute(new Float32Array(9), 3);
  original.setAttribute('offset', offset);
  Object.assign(original, { name: 'ring', userData: { of: 'gold' }, instanceCount: 3 });
  original.computeBoundingBox();
  const { geometry } = await remeshGeometry(original, { vertices: 500 });
  assert.ok(geometry.isInstancedBufferGeometry);
  assert.equal(geometry.attributes.offset, offset);
  assert.deepEqual([geometry.name, geometry.userData, geometry.instanceCount],
    ['ring', { of: 'gold' }, 3]);
  assert.ok(geometry.boundingBox.max.x > 2.7 && geometry.boundingSphere === null);
  original.setDrawRange(0, indices.length / 2);
  const { geometry: half } = await remeshGeometry(original, { vertices: 500 });
  half.computeBoundingBox();
  assert.ok(half.boundingBox.min.y > -0.1, 'half a torus');
  assert.equal(half.drawRange.count, Infinity);
});

test('a geometry need not be indexed', async () => {
  const original = geometryOf(torus());
  original.computeVertexNormals();
  const { geometry } = await remeshGeometry(original.toNonIndexed(), { vertices: 600 });
  assert.equal(geometry.attributes.position.count, 600);
  assert.equal(eulerCharacteristic(plain(geometry)), 0);
  assert.equal(geometry.index.array.constructor, Uint16Array);
  const { x } = new Vector3().fromBufferAttribute(geometry.attributes.normal, 0);
  assert.ok(Number.isFinite(x));
});

test('a geometry keeps sides apart, and each its material', async () => {
  const { geometry } = await remeshGeometry(new BoxGeometry(1, 2, 3, 4, 4, 4), { vertices: 500 });
  assert.equal(countOf(geometry), 500);
  assert.deepEqual(geometry.groups.map(({ materialIndex }) => materialIndex), [0, 1, 2, 3, 4, 5]);
  const normals = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
  for (const { start, count, materialIndex } of geometry.groups) {
    assert.ok(count > 0);
    for (const vertex of geometry.index.array.subarray(start, start + count)) {
      const normal = new Vector3().fromBufferAttribute(geometry.attributes.normal, vertex);
      assert.ok(normal.distanceTo(new Vector3(...normals[materialIndex])) < 1e-5);
    }
  }
  assert.equal(geometry.groups.reduce((sum, { count }) => sum + count, 0), geometry.index.count);
});

test('a geometry keeps the area of groups that overlap or leave triangles out', async () => {
  const addArea = (areas, group, { attributes: { position }, index }) => {
    for (let i = group.start; i < group.start + group.count; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) =>
        new Vector3().fromBufferAttribute(position, index.getX(i + k)));
      areas[group.materialIndex] = (areas[group.materialIndex] ?? 0)
        + b.sub(a).cross(c.sub(a)).length() / 2;
    }
    return areas;
  };
  const areasOf = (geometry) =>
    geometry.groups.reduce((areas, group) => addArea(areas, group, geometry), []);
  const original = geometryOf(sheet(20));
  original.addGroup(0, 1200, 0);
  original.addGroup(600, 900, 1);
  const { geometry } = await remeshGeometry(original, { vertices: 400 });
  const [areas, newAreas] = [areasOf(original), areasOf(geometry)];
  assert.equal(newAreas.length, 2);
  areas.forEach((area, i) =>
    assert.ok(Math.abs(newAreas[i] / area - 1) < 0.01, `${newAreas}`));
  const drawn = new Set(geometry.groups.flatMap(({ start, count }) =>
    Array.from({ length: count }, (_, i) => start + i)));
  assert.ok(drawn.size < geometry.index.count, 'some are in none');
});

for (const isRelative of [true, false]) {
  test(`a geometry keeps ${isRelative ? 'relative' : 'absolute'} morph targets`, async () => {
    const original = geometryOf(torus());
    const lean = (x, y, z) => (isRelative ? [0, 0, x / 2] : [x, y, z + x / 2]);
    const target = new BufferAttribute(Float32Array.from(perPlace(original, lean)), 3);
    target.name = 'lean';
    original.morphAttributes.position = [target];
    original.morphTargetsRelative = isRelative;
    const { geometry } = await remeshGeometry(original, { vertices: 500 });
    const [moved] = geometry.morphAttributes.position;
    assert.equal(geometry.morphTargetsRelative, isRelative);
    assert.deepEqual([moved.name, moved.count], ['lean', 500]);
    assert.ok(worst(geometry, moved, lean) < 0.02, `${worst(geometry, moved, lean)}`);
  });
}

test('a geometry stays as it is', async () => {
  const original = geometryOf(torus());
  const copy = original.clone();
  await remeshGeometry(original, { vertices: 300 });
  assert.deepEqual(original.attributes.position.array, copy.attributes.position.array);
  assert.deepEqual(original.index.array, copy.index.array);
});

test('a geometry that cannot be remeshed is refused in a sentence', async () => {
  await rejectsWith(remeshGeometry({}), 'INVALID_MESH', /BufferGeometry/);
  await rejectsWith(remeshGeometry(new BufferGeometry()), 'INVALID_MESH', /position/);
  const geometry = geometryOf(torus());
  await rejectsWith(remeshGeometry(geometry, { vertexes: 5 }), 'UNKNOWN_OPTION', /vertexes/);
  geometry.setAttribute('short', new BufferAttribute(new Float32Array(3), 1));
  await rejectsWith(remeshGeometry(geometry), 'INVALID_MESH', /short.*3 vertices.*1152/);
  geometry.deleteAttribute('short').setIndex([0, 1, 1152]);
  await rejectsWith(remeshGeometry(geometry), 'INDEX_OUT_OF_RANGE', /1152/);
});

const file = skinnedTorus();
const surfaces = [];
const olds = [];
let report;
let disposed = 0;

{
  const loader = new GLTFLoader().register(() =>
    ({ name: 'no pictures in Node', loadTexture: async () => new Texture() }));
  const { scene } = await loader.parseAsync(Uint8Array.from(file.bytes).buffer, '');
  scene.traverse((object) => object.isMesh && surfaces.push(object));
  for (const { geometry, material } of surfaces) {
    olds.push({ geometry, material });
    geometry.addEventListener('dispose', () => (disposed += 1));
  }
  ({ report } = await remeshObject(scene, { vertices: 1500 }));
}

test('a file that was loaded has the vertices that remeshFile gives', async () => {
  const { bytes } = await remeshFile(file.bytes, { name: 'a.glb', vertices: 1500 });
  const document = await new NodeIO().registerExtensions(ALL_EXTENSIONS).readBinary(bytes);
  const primitives = document.getRoot().listMeshes().flatMap((mesh) => mesh.listPrimitives());
  assert.equal(primitives.length, 3);
  primitives.forEach((primitive, i) => {
    const { geometry } = surfaces[i];
    const names = { POSITION: 'position', TEXCOORD_0: 'uv', NORMAL: 'normal',
      JOINTS_0: 'skinIndex' };
    for (const semantic of primitive.listSemantics().filter((name) => names[name])) {
      assert.deepEqual(geometry.attributes[names[semantic]].array,
        primitive.getAttribute(semantic).getArray(), semantic);
    }
    assert.deepEqual(geometry.index.array, primitive.getIndices().getArray());
  });
  assert.equal(report.output.vertices, 1500);
});

test('a file that was loaded keeps materials, and one geometry where there was one', () => {
  surfaces.forEach(({ geometry, material }, i) => {
    assert.equal(material, olds[i].material);
    assert.notEqual(geometry, olds[i].geometry);
    assert.deepEqual(Object.keys(geometry.attributes), Object.keys(olds[i].geometry.attributes));
  });
  assert.equal(surfaces.length, 4);
  assert.equal(surfaces[2].geometry, surfaces[3].geometry);
  assert.equal(disposed, 4, 'the shared one tells both listeners');
});

test('a file that was loaded has no crack between materials, bent and morphed', () => {
  const [left, right] = surfaces;
  const border = (mesh) => {
    const edges = new Map();
    const { array } = mesh.geometry.index;
    const all = places(mesh.geometry);
    const name = (v) => all[v].toArray().join();
    array.forEach((from, i) => {
      const ends = [name(from), name(array[i % 3 === 2 ? i - 2 : i + 1])].sort().join(' ');
      edges.set(ends, (edges.get(ends) ?? 0) + 1);
    });
    return [...edges].filter(([, times]) => times === 1).map(([ends]) => ends).sort();
  };
  assert.ok(border(left).length > 10);
  assert.deepEqual(border(left), border(right));
  left.skeleton.bones[1].position.set(0, 0, 1);
  left.parent.parent.updateMatrixWorld(true);
  for (const mesh of [left, right]) {
    mesh.morphTargetInfluences[0] = 0.5;
    places(mesh.geometry).forEach(({ x, z }, i) => {
      const moved = mesh.getVertexPosition(i, new Vector3());
      const lift = Math.min(Math.max(0.5 + x / 4, 0), 1) + x / 2;
      assert.ok(Math.abs(moved.z - z - lift) < 0.03, `${moved.z - z} for ${lift}`);
    });
  }
});

const scaled = (factor) => new Matrix4().makeScale(factor, factor, factor);

test('an object shares vertices out by area in the world, instances and all', async () => {
  const root = new Group();
  const one = new Mesh(geometryOf(torus()));
  const many = new InstancedMesh(geometryOf(torus()), new MeshBasicMaterial(), 2);
  many.setMatrixAt(0, scaled(3));
  many.setMatrixAt(1, scaled(1));
  many.computeBoundingSphere();
  const { matrix } = many;
  root.add(one, many);
  root.scale.setScalar(0.01);
  const { report: { output } } = await remeshObject(root, { vertices: 2000 });
  const [single, instanced] = [one, many].map(({ geometry }) => countOf(geometry));
  assert.deepEqual([single + instanced, output.vertices], [2000, 2000]);
  // The mean of its areas: 9 and 1 times the other's.
  assert.ok(Math.abs(instanced / single - 5) < 0.05, `${instanced} and ${single}`);
  assert.deepEqual([many.count, many.matrix], [2, matrix]);
});

test('an object that is a mesh will do; lines and points keep their geometry', async () => {
  const geometry = geometryOf(torus());
  const mesh = new Mesh(geometry);
  const others = [new Points(geometry), new Line(geometry)];
  mesh.add(...others);
  await remeshObject(mesh, { vertices: 400 });
  assert.equal(mesh.geometry.attributes.position.count, 400);
  for (const other of others) assert.equal(other.geometry, geometry);
});

test('an object keeps a geometry one that is in different company elsewhere', async () => {
  const [a, b] = [geometryOf(torus()), geometryOf(torus({ radius: 5 }))];
  const [pair, alone] = [new Group(), new Group()];
  pair.add(new Mesh(a), new Mesh(b));
  alone.add(new Mesh(a));
  const root = new Group();
  root.add(pair, alone);
  await remeshObject(root, { vertices: 900 });
  assert.equal(pair.children[0].geometry, alone.children[0].geometry);
  assert.equal(countOf(pair.children[0].geometry) + countOf(pair.children[1].geometry), 900);
});

test('an object that fails or is given up is as it was', async () => {
  const mesh = new Mesh(geometryOf(torus()));
  const { geometry } = mesh;
  await rejectsWith(remeshObject(mesh, { vertices: 1 }), 'TARGET_TOO_SMALL');
  await assert.rejects(remeshObject(mesh, { signal: AbortSignal.abort() }),
    { name: 'AbortError' });
  assert.equal(mesh.geometry, geometry);
  await rejectsWith(remeshObject({}), 'INVALID_MESH', /Object3D/);
  await rejectsWith(remeshObject(new Group()), 'NO_TRIANGLES', /no meshes/);
});

test('what three.js turns around an axis is closed, whatever it says sin 2π is', async () => {
  for (const shape of [new SphereGeometry(50, 32, 16), new TorusGeometry(1, 0.4, 16, 48),
    new ConeGeometry(1, 2, 32, 4), new CapsuleGeometry(1, 1, 8, 24)]) {
    const result = await remeshGeometry(shape, { vertices: 400 });
    assert.equal(result.report.input.boundaryEdges, 0, shape.type);
    assert.equal(result.report.output.boundaryEdges, 0, shape.type);
    assert.equal(countOf(result.geometry), 400);
  }
});

test('quads are two triangles in a row each, and their edges have no diagonals', async () => {
  const options = { quads: true, vertices: 600 };
  for (const shape of [new TorusGeometry(1, 0.4, 16, 48), new BoxGeometry(1, 2, 3)]) {
    shape.userData.of = 'gold';
    const { geometry, report: { output } } = await remeshGeometry(shape, options);
    assert.deepEqual(geometry.userData, { of: 'gold', quads: true });
    assert.deepEqual(shape.userData, { of: 'gold' });
    const { count } = output.quads;
    assert.equal(quadsOf(geometry).length, 4 * count, shape.type);
    const lines = quadEdges(geometry);
    assert.equal(lines.attributes.position, geometry.attributes.position);
    // An edge is of two quads, also along seams and between groups.
    assert.equal(lines.index.count / 2, 2 * count, shape.type);
  }
  const { geometry } = await remeshGeometry(geometryOf(torus()), options);
  const triangles = await remeshGeometry(geometry, { vertices: 500 });
  assert.equal(triangles.geometry.userData.quads, false);
  assert.throws(() => quadsOf(triangles.geometry), { code: 'INVALID_MESH' });
  assert.throws(() => quadEdges(new BufferGeometry()), { code: 'INVALID_MESH' });
});

test('quads of a file have edges too, until the object is of triangles', async () => {
  const { bytes } = await remeshFile(skinnedTorus().bytes,
    { name: 'torus.glb', output: 'glb', quads: true, vertices: 700 });
  const loader = new GLTFLoader().register(() =>
    ({ name: 'no pictures in Node', loadTexture: async () => new Texture() }));
  const { scene } = await loader.parseAsync(bytes.slice().buffer, '');
  const mesh = scene.getObjectByProperty('isMesh', true);
  assert.ok(mesh.userData.gltfExtensions.FB_ngon_encoding);
  const { index } = mesh.geometry;
  assert.equal(quadsOf(mesh.geometry).length / 4, index.count / 6);
  await remeshObject(scene, { vertices: 500, quads: true });
  assert.ok(mesh.geometry.userData.quads && mesh.userData.gltfExtensions.FB_ngon_encoding);
  await remeshObject(scene, { vertices: 500 });
  assert.equal(mesh.userData.gltfExtensions.FB_ngon_encoding, undefined);
});
