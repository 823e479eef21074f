// SPDX-License-Identifier: MIT
// Baked textures where the look of a model ends: nothing of one side is seen on the other.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remeshFile } from 'remesher';

import { baked, bilinear, halved, linear } from '../support/baked.js';
import { GltfMaker } from '../support/gltf.js';

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

/** How far the light at the corners of a baked box is from their sides' colours, at most. */
function strayLight({ primitive }, image) {
  return Math.max(...primitive.indices.map((vertex, corner) => {
    const triangle = primitive.indices.slice(corner - corner % 3, corner - corner % 3 + 3)
      .map((v) => primitive.POSITION[v]);
    const axis = [0, 1, 2].find((k) => triangle.every((p) => p[k] === triangle[0][k]));
    const expected = sideColour(axis, Math.sign(triangle[0][axis]));
    const seen = bilinear(image, primitive.TEXCOORD_0[vertex]);
    return Math.max(...expected.map((value, k) => Math.abs(linear(seen[k]) - value)));
  }));
}

/** A mip level looks beyond a chart's corner by one and a half of its own texels, each way:
 * `levels` are those for which the padding is enough, 2 texels of 256 and 4 of 1024; the next,
 * which needs 3 and 6, depends on what lies beside the corner. */
async function keepsColours(textureSize, levels) {
  const { name, bytes } = colouredBox(8);
  const model = await baked(await remeshFile(bytes,
    { name, vertices: 200, textures: 'bake', textureFormat: 'png', textureSize }));
  let image = model.images.baseColor;
  for (let level = 0; level < levels; level += 1) {
    const stray = strayLight(model, image);
    assert.ok(stray < 0.02, `${textureSize} texels, level ${level}: ${stray}`);
    image = halved(image);
  }
}

test('where sides of two colours meet each keeps its own, on two mip levels',
  () => keepsColours(1024, 2));

test('in small maps, too', () => keepsColours(256, 1));
