// SPDX-License-Identifier: MIT
// What a file says of what is made anew goes or follows: extensions, animations, and what the file
// declares to need.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remeshFile } from 'remesher';

import { GltfMaker, openGltf, validate } from '../support/gltf.js';
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

test('beside a KTX2 texture its fallback is painted from', async () => {
  const both = (tree, _, maker) => {
    const ktx = Uint8Array.of(0xAB, ...new TextEncoder().encode('KTX 20'), 0xBB, 13, 10, 26, 10);
    tree.images.push({ bufferView: maker.addView(ktx), mimeType: 'image/ktx2' });
    tree.textures[0].extensions = { KHR_texture_basisu: { source: 1 } };
    tree.extensionsUsed = ['KHR_texture_basisu'];
  };
  const { tree } = await bake(texturedSheet(both));
  assert.equal(tree.extensionsUsed, undefined);
  const alone = texturedSheet((...args) => {
    both(...args);
    delete args[0].textures[0].source;
  });
  await assert.rejects(bake(alone), /KTX2 texture, which cannot be painted from/);
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
  const baked = await bake(file);
  assert.equal(baked.tree.meshes[0].primitives[0].extensions, undefined);
  assert.ok(baked.codes.includes('EXTENSION_NOT_CARRIED'));
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
