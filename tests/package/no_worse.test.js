// SPDX-License-Identifier: MIT
// What is wrong in a file that is read all the same makes nothing worse: the validator finds
// nothing in the result that it did not find before.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remeshFile } from 'remesher';

import { files } from '../fuzz/made_files.js';
import { shapes } from '../fuzz/made_shapes.js';
import { GltfMaker, openGltf } from '../support/gltf.js';
import { lawsOfErrors, lawsOfFiles } from '../support/laws.js';

const shape = shapes.ball(2);

/** A made file whose tree was changed, and the words of that. */
function changed(kind, change, rewrite = (text) => text) {
  const { tree, data } = openGltf(files[kind](shape));
  change(tree);
  const words = Buffer.from(data).toString('base64');
  tree.buffers[0].uri = `data:application/octet-stream;base64,${words}`;
  return { name: 'a.gltf', bytes: new TextEncoder().encode(rewrite(JSON.stringify(tree))) };
}

const float = 5126;

/** What is wrong, a file that is so, and with which options. @type {[string, any, object][]} */
const cases = [
  ['a rotation of numbers that nobody can hold', changed('skinned', () => {},
    (text) => text.replace('0.6', '1e999')), { vertices: 10 }],
  ['a quantised bound of numbers that nobody can hold', changed('quantized', () => {},
    (text) => text.replace(/"max":\[\d+/, '"max":[1e999')), { vertices: 10 }],
  ['inverse bind matrices that are none', changed('skinned', (tree) => {
    tree.skins[0].inverseBindMatrices = tree.meshes[0].primitives[0].attributes.POSITION;
  }), { featureAngle: 1 }],
  ['inverse bind matrices out of range', changed('skinned', (tree) => {
    const { bufferView } = tree.accessors[tree.meshes[0].primitives[0].attributes.WEIGHTS_0];
    tree.skins[0].inverseBindMatrices = tree.accessors.push(
      { bufferView, componentType: float, count: 3, type: 'MAT4' }) - 1;
    delete tree.bufferViews[bufferView].byteStride;
  }), { featureAngle: 1 }],
  ['texture coordinates of a type that means nothing', changed('textured', (tree) => {
    Object.assign(tree, { images: [{ uri: 'data:image/png;base64,' }], textures: [{ source: 0 }] });
    tree.materials[0].pbrMetallicRoughness = { baseColorTexture: { index: 0 } };
    const { attributes } = tree.meshes[0].primitives[0];
    attributes.TEXCOORD_0 = attributes.POSITION;
  }), { ratio: 0.5 }],
  ['texture coordinates fewer than vertices', changed('textured', (tree) => {
    tree.accessors[tree.meshes[0].primitives[0].attributes.TEXCOORD_0].count -= 1;
  }), { ratio: 0.5 }],
  ['bounds that are not those of the data', changed('quantized', (tree) => {
    const accessor = tree.accessors[tree.meshes[0].primitives[0].attributes.POSITION];
    [accessor.min, accessor.max] = [[-1, 0.5, 0], [3, 32767, 1]];
  }), { vertices: 30, adaptivity: 1 }],
  ['quantised bounds of few vertices', files.quantized(shape), { vertices: 12, adaptivity: 1 }],
];

for (const [what, { name, bytes }, options] of cases) {
  test(`nothing is worse for ${what}`, async () => {
    const result = await remeshFile(bytes, { name, ...options }).catch((error) => error);
    if (!result.bytes) {
      assert.deepEqual(lawsOfErrors(result), []);
      return;
    }
    assert.deepEqual(await lawsOfFiles({ name, bytes }, result), []);
    const { tree } = openGltf(result);
    assert.ok(!JSON.stringify(tree).includes('null'));
  });
}

test('a strip of many is no mesh of 0 vertices', async () => {
  const maker = new GltfMaker();
  const positions = Float32Array.from(Array.from({ length: 60 }, (_, i) =>
    [i >> 1, i & 1, 0.1 * Math.sin(i)]).flat());
  maker.show([{ attributes: { POSITION: maker.add(positions, 'VEC3') }, mode: 5 }]);
  const { bytes } = maker.glb();
  const { report } = await remeshFile(bytes, { name: 'a.glb' });
  assert.equal(report.input.vertices, 60);
  const error = await remeshFile(bytes, { name: 'a.glb', vertices: 2 }).then(assert.fail, (e) => e);
  assert.match(error.message, /target of 2 vertices/);
});
