// SPDX-License-Identifier: MIT
// A small file may claim to hold gigabytes. Whatever the format is, the claim is compared with the
// file's bytes before room is made: it ends in a sentence, and takes a few megabytes.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { RemeshError, convertFile, remeshFile } from 'remesher';

import { openContainer, packGlb } from '../../bindings/package/codecs/gltf_container.js';
import { draco, meshopt } from '../fuzz/compressed_case.js';
import { GltfMaker } from '../support/gltf.js';
import { png } from '../support/png.js';
import { sheet } from '../support/shapes.js';

const few = 24 * 2 ** 20; // bytes
const encode = (text) => new TextEncoder().encode(text);

/** Does this, and measures the largest room that was made meanwhile, by arrays and by memories. */
async function largestRoom(work) {
  const { Uint8Array: Bytes, Float32Array: Floats } = globalThis;
  const { grow } = WebAssembly.Memory.prototype;
  let most = 0;
  const watched = (Kind) => new Proxy(Kind, {
    construct(target, words, self) {
      if (typeof words[0] === 'number') most = Math.max(most, words[0] * Kind.BYTES_PER_ELEMENT);
      return Reflect.construct(target, words, self === Proxy ? target : self);
    },
  });
  Object.assign(globalThis, { Uint8Array: watched(Bytes), Float32Array: watched(Floats) });
  WebAssembly.Memory.prototype.grow = function count(pages) {
    most = Math.max(most, 2 ** 16 * pages);
    return grow.call(this, pages);
  };
  try {
    await work();
  } finally {
    Object.assign(globalThis, { Uint8Array: Bytes, Float32Array: Floats });
    WebAssembly.Memory.prototype.grow = grow;
  }
  return most;
}

/** A glTF of one triangle after a change to its tree. */
function gltf(change) {
  const maker = new GltfMaker();
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
  maker.show([{ attributes: { POSITION: maker.add(positions, 'VEC3') },
    indices: maker.addIndices(Uint16Array.of(0, 1, 2)) }]);
  const { bytes } = maker.glb();
  const { text, chunk } = openContainer(bytes);
  const tree = JSON.parse(text);
  change(tree);
  return { name: 'a.glb', bytes: packGlb(tree, chunk) };
}

/** A compressed file after a change to its tree and, if wanted, its bytes. */
function compressed(file, change) {
  const { text, chunk } = openContainer(file.bytes);
  const tree = JSON.parse(text);
  const bytes = chunk.slice();
  change(tree, bytes);
  return { name: 'a.glb', bytes: packGlb(tree, bytes) };
}

/** Nodes that each show a mesh at as many places as the file has bytes. */
function instances(tree) {
  tree.buffers.push({ byteLength: 20_000, uri: `data:;base64,${Buffer.alloc(20_000)
    .toString('base64')}` });
  tree.accessors.push({ componentType: 5126, type: 'VEC3', count: 20_000 });
  tree.nodes = Array.from({ length: 100 }, () => ({ mesh: 0,
    extensions: { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION: 2 } } } }));
  tree.scenes = [{ nodes: tree.nodes.map((_, i) => i) }];
}

const meshoptOf = (tree, i = 0) => tree.bufferViews[i].extensions.EXT_meshopt_compression;

/** Draco's bytes begin with its name; behind the header stand the numbers of what they hold. */
function claimInDraco(tree, bytes) {
  const at = Buffer.from(bytes).indexOf('DRACO') + 11 + 1;
  bytes.set([0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff, 0x7f], at);
}

const ply = (header, rest) => Buffer.concat([encode(`ply\nformat ${header}\nend_header\n`), rest]);
const stl = Buffer.alloc(84 + 50);
stl.writeUInt32LE(0xffffffff, 80);

