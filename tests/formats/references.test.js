// SPDX-License-Identifier: MIT
// What a file says of what is made anew goes or follows: extensions, animations, and what the file
// declares to need.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remeshFile } from 'remesher';

import { baked } from '../support/baked.js';
import { GltfMaker, openGltf, validate } from '../support/gltf.js';
import { ktx2 } from '../support/ktx2.js';
import { png } from '../support/png.js';
import { sheet } from '../support/shapes.js';

const { positions, indices } = sheet(12);
const texcoords = positions.filter((_, i) => i % 3 < 2);
const image = png(16, 16, (x, y) => [16 * x, 16 * y, 90]);

/** A textured sheet; `change` has a say in it. */
function texturedSheet(change) {
  const maker = new GltfMaker();
  Object.assign(maker.tree, {
    images: [{ bufferView: maker.addView(image), mimeType: 'image/png' }],
    textures: [{ source: 0 }],
    materials: [{ name: 'other' },
      { name: 'paint', pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
  });
  const primitive = {
    attributes: {
      POSITION: maker.add(positions, 'VEC3'), TEXCOORD_0: maker.add(texcoords, 'VEC2'),
    },
    indices: maker.addIndices(Uint16Array.from(indices)),
    material: 1,
  };
  maker.show([primitive]);
  change(maker.tree, primitive, maker);
  return maker.glb();
}

async function outcome(file, options) {
  const result = await remeshFile(file.bytes, { name: file.name, vertices: 60, ...options });
  assert.deepEqual(await validate(result), []);
  const codes = result.report.warnings.map(({ code }) => code);
  return { ...result, tree: openGltf(result).tree, codes };
}
const bake = (file, options) =>
  outcome(file, { textures: 'bake', textureSize: 64, textureFormat: 'png', ...options });

test('what paints PNG of WebP requires no WebP', async () => {
  const webp = await bake(texturedSheet(() => {}), { textureFormat: 'webp' });
  assert.deepEqual(webp.tree.extensionsRequired, ['EXT_texture_webp']);
  const { tree } = await bake({ name: 'a.glb', bytes: webp.bytes });
  assert.equal(tree.extensionsRequired, undefined);
  assert.equal(tree.extensionsUsed, undefined);
});

/** The sheet with a KTX2 texture. @param {Uint8Array} bytes @param {boolean} [isAlone] */
const withKtx2 = (bytes, isAlone = true) => texturedSheet((tree, _, maker) => {
  tree.images.push({ bufferView: maker.addView(bytes), mimeType: 'image/ktx2' });
  tree.textures[0].extensions = { KHR_texture_basisu: { source: 1 } };
  if (isAlone) delete tree.textures[0].source;
  tree.extensionsUsed = ['KHR_texture_basisu'];
  if (isAlone) tree.extensionsRequired = ['KHR_texture_basisu'];
});

const tiles = (column, row) => [60 * column, 60 * row, 90];

test('of a KTX2 texture the same is painted as of a PNG of its texels', async () => {
  const tiled = png(16, 16, (x, y) => tiles(x >> 2, y >> 2));
  const [ofKtx2, ofPng] = await Promise.all([withKtx2(ktx2(4, 4, tiles)), texturedSheet(
    (tree, _, maker) => {
      tree.images[0].bufferView = maker.addView(tiled);
    })].map((file) => bake(file)));
  const imagesIn = async (file) => (await baked(file)).images;
  assert.deepEqual(await imagesIn(ofKtx2), await imagesIn(ofPng));
  assert.equal(ofKtx2.tree.extensionsUsed, undefined);
  assert.equal(ofKtx2.tree.extensionsRequired, undefined);
});

test('beside a KTX2 texture its fallback is painted from', async () => {
  const broken = ktx2(1, 1, tiles).subarray(0, 90);
  const { tree } = await bake(withKtx2(broken, false));
  assert.equal(tree.extensionsUsed, undefined);
  await assert.rejects(bake(withKtx2(broken)), /Image 1 cannot be decoded/);
});

test('KTX2 textures of other formats than ETC1S and UASTC are refused', async () => {
  const other = ktx2(1, 1, tiles);
  other[12] = 37; // VK_FORMAT_R8G8B8A8_UNORM
  await assert.rejects(bake(withKtx2(other)), /neither ETC1S nor UASTC/);
});

test('identifiers in a texture stay with its coordinates, and go with them', async () => {
  const file = texturedSheet((tree, primitive) => {
    const texture = { index: 0, texCoord: 0, channels: [0] };
    primitive.extensions = { EXT_mesh_features: { featureIds: [{ featureCount: 256, texture }] } };
    tree.extensionsUsed = ['EXT_mesh_features'];
  });
  const kept = await outcome(file);
  const { EXT_mesh_features: { featureIds } } = kept.tree.meshes[0].primitives[0].extensions;
  assert.equal(featureIds[0].texture.index, 0);
  assert.ok(!kept.codes.includes('EXTENSION_NOT_CARRIED'));
  const made = await bake(file);
  assert.equal(made.tree.meshes[0].primitives[0].extensions, undefined);
  assert.ok(made.codes.includes('EXTENSION_NOT_CARRIED'));
});

test('animations of materials follow these, or go', async () => {
  const animated = (number) => texturedSheet((tree, primitive, maker) => {
    const [input, output] = [0, 0].map(() => maker.addIndices(Float32Array.of(0, 1)));
    Object.assign(tree.accessors[input], { min: [0], max: [1] });
    const pointer = `/materials/${number}/pbrMetallicRoughness/roughnessFactor`;
    tree.animations = [{ samplers: [{ input, output }], channels: [{ sampler: 0,
      target: { path: 'pointer', extensions: { KHR_animation_pointer: { pointer } } } }] }];
    tree.extensionsUsed = ['KHR_animation_pointer'];
    tree.materials.unshift({ name: 'nobody' });
    primitive.material = 2;
    tree.meshes[0].primitives.push({ attributes: { POSITION: primitive.attributes.POSITION },
      mode: 0, material: 1 });
  });
  const followed = await bake(animated(1));
  const [{ target }] = followed.tree.animations[0].channels;
  const [, , number] = target.extensions.KHR_animation_pointer.pointer.split('/');
  assert.equal(followed.tree.materials[number].name, 'other');
  const gone = await bake(animated(2));
  assert.equal(gone.tree.animations, undefined);
  assert.equal(gone.tree.extensionsUsed, undefined);
  assert.ok(gone.codes.includes('EXTENSION_NOT_CARRIED'));
});
