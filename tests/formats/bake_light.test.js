// SPDX-License-Identifier: MIT
// Baked textures and light: normals that no shape explains stay, what is shown without light
// gets no normals to carry, and what light shines through is drawn in its order.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remeshFile } from 'remesher';

import { baked, forEachTexel } from '../support/baked.js';
import { GltfMaker, validate } from '../support/gltf.js';
import { torus } from '../support/shapes.js';

const bake = ({ name, bytes }) => remeshFile(bytes,
  { name, vertices: 150, textures: 'bake', textureFormat: 'png', textureSize: 128 });

/** A torus in two colours, above others, as a primitive; `more`: of its attributes. */
function addTorus(maker, { height = 0, material, ...more }) {
  const { positions, indices } = torus();
  const colours = positions.map((v, at) => (at % 3 ? 0.2 : Number(v > 0)));
  const add = (values) => maker.add(Float32Array.from(values), 'VEC3');
  return {
    attributes: {
      POSITION: add(positions.map((v, at) => (at % 3 === 2 ? v + height : v))),
      COLOR_0: add(colours),
      ...Object.fromEntries(Object.entries(more).map(([name, of]) => [name, add(of(positions))])),
    },
    indices: maker.addIndices(indices),
    material,
  };
}

/** A turn that takes up to up, and each direction about it by as much. */
const turned = ([x, y, z], [cos, sin]) => [cos * x - sin * y, sin * x + cos * y, z];

/** A torus baked whose normals are what a function says of their places. */
async function bakedLit(normalAt) {
  const maker = new GltfMaker();
  maker.tree.materials = [{}];
  const NORMAL = (positions) => Array.from({ length: positions.length / 3 },
    (_, v) => normalAt(positions.subarray(3 * v, 3 * v + 3))).flat();
  const result = await bake(maker.show([addTorus(maker, { material: 0, NORMAL })]).glb());
  assert.deepEqual(await validate(result), []);
  return baked(result);
}

const up = [0, 0.6, 0.8];

test('a body lit as no body of its shape would be stays lit so', async () => {
  for (const [what, normalAt] of Object.entries({
    'lit from one side': () => up,
    'lit like a sphere about it': ([x, y, z]) => [x, y, z].map((v) => v / Math.hypot(x, y, z)),
    'turned by 120° about its axis': (place) => {
      const [x, y] = turned(place, [-0.5, Math.sqrt(0.75)]);
      return [x / Math.hypot(x, y), y / Math.hypot(x, y), 0];
    },
  })) {
    const angles = [];
    forEachTexel(await bakedLit(normalAt), ({ position, normal }) => {
      const cosine = normalAt(position).reduce((sum, v, k) => sum + v * normal[k], 0);
      angles.push((180 / Math.PI) * Math.acos(Math.min(1, cosine)));
    });
    angles.sort((a, b) => a - b);
    const most = angles[Math.floor(0.98 * angles.length)];
    assert.ok(angles.length > 2000 && most < 6, `${what}: ${most}° in 98 % of the texels`);
  }
});

// Between vertices that are lit so and others viewers show streaks: each mixes the frames of a
// triangle's corners in its own way.
test('a body lit from one side is lit so at all of its vertices', async () => {
  const { primitive: { NORMAL } } = await bakedLit(() => up);
  for (const normal of NORMAL) normal.forEach((v, k) => assert.ok(Math.abs(v - up[k]) < 1e-6));
});

test('what is shown without light gets no normal maps', async () => {
  const maker = new GltfMaker();
  Object.assign(maker.tree, {
    extensionsUsed: ['KHR_materials_unlit'],
    materials: [{ name: 'shown', extensions: { KHR_materials_unlit: {} } }, { name: 'lit' }],
  });
  const shown = addTorus(maker, { material: 0 });
  const [alone, ofBoth] = await Promise.all([[], [addTorus(maker, { material: 1, height: 3 })]]
    .map(async (others) => {
      const result = await bake(maker.show([shown, ...others]).glb());
      assert.deepEqual(await validate(result), []);
      return (await baked(result)).tree;
    }));
  assert.deepEqual(alone.images.map(({ name }) => name), ['baseColor']);
  assert.ok(alone.accessors.every(({ type }) => type !== 'VEC4'));
  assert.equal(ofBoth.images.filter(({ name }) => name === 'normal').length, 1);
  for (const { material } of ofBoth.meshes[0].primitives) {
    const { name, normalTexture } = ofBoth.materials[material];
    assert.equal(normalTexture !== undefined, name === 'lit');
  }
});

test('what can be seen through is drawn in the order that it was drawn in', async () => {
  const maker = new GltfMaker();
  maker.tree.materials = [{ alphaMode: 'BLEND' }];
  const { positions, indices } = torus();
  const height = (vertex) => positions[3 * vertex + 2];
  const upwards = Array.from({ length: indices.length / 3 },
    (_, t) => [...indices.subarray(3 * t, 3 * t + 3)]).sort(([a], [b]) => height(a) - height(b));
  const drawn = { ...addTorus(maker, { material: 0 }),
    indices: maker.addIndices(Uint32Array.from(upwards.flat())) };
  const { primitive } = await baked(await bake(maker.show([drawn]).glb()));
  // A triangle is drawn when that of the original is on which it lies in part, and which starts at
  // most a row of them, 0.21, below that part.
  let highest = -1;
  for (let t = 0; t < primitive.indices.length; t += 3) {
    const heights = Array.from(primitive.indices.slice(t, t + 3),
      (vertex) => primitive.POSITION[vertex][2]);
    assert.ok(Math.max(...heights) > highest - 0.21, `${heights} after ${highest}`);
    highest = Math.max(highest, Math.min(...heights));
  }
});
