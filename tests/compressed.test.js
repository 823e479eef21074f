// SPDX-License-Identifier: MIT
// Compressed glTF that is not what it says: refused in a sentence, whatever the decoders make
// of it.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { decompress } from '../dist/codecs/decompress.js';
import { openContainer, packGlb } from '../bindings/package/codecs/gltf_container.js';
import { draco, meshopt, runCompressedCase } from './fuzz/compressed_case.js';
import { rejectsWith } from './support/errors.js';

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
