// SPDX-License-Identifier: MIT
// glTF that is written compressed: valid, and what another reader decodes is what was written, as
// exactly as the report says.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import draco3d from 'draco3dgltf';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { convertFile, remesh, remeshFile, repairFile } from 'remesher';

import { rejectsWith } from '../support/errors.js';
import { GltfMaker, openGltf, validate } from '../support/gltf.js';
import { offText, torus } from '../support/shapes.js';
import { skinnedTorus } from '../support/skinned_torus.js';

const methods = /** @type {const} */ (['meshopt', 'draco']);
const names = { meshopt: 'EXT_meshopt_compression', draco: 'KHR_draco_mesh_compression' };

await MeshoptDecoder.ready;
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
  'draco3d.decoder': await draco3d.createDecoderModule(), 'meshopt.decoder': MeshoptDecoder });

/** The meshes of a file, as glTF-Transform reads them. */
const meshesOf = async ({ bytes }) => (await io.readBinary(bytes)).getRoot().listMeshes();

const placesOf = (primitive) => {
  const positions = primitive.getAttribute('POSITION');
  return Array.from({ length: positions.getCount() }, (_, i) => positions.getElement(i, []));
};

/** The triangles of a primitive by their places, as the file has them. */
function trianglesOf(primitive) {
  const places = placesOf(primitive).map((place) => place.map((x) => x + 0).join());
  const corners = [...primitive.getIndices().getArray()].map((index) => places[index]);
  return Array.from({ length: corners.length / 3 }, (_, t) => corners.slice(3 * t, 3 * t + 3));
}

/** The triangles in an order of their own, each from its first corner in that order. */
const sorted = (triangles) => triangles.map((triangle) => {
  const first = triangle.indexOf([...triangle].sort()[0]);
  return [0, 1, 2].map((k) => triangle[(first + k) % 3]).join(' ');
}).sort();

/** The triangle nearest to each: the farthest way between vertices of both, in the same order. */
function farthest(before, after) {
  return placesOf(before).reduce((most, place, i) =>
    Math.max(most, Math.hypot(...placesOf(after)[i].map((x, k) => x - place[k]))), 0);
}

function diagonalOf(primitive) {
  const columns = [0, 1, 2].map((k) => placesOf(primitive).map((place) => place[k]));
  return Math.hypot(...columns.map((all) => Math.max(...all) - Math.min(...all)));
}

const off = new TextEncoder().encode(offText(torus()));

/** A torus with texture coordinates that a transform moves and repeats, and a second set. */
function textured() {
  const { positions, indices } = torus();
  const maker = new GltfMaker();
  const count = positions.length / 3;
  const normals = Float32Array.from(positions, (_, i) => (i % 3 === 2 ? 1 : 0));
  const coordinates = Float32Array.from({ length: 2 * count }, (_, i) => Math.sin(i) * 3);
  const colors = Uint8Array.from({ length: 4 * count }, (_, i) => (i * 7) % 256);
  maker.show([{ material: 0, attributes: {
    POSITION: maker.add(Float32Array.from(positions), 'VEC3'), NORMAL: maker.add(normals, 'VEC3'),
    TEXCOORD_0: maker.add(coordinates, 'VEC2'),
    COLOR_0: maker.add(colors, 'VEC4', { normalized: true }) },
  indices: maker.addIndices(Uint16Array.from(indices)) }]);
  const image = new Uint8Array(Buffer.from(
    'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5'
      + 'ErkJggg==', 'base64'));
  Object.assign(maker.tree, { extensionsUsed: ['KHR_texture_transform'],
    images: [{ mimeType: 'image/png', bufferView: maker.addView(image) }],
    textures: [{ source: 0 }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0,
      extensions: { KHR_texture_transform: { offset: [0.1, 0], scale: [3, 3] } } } } }] });
  return maker.glb();
}

for (const method of methods) {
  test(`${method}: triangles stay, moved by no more than is said`, async () => {
    for (const made of [textured(), skinnedTorus()]) {
      const plain = await convertFile(made.bytes, { name: 'a.glb' });
      const packed = await convertFile(made.bytes, { name: 'a.glb', compress: method });
      assert.deepEqual(await validate(packed), []);
      assert.ok(openGltf(packed).tree.extensionsRequired.includes(names[method]));
      assert.ok(packed.compression.after < packed.compression.before);
      assert.equal(packed.compression.after, packed.bytes.length);
      const [before, after] = [await meshesOf(plain), await meshesOf(packed)]
        .map((meshes) => meshes.flatMap((mesh) => mesh.listPrimitives()));
      assert.equal(after.length, before.length);
      for (const [i, primitive] of before.entries()) {
        assert.equal(after[i].getIndices().getCount(), primitive.getIndices().getCount());
        assert.deepEqual(after[i].listSemantics().sort(), primitive.listSemantics().sort());
        assert.equal(after[i].listTargets().length, primitive.listTargets().length);
        const isInOrder = method === 'meshopt' || primitive.listTargets().length > 0;
        if (!isInOrder) continue;
        const most = packed.compression.error / 100 * diagonalOf(primitive);
        assert.ok(farthest(primitive, after[i]) <= most * 1.0001 + 1e-12);
      }
    }
  });
}

