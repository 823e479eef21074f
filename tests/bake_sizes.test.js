// SPDX-License-Identifier: MIT
// How large new textures are if nobody says: as fine as the old ones, but not for the sake of what
// these show several times.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remeshFile } from 'remesher';

import { baked } from './support/baked.js';
import { GltfMaker } from './support/gltf.js';
import { png } from './support/png.js';

/** Two sheets side by side, the texture's column where each begins, and how wide they are on it. */
function sheets([width, height], begins, wide) {
  const [positions, texcoords, indices] = [[], [], []];
  for (let at = 0; at < 81 * begins.length; at += 1) {
    const [n, i, j] = [Math.floor(at / 81), Math.floor(at / 9) % 9, at % 9];
    positions.push(n * 10 + i, j, 0);
    texcoords.push(begins[n] + (wide * i) / 8, (0.65 * j) / 8);
    if (i < 8 && j < 8) indices.push(at, at + 9, at + 10, at, at + 10, at + 1);
  }
  const maker = new GltfMaker();
  Object.assign(maker.tree, {
    images: [{ bufferView: maker.addView(png(width, height, () => [9, 99, 199])),
      mimeType: 'image/png' }],
    textures: [{ source: 0 }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
  });
  return maker.show([{
    attributes: {
      POSITION: maker.add(Float32Array.from(positions), 'VEC3'),
      TEXCOORD_0: maker.add(Float32Array.from(texcoords), 'VEC2'),
    },
    indices: maker.addIndices(Uint32Array.from(indices)),
    material: 0,
  }]).glb();
}

test('texels that are shown twice make no larger map, texels side by side do', async () => {
  const sizeOf = async ({ name, bytes }) => {
    const options = { name, vertices: 80, textures: 'bake', textureFormat: 'png' };
    return (await baked(await remeshFile(bytes, options))).images.baseColor.width;
  };
  assert.equal(await sizeOf(sheets([512, 512], [0, 0], 1)), 512);
  assert.equal(await sizeOf(sheets([1024, 512], [0, 0.5], 0.5)), 1024);
});
