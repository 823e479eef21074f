// SPDX-License-Identifier: MIT
// Baked textures with levels of detail, which share one set of maps, and with quads, which survive.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remeshFile } from 'remesher';

import { addChart, layOut, texels, wide } from '../support/atlas_torus.js';
import { GltfMaker, openGltf, validate, valuesOf } from '../support/gltf.js';
import { png } from '../support/png.js';

/** A torus of six charts in a texture of stripes. */
const file = (() => {
  const mesh = { positions: [], texcoords: [], indices: [] };
  for (const chart of layOut(wide)) addChart(mesh, chart);
  const maker = new GltfMaker();
  Object.assign(maker.tree, {
    images: [{ bufferView: maker.addView(png(texels, texels, (x, y) => [x / 2, y / 2, 90])),
      mimeType: 'image/png' }],
    textures: [{ source: 0 }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
  });
  maker.show([{
    attributes: {
      POSITION: maker.add(Float32Array.from(mesh.positions), 'VEC3'),
      TEXCOORD_0: maker.add(Float32Array.from(mesh.texcoords), 'VEC2'),
    },
    indices: maker.addIndices(Uint32Array.from(mesh.indices)),
    material: 0,
  }]);
  return maker.glb();
})();

const bake = (options) => remeshFile(file.bytes, { name: file.name, textures: 'bake',
  textureFormat: 'png', textureSize: 128, quality: 'draft', ...options });

/** The only primitive of each mesh of a file, and its values by attribute. */
function primitivesOf(result) {
  const opened = openGltf(result);
  return opened.tree.meshes.map(({ primitives: [{ attributes, indices, ...rest }] }) => ({
    ...rest, indices: valuesOf(opened, indices).flat(),
    ...Object.fromEntries(Object.entries(attributes)
      .map(([name, accessor]) => [name, valuesOf(opened, accessor)])) }));
}

test('levels of detail share the maps of the finest, its vertices and places on them', async () => {
  const result = await bake({ faces: 1000, lods: [0.5, 0.25] });
  assert.deepEqual(await validate(result), []);
  const alone = openGltf(await bake({ faces: 1000 })).tree;
  const { tree } = openGltf(result);
  assert.equal(tree.images.length, alone.images.length);
  assert.equal(tree.materials.length, 1);
  const [finest, ...levels] = primitivesOf(result);
  assert.deepEqual([finest, ...levels].map(({ indices }) => indices.length / 3), [1000, 500, 250]);
  const used = tree.meshes.map(({ primitives: [{ attributes }] }) => attributes);
  assert.deepEqual(used, [used[0], used[0], used[0]], 'one set of vertices');
  const corners = new Set(finest.POSITION.map((p, i) => `${p} ${finest.TEXCOORD_0[i]}`));
  for (const level of levels) {
    assert.equal(level.material, finest.material);
    const others = level.POSITION.filter((p, i) => !corners.has(`${p} ${level.TEXCOORD_0[i]}`));
    assert.deepEqual(others, []);
  }
  const distances = [result.report, ...result.report.lods].map(({ fidelity }) => fidelity.rms);
  assert.deepEqual(distances, distances.toSorted((a, b) => a - b));
});

test('levels may be files of their own, each with its maps', async () => {
  const result = await bake({ vertices: 400, lods: [0.5], lodFiles: true });
  assert.equal(result.files.length, 2);
  for (const one of result.files) {
    assert.deepEqual(await validate({ ...one, files: [one] }), []);
    assert.ok(openGltf(one).tree.images.length > 0);
  }
});

test('quads keep their pairs of triangles when their textures are baked', async () => {
  const result = await bake({ vertices: 300, quads: true });
  assert.deepEqual(await validate(result), []);
  const [{ indices, extensions, TEXCOORD_0 }] = primitivesOf(result);
  assert.ok(extensions.FB_ngon_encoding);
  assert.equal(indices.length, 6 * result.report.output.quads.count);
  for (let i = 0; i < indices.length; i += 6) {
    const [a, b, c, d, e, f] = indices.slice(i, i + 6);
    assert.deepEqual([d, e], [a, c], 'two triangles of a quad begin alike and share an edge');
    assert.notEqual(a, indices[i + 6], 'the next quad begins elsewhere');
    assert.ok([b, f].every((corner) => TEXCOORD_0[corner]));
  }
});