test('primitives with a common border keep it, and triangles their corners', async () => {
  const [plain, ...packed] = await Promise.all([undefined, ...methods].map(async (compress) =>
    (await meshesOf(await convertFile(skinnedTorus().bytes, { name: 'a.glb', compress })))[0]
      .listPrimitives()));
  const common = (primitives) => {
    const [a, b] = primitives.map((one) => new Set(placesOf(one).map(String)));
    return [...a].filter((place) => b.has(place)).length;
  };
  assert.ok(common(plain) > 0);
  for (const primitives of packed) assert.equal(common(primitives), common(plain));
  const shape = (primitive) => trianglesOf(primitive).map((triangle) =>
    triangle.map((corner) => corner.split(',').map((x) => Math.round(x * 500) / 500 + 0).join()));
  const [before, after] = [plain, packed[1]].map((all) => sorted(all.flatMap(shape)));
  const shared = new Set(before);
  assert.ok(after.filter((triangle) => shared.has(triangle)).length > 0.95 * before.length);
});

test('what is rounded is rounded little: texture coordinates, directions; bytes not at all',
  async () => {
    const [plain, packed] = await Promise.all([{}, { compress: 'meshopt' }].map(async (options) =>
      (await meshesOf(await convertFile(textured().bytes, { name: 'a.glb', ...options })))[0]
        .listPrimitives()[0]));
    for (const [semantic, most] of [['TEXCOORD_0', 2 ** -17], ['NORMAL', 1e-3], ['COLOR_0', 0]]) {
      const [before, after] = [plain, packed].map((one) => one.getAttribute(semantic));
      for (let i = 0; i < before.getCount(); i += 1) {
        const [p, q] = [before, after].map((one) => one.getElement(i, []));
        p.forEach((value, k) => assert.ok(Math.abs(value - q[k]) <= most, semantic));
      }
    }
    const { tree } = openGltf(await convertFile(textured().bytes,
      { name: 'a.glb', compress: 'draco' }));
    assert.deepEqual(
      tree.materials[0].pbrMetallicRoughness.baseColorTexture.extensions.KHR_texture_transform,
      { offset: [0.1, 0], scale: [3, 3] });
  });

test('quads and levels of detail stay quads and levels', async () => {
  const asked = { name: 'torus.off', output: 'torus.glb', quads: true, vertices: 120,
    quality: /** @type {const} */ ('draft'), lods: [0.5] };
  const plain = await remeshFile(off, asked);
  for (const compress of methods) {
    const packed = await remeshFile(off, { ...asked, compress });
    assert.deepEqual(await validate(packed), []);
    assert.equal(packed.report.compression.method, compress);
    const [before, after] = [openGltf(plain).tree, openGltf(packed).tree];
    assert.deepEqual(after.nodes, before.nodes);
    const [kept, made] = await Promise.all([plain, packed].map(async (file) =>
      (await meshesOf(file)).map((mesh) => mesh.listPrimitives()[0])));
    kept.forEach((primitive, i) => {
      assert.deepEqual([...made[i].getIndices().getArray()],
        [...primitive.getIndices().getArray()]);
      assert.ok(farthest(primitive, made[i]) < 1.1e-5 * diagonalOf(primitive));
    });
  }
});

test('files that are read, mended and named .gltf are compressed too', async () => {
  for (const compress of methods) {
    const beside = await repairFile(off, { name: 'torus.off', output: 'torus.gltf', compress });
    assert.deepEqual(beside.files.map(({ name }) => name), ['torus.gltf', 'torus.bin']);
    assert.deepEqual(await validate(beside), []);
    const again = await convertFile(beside.bytes, { name: 'torus.gltf', output: 'torus.glb',
      resources: { 'torus.bin': beside.files[1].bytes }, compress });
    if (compress === 'meshopt') assert.equal(again.compression.error, 0, 'rounded once, it stays');
    const embedded = await convertFile(textured().bytes, { name: 'a.glb', output: 'b.gltf',
      compress });
    assert.deepEqual(await validate(embedded), []);
  }
});

test('points far from the origin stay apart', async () => {
  const { positions, indices } = torus();
  const maker = new GltfMaker();
  maker.show([{ attributes: { POSITION: maker.add(
    Float32Array.from(positions, (x) => x + 30000), 'VEC3') },
  indices: maker.addIndices(Uint16Array.from(indices)) }]);
  const { bytes } = maker.glb();
  const count = (file) => new Set(placesOf(file[0].listPrimitives()[0]).map(String)).size;
  const plain = count(await meshesOf({ bytes }));
  for (const compress of methods) {
    const packed = await convertFile(bytes, { name: 'a.glb', compress });
    assert.equal(count(await meshesOf(packed)), plain);
  }
});

test('other formats are refused in a sentence', async () => {
  await rejectsWith(convertFile(off, { name: 'torus.off', output: 'stl', compress: 'draco' }),
    'INVALID_OPTION', /compress works for glTF only, and torus\.stl/);
  await rejectsWith(remesh(torus(), { compress: 'draco', worker: false }), 'INVALID_OPTION',
    /compress applies to files only/);
  await rejectsWith(convertFile(off, { name: 'torus.off', output: 'glb', compress: 'zip' }),
    'INVALID_OPTION', /one of auto, meshopt, draco/);
});

test('auto compresses as the file came, and the preset asset asks for it', async () => {
  const made = await convertFile(off, { name: 'torus.off', output: 'a.glb' });
  for (const compress of [undefined, ...methods]) {
    const given = await convertFile(made.bytes, { name: 'a.glb', compress });
    const auto = await convertFile(given.bytes,
      { name: 'a.glb', output: 'b.glb', compress: 'auto' });
    assert.equal(auto.compression?.method, compress);
    const asked = { name: 'a.glb', preset: 'asset', textures: 'keep', faces: 200,
      quality: /** @type {const} */ ('draft') };
    const { report } = await remeshFile(given.bytes, asked);
    assert.equal(report.compression?.method, compress);
    assert.equal(report.preset.compress, compress && 'auto');
    const text = await remeshFile(given.bytes, { ...asked, output: 'a.obj' });
    assert.equal(text.report.compression, undefined);
  }
});
