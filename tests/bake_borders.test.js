// SPDX-License-Identifier: MIT
// Textures painted anew where the look of a model ends: nothing of one side is seen on the other.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remeshFile } from 'remesher';

import { baked, bilinear, halved, linear } from './support/baked.js';
import { GltfMaker } from './support/gltf.js';

/** Of light. */
const sideColour = (axis, sign) => [0, 1, 2].map((k) => (k === axis ? 1 : 0.3 + 0.3 * sign));

/** A box whose sides are grids, each of one colour. */
function colouredBox(cells) {
  const mesh = { POSITION: [], COLOR_0: [] };
  const indices = [];
  const addCorner = ({ axis, sign }, i, j) => {
    const place = [sign, (2 * i) / cells - 1, sign * ((2 * j) / cells - 1)];
    mesh.POSITION.push(...[0, 1, 2].map((k) => place[(k - axis + 3) % 3]));
    mesh.COLOR_0.push(...sideColour(axis, sign));
    if (i === cells || j === cells) return;
    const at = mesh.POSITION.length / 3 - 1;
    indices.push(at, at + cells + 1, at + cells + 2, at, at + cells + 2, at + 1);
  };
  for (let side = 0; side < 6; side += 1) {
    for (let at = 0; at < (cells + 1) ** 2; at += 1) {
      addCorner({ axis: side >> 1, sign: side % 2 ? -1 : 1 }, Math.floor(at / (cells + 1)),
        at % (cells + 1));
    }
  }
  const maker = new GltfMaker();
  return maker.show([{
    attributes: Object.fromEntries(Object.entries(mesh).map(([name, values]) =>
      [name, maker.add(Float32Array.from(values), 'VEC3')])),
    indices: maker.addIndices(Uint32Array.from(indices)),
  }]).glb();
}

test('where sides of two colours meet each keeps its own, on three mip levels', async () => {
  const { name, bytes } = colouredBox(8);
  const { primitive, images } = await baked(await remeshFile(bytes, { name, vertices: 200,
    textures: 'bake', textureFormat: 'png', textureSize: 1024 }));
  let image = images.baseColor;
  for (let level = 0; level < 3; level += 1) {
    for (const vertex of primitive.indices) {
      const normal = primitive.NORMAL[vertex];
      const axis = normal.findIndex((v) => Math.abs(v) > 0.9);
      const expected = sideColour(axis, Math.sign(normal[axis]));
      bilinear(image, primitive.TEXCOORD_0[vertex]).slice(0, 3).forEach((byte, k) =>
        assert.ok(Math.abs(linear(byte) - expected[k]) < 0.02,
          `level ${level}: ${linear(byte)}, not ${expected[k]}`));
    }
    image = halved(image);
  }
});
