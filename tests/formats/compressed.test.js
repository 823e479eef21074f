// SPDX-License-Identifier: MIT
// Compressed glTF that is not what it says: refused in a sentence, whatever the decoders make
// of it.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { settleAccessors } from '../../dist/codecs/decoded_accessors.js';
import { decompress } from '../../dist/codecs/decompress.js';
import { openContainer, packGlb } from '../../bindings/package/codecs/gltf_container.js';
import { draco, meshopt, runCompressedCase } from '../fuzz/compressed_case.js';
import { rejectsWith } from '../support/errors.js';

/** The file after `damage` was done to its tree. */
function damaged(file, damage) {
  const { text, chunk } = openContainer(file.bytes);
  const tree = JSON.parse(text);
  damage(tree);
  return { ...file, bytes: packGlb(tree, chunk), resources: [] };
}

const dracoOf = (tree) => tree.meshes[0].primitives[0].extensions.KHR_draco_mesh_compression;
const meshoptOf = (tree) => tree.bufferViews[0].extensions.EXT_meshopt_compression;

test('what Draco decodes must be what the accessors say', async () => {
  const refuses = (damage, pattern) =>
    rejectsWith(decompress(damaged(draco, damage)), 'PARSE_ERROR', pattern);
  await refuses((tree) => (dracoOf(tree).attributes.POSITION = 7), /attribute 7 is not among/);
  await refuses((tree) => (tree.accessors[1].type = 'VEC3'), /another type/);
  await refuses((tree) => (tree.accessors[0].componentType = 5121), /another type/);
});

test('the layouts that meshopt is asked for are those it has', async () => {
  const refuses = (damage) => rejectsWith(decompress(damaged(meshopt, damage)), 'PARSE_ERROR',
    /laid out as none can be/);
  const bad = [['byteStride', 0], ['byteStride', 7], ['byteStride', 1024], ['byteStride', '12'],
    ['count', -1], ['count', 0.5], ['count', null], ['mode', 'TRIANGLES'], ['mode', 'toString'],
    ['filter', 'QUATERNION'], ['filter', 'constructor']];
  for (const [member, value] of bad) await refuses((tree) => (meshoptOf(tree)[member] = value));
});

test('ranges begin and end within their buffer', async () => {
  const ranges = [{ byteOffset: -8 }, { byteLength: -1 }, { byteOffset: 2 ** 40 }];
  for (const range of ranges) {
    await rejectsWith(decompress(damaged(meshopt, (tree) => Object.assign(meshoptOf(tree), range))),
      'PARSE_ERROR', /beyond its buffer/);
  }
});

test('spoilt files are decoded, or refused in a sentence of our own', async () => {
  for (let seed = 1; seed <= 200; seed += 1) assert.deepEqual(await runCompressedCase(seed), []);
});

test('bounds are of what was compressed, and matrices of joints are affine', async () => {
  const matrix = Float32Array.from({ length: 16 }, (_, i) => (i === 6 ? NaN : i + 1));
  const contents = [Int16Array.of(3, -7, 0, 0, 12, 5, 0, 0), matrix, Float32Array.of(0, Infinity)]
    .map(({ buffer }) => new Uint8Array(buffer));
  const tree = {
    bufferViews: [{ byteStride: 8 }, {}, {}],
    accessors: [
      { bufferView: 0, componentType: 5122, type: 'VEC2', count: 2, min: [0, 0], max: [1, 1] },
      { bufferView: 1, componentType: 5126, type: 'MAT4', count: 1 },
      { bufferView: 2, componentType: 5126, type: 'SCALAR', count: 2, min: [0], max: [1] },
      { bufferView: 0, componentType: 5122, type: 'VEC2', count: 3, min: [0, 0] }],
    skins: [{ inverseBindMatrices: 1 }],
    animations: [{ samplers: [{ input: 2, output: 2 }] }],
  };
  settleAccessors(tree, contents, new Set([0, 1, 2]));
  assert.deepEqual([tree.accessors[0].min, tree.accessors[0].max], [[3, -7], [12, 5]]);
  assert.deepEqual([3, 6, 7, 11, 15].map((i) => matrix[i]), [0, 0, 0, 0, 1]);
  assert.deepEqual([tree.accessors[2].min, tree.accessors[2].max], [[0], [0]]);
  assert.deepEqual(tree.accessors[3].min, [0, 0]); // not all there: the core says so
});

test('a number that nothing holds is refused, not written as null', async () => {
  const file = damaged(meshopt, (tree) => { tree.nodes = [{ scale: [1, 1, 123456789] }]; });
  const text = Buffer.from(file.bytes).toString('latin1').replace('123456789', '1e9999999');
  const huge = { ...file, bytes: new Uint8Array(Buffer.from(text, 'latin1')) };
  await rejectsWith(decompress(huge), 'PARSE_ERROR', /\/nodes\/0\/scale\/2 is a number beyond all/);
});