/** Small files with huge claims. */
const files = {
  'accessor without bytes': gltf((tree) =>
    Object.assign(tree.accessors[0], { count: 4e9, bufferView: undefined })),
  'accessor': gltf((tree) => (tree.accessors[0].count = 1e9)),
  'indices without bytes': gltf((tree) =>
    Object.assign(tree.accessors[1], { count: 3e9, bufferView: undefined })),
  'sparse accessor': gltf((tree) => (tree.accessors[0].sparse = { count: 1e9,
    indices: { bufferView: 1, componentType: 5123 }, values: { bufferView: 0 } })),
  'buffer view': gltf((tree) => (tree.bufferViews[0].byteLength = 4e9)),
  'buffer': gltf((tree) => (tree.buffers[0].byteLength = 4e9)),
  'instances': gltf(instances),
  'vertices of meshopt': compressed(meshopt, (tree) => (meshoptOf(tree).count = 1e8)),
  'triangles of meshopt': compressed(meshopt, (tree) => tree.bufferViews.forEach((_, i) => {
    if (meshoptOf(tree, i).mode === 'TRIANGLES') meshoptOf(tree, i).count = 3e8;
  })),
  'indices of meshopt': compressed(meshopt, (tree) => Object.assign(meshoptOf(tree),
    { mode: 'INDICES', byteStride: 4, count: 1e9 })),
  'one range of meshopt, many times': compressed(meshopt, (tree) => {
    for (let i = 0; i < 500; i += 1) tree.bufferViews.push(structuredClone(tree.bufferViews[0]));
  }),
  'draco': compressed(draco, claimInDraco),
  'vertices of a binary PLY': { name: 'a.ply', bytes: ply('binary_little_endian 1.0\n'
    + 'element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z',
  Buffer.alloc(120)) },
  'vertices of a PLY in text': { name: 'a.ply', bytes: ply('ascii 1.0\n'
    + 'element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z',
  encode('0 0 0\n1 0 0\n0 1 0\n')) },
  'faces of a PLY': { name: 'a.ply', bytes: ply('ascii 1.0\nelement vertex 3\n'
    + 'property float x\nproperty float y\nproperty float z\nelement face 4000000000\n'
    + 'property list uchar int vertex_indices', encode('0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n')) },
  'a list of a PLY': { name: 'a.ply', bytes: ply('ascii 1.0\nelement vertex 3\n'
    + 'property float x\nproperty float y\nproperty float z\nelement face 1\n'
    + 'property list uint int vertex_indices', encode('0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n')) },
  'vertices of an OFF': { name: 'a.off', bytes: encode('OFF\n4000000000 1 0\n0 0 0\n') },
  'faces of an OFF': { name: 'a.off',
    bytes: encode('OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n') },
  'corners of an OFF': { name: 'a.off',
    bytes: encode('OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n') },
  'facets of an STL': { name: 'a.stl', bytes: new Uint8Array(stl) },
};

for (const [claim, { name, bytes }] of Object.entries(files)) {
  test(`too much is claimed: ${claim}`, async () => {
    assert.ok(bytes.length < 2 ** 22);
    const room = await largestRoom(() => assert.rejects(
      convertFile(bytes, { name, output: 'b.obj', worker: false }), (error) => {
        assert.ok(error instanceof RemeshError, error.stack);
        assert.ok(['PARSE_ERROR', 'UNSUPPORTED'].includes(error.code), error.message);
        assert.match(error.message, /^a\.\w+[:,] [^\n]+\.$/);
        return true;
      }));
    assert.ok(room < few, `${room} bytes`);
  });
}

/** A textured sheet whose image is this. */
function painted(image, mimeType) {
  const { positions, indices } = sheet(4);
  const maker = new GltfMaker();
  maker.show([{ attributes: { POSITION: maker.add(positions, 'VEC3'), TEXCOORD_0: maker.add(
    Float32Array.from({ length: positions.length / 3 * 2 }, (_, i) => positions[
      3 * Math.floor(i / 2) + i % 2]), 'VEC2') }, indices: maker.addIndices(
    Uint16Array.from(indices)), material: 0 }]);
  maker.tree.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
  maker.tree.textures = [{ source: 0 }];
  maker.tree.images = [{ bufferView: maker.addView(image), mimeType }];
  return maker.glb().bytes;
}

/** The bytes of a JPEG up to its frame's header. */
function jpeg(width, height) {
  return Uint8Array.from([0xff, 0xd8, 0xff, 0xc0, 0, 17, 8, height >> 8, height & 255,
    width >> 8, width & 255, 3, 1, 0x22, 0, 2, 0x11, 0, 3, 0x11, 0, ...new Array(64).fill(0)]);
}

test('too much is claimed: the sizes of images', async () => {
  const image = png(8, 8, () => [255, 0, 0]);
  const claimed = (width, height) => {
    const bytes = image.slice();
    new DataView(bytes.buffer).setUint32(16, width);
    new DataView(bytes.buffer).setUint32(20, height);
    return bytes;
  };
  const images = [[claimed(8192, 8192), 'image/png'], [claimed(1e9, 1e9), 'image/png'],
    [jpeg(8192, 8192), 'image/jpeg']];
  for (const [bytes, type] of images) {
    const file = painted(bytes, type);
    const room = await largestRoom(() => assert.rejects(
      remeshFile(file, { name: 'a.glb', textures: 'bake', ratio: 0.5, worker: false }), (error) => {
        assert.ok(error instanceof RemeshError, error.stack);
        assert.match(error.message, /^[^\n]*texels[^\n]*\.$/);
        return true;
      }));
    assert.ok(room < few, `${room} bytes`);
  }
});

test('images and ranges that are as dense as can be are read', async () => {
  const dense = png(1500, 1500, () => [0, 0, 0]);
  const { report } = await remeshFile(painted(dense, 'image/png'),
    { name: 'a.glb', textures: 'bake', ratio: 0.5, worker: false });
  assert.ok(report.output.triangles > 0);
});
