// SPDX-License-Identifier: MIT
// Where repair makes another surface textures are baked, from what is seen; where it closes
// holes they stay.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remeshFile, repairFile } from 'remesher';

import { addChart, layOut, texels } from '../support/atlas_torus.js';
import { baked, forEachTexel } from '../support/baked.js';
import { GltfMaker, validate } from '../support/gltf.js';
import { png } from '../support/png.js';
import { torus } from '../support/shapes.js';

const seen = [200, 60, 40];
const hidden = [20, 220, 30];
const image = png(64, 64, (x) => (x < 32 ? seen : hidden));

/** A torus of one colour with another in it, of another colour, that nobody sees. */
function shells(isWhole = true) {
  const { positions, indices } = torus({ columns: 32, rows: 16 });
  const maker = new GltfMaker();
  Object.assign(maker.tree, {
    images: [{ bufferView: maker.addView(image), mimeType: 'image/png' }],
    textures: [{ source: 0 }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0 } }],
  });
  const inner = Array.from(positions, (_, i) => {
    const [a, b, c] = positions.slice(i - (i % 3), i - (i % 3) + 3);
    const ring = Math.hypot(a, b) / 2;
    return [a / ring + 0.7 * (a - a / ring), b / ring + 0.7 * (b - b / ring), 0.7 * c][i % 3];
  });
  const count = positions.length / 3;
  const texcoords = Array.from({ length: 4 * count }, (_, i) =>
    (i % 2 ? 0.5 : 0.25 + (i < 2 * count ? 0 : 0.5)));
  const outside = isWhole ? [] : Array.from(indices).slice(30);
  maker.show([{
    attributes: {
      POSITION: maker.add(Float32Array.from([...positions, ...inner]), 'VEC3'),
      TEXCOORD_0: maker.add(Float32Array.from(texcoords), 'VEC2'),
    },
    indices: maker.addIndices(Uint32Array.from(isWhole
      ? [...indices, ...Array.from(indices, (v) => v + count)] : outside)),
    material: 0,
  }]);
  return maker.glb();
}

const mended = (file, options) => remeshFile(file.bytes,
  { name: file.name, output: 'glb', vertices: 800, textureFormat: 'png', ...options });

const isPainted = ({ report }) =>
  report.warnings.some(({ code }) => code === 'TEXTURES_PAINTED');

test('a sound glTF comes back from repair byte for byte, however its buffer ends', async () => {
  const { positions, indices } = torus({ columns: 12, rows: 8 });
  for (const ending of [4, 8]) {
    const maker = new GltfMaker();
    maker.show([{ attributes: { POSITION: maker.add(positions, 'VEC3') },
      indices: maker.addIndices(indices) }]);
    maker.addView(new Uint8Array(ending));
    for (const { name, bytes } of [maker.glb(), maker.embedded()]) {
      const repaired = await repairFile(bytes, { name, repair: 'auto' });
      assert.deepEqual(repaired.bytes, bytes, `${name}, ${ending}`);
    }
  }
});

test('a body without its inner shell keeps its texture, exactly', async () => {
  const result = await mended(shells(), { repair: 'auto' });
  assert.equal(result.report.repair.reason, 'united');
  assert.ok(!isPainted(result));
  assert.deepEqual(await validate(result), []);
});

test('a wrap is painted from the visible surface, never from an inner shell', async () => {
  const result = await mended(shells(), { repair: 'wrap', textureSize: 256 });
  assert.equal(result.report.repair.mode, 'wrap');
  assert.ok(isPainted(result));
  assert.deepEqual(await validate(result), []);
  let count = 0;
  forEachTexel(await baked(result), ({ colour }) => {
    for (let k = 0; k < 3; k += 1) assert.ok(Math.abs(colour[k] - seen[k]) < 8, `${colour}`);
    count += 1;
  });
  assert.ok(count > 1000, `${count}`);
});

test('textures are kept where that is asked for, and where only holes are closed', async () => {
  const kept = { repair: 'solid', textures: 'keep', textureFormat: undefined };
  assert.ok(!isPainted(await mended(shells(), kept)));
  const closed = await mended(shells(false), { repair: 'auto' });
  assert.equal(closed.report.repair.mode, 'holes');
  assert.ok(!isPainted(closed));
});

/** A torus of two charts, one colour above the middle and another below. */
function twoCharts() {
  const mesh = { positions: [], texcoords: [], indices: [] };
  for (const chart of layOut({ around: [0, 64], across: [0, 16, 32] })) addChart(mesh, chart);
  const maker = new GltfMaker();
  Object.assign(maker.tree, {
    images: [{ bufferView: maker.addView(png(texels, texels,
      (x, y) => (y < texels / 2 ? seen : hidden))), mimeType: 'image/png' }],
    textures: [{ source: 0 }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0 } }],
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
}

test('a border of charts is as straight on a surface made anew as on the model', async () => {
  const result = await mended(twoCharts(), { repair: 'wrap', textures: 'bake', textureSize: 512 });
  let [wrong, count] = [0, 0];
  forEachTexel(await baked(result), ({ position: [, , z], colour: [red] }) => {
    if (Math.abs(z) < 0.02) return;  // of a tube 0.8 thick: where texels of both colours meet
    count += 1;
    wrong += (red > 110) === (z > 0) ? 0 : 1;
  });
  assert.ok(count > 10_000);
  assert.equal(wrong, 0, `${wrong} of ${count} texels have the other colour`);
});
