// SPDX-License-Identifier: MIT
// Baked maps that say the same everywhere become factors of their materials.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withImages } from '../../dist/textures/gltf_images.js';
import { oneValue } from '../../dist/textures/plain_maps.js';

const side = 4;
/** An image of one colour, but for one texel. */
const picture = (color, odd = color) => ({ width: side, height: side, texels: Uint8Array.from(
  { length: 4 * side * side }, (_, i) => (i < 4 ? odd : color)[i % 4]) });

/** A .gltf with a material of these images, by the names of its maps. */
function result(images) {
  const names = Object.keys(images);
  const info = (name) => ({ index: names.indexOf(name) });
  const has = (name) => (name in images ? { [name]: info(name) } : {});
  const material = { pbrMetallicRoughness: { ...has('baseColorTexture'),
    ...has('metallicRoughnessTexture') }, ...has('normalTexture'), ...has('emissiveTexture'),
  ...('metallicRoughnessTexture' in images
    ? { occlusionTexture: info('metallicRoughnessTexture') } : {}) };
  const tree = { asset: { version: '2.0' }, materials: [material],
    textures: names.map((_, i) => ({ source: i })),
    images: names.map((_, i) => ({ uri: `painting:${i}`, mimeType: 'image/png' })) };
  const encoded = Object.values(images).map((image, i) => ({ name: `map${i}`, type: 'image/png',
    bytes: new Uint8Array(9), value: oneValue(image) }));
  const [file, ...beside] = withImages(
    [{ name: 'a.gltf', bytes: new TextEncoder().encode(JSON.stringify(tree)) }], encoded);
  return { tree: JSON.parse(new TextDecoder().decode(file.bytes)), beside };
}

test('an image has one value if its texels differ by no more than is seen', () => {
  assert.deepEqual(oneValue(picture([9, 8, 7, 255])), [9, 8, 7, 255]);
  assert.deepEqual(oneValue(picture([9, 8, 7, 255], [11, 8, 7, 255])), [10, 8, 7, 255]);
  assert.equal(oneValue(picture([9, 8, 7, 255], [12, 8, 7, 255])), undefined);
});

test('maps of one value become factors, and flat normals are left out', () => {
  const { tree, beside } = result({
    baseColorTexture: picture([255, 188, 0, 51]), normalTexture: picture([128, 127, 255, 255]),
    metallicRoughnessTexture: picture([255, 51, 102, 255]),
    emissiveTexture: picture([0, 0, 255, 255]),
  });
  const [{ pbrMetallicRoughness: pbr, ...rest }] = tree.materials;
  assert.deepEqual(pbr.baseColorFactor.map((x) => x.toFixed(1)), ['1.0', '0.5', '0.0', '0.2']);
  assert.deepEqual([pbr.roughnessFactor, pbr.metallicFactor], [0.2, 0.4]);
  assert.deepEqual(Object.keys(pbr).filter((name) => name.endsWith('Texture')), []);
  assert.deepEqual(rest, { emissiveFactor: [0, 0, 1] });
  assert.deepEqual([tree.textures, tree.images, beside], [undefined, undefined, []]);
});

test('maps that say something stay, under new numbers', () => {
  const { tree, beside } = result({
    baseColorTexture: picture([255, 188, 0, 255]), normalTexture: picture([140, 127, 255, 255]),
    metallicRoughnessTexture: picture([128, 51, 102, 255]),
    emissiveTexture: picture([0, 0, 255, 255], [0, 90, 255, 255]),
  });
  const [material] = tree.materials;
  assert.equal(material.pbrMetallicRoughness.baseColorTexture, undefined);
  // Normals that all lean are no flat map, and dimmed light is no factor of a material.
  assert.deepEqual(beside.map(({ name }) => name),
    ['a_map1.png', 'a_map2.png', 'a_map3.png']);
  const shown = ({ index }) => tree.images[tree.textures[index].source].uri;
  assert.equal(shown(material.normalTexture), 'a_map1.png');
  assert.equal(shown(material.occlusionTexture), 'a_map2.png');
  assert.equal(shown(material.emissiveTexture), 'a_map3.png');
});
