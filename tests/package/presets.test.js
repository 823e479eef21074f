// SPDX-License-Identifier: MIT
// Presets: options for a purpose, from one table, which the options given beside them override.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remesh, remeshFile } from 'remesher';
import { checkOptions, isWorthBaking, optionTable, presets } from 'remesher/options';

import { parseCommandLine } from '../../dist/cli/cli_arguments.js';
import { reportInWords } from '../../dist/cli/report_in_words.js';
import { rejectsWith } from '../support/errors.js';
import { GltfMaker, openGltf, validate, valuesOf } from '../support/gltf.js';
import { png } from '../support/png.js';
import { offText, sheet, sheetOf, torus } from '../support/shapes.js';

const names = optionTable.map(({ name }) => name);
/** What the preset `asset` mends. */
const mended = { repair: 'holes', holesUpTo: 3, keepRims: true };
const ring = torus({ columns: 24, rows: 12 });

test('a preset stands for options of the table, and sets no target', () => {
  for (const { name, values } of presets) {
    const { preset, ...whole } = checkOptions({ preset: name });
    assert.deepEqual(whole, values);
    assert.deepEqual(preset, values);
    assert.ok(Object.keys(values).every((option) => names.includes(option)));
    checkOptions({ ...values, faces: 100 });
  }
});

test('an option given beside a preset overrides it', () => {
  for (const { name, values } of presets) {
    for (const [option, value] of Object.entries(values)) {
      const row = optionTable.find((one) => one.name === option);
      const other = row.choices?.find((choice) => choice !== value)
        ?? (typeof value === 'boolean' ? !value : row.word === value ? 1 : value * 0.9);
      const checked = checkOptions({ preset: name, [option]: other });
      assert.equal(checked[option], other);
      assert.ok(!(option in checked.preset));
    }
  }
});

test('what contradicts an option of a preset overrides it, and the others stay', () => {
  for (const given of [{ quads: true }, { boundary: 'keep' }]) {
    const { preset: stood } = checkOptions({ preset: 'asset', ...given });
    assert.deepEqual(stood,
      { ...mended, dropBelow: 'auto', textures: 'bake', textureFormat: 'webp', compress: 'auto' });
  }
  const kept = checkOptions({ preset: 'asset', textures: 'keep' });
  assert.deepEqual(kept.preset,
    { ...mended, dropBelow: 'auto', prefer: 'shape', compress: 'auto' });
  const { preset: whole } = checkOptions({ preset: 'asset', repair: 'solid', textures: 'keep' });
  assert.deepEqual(whole, { dropBelow: 'auto', prefer: 'shape', compress: 'auto' });
  assert.equal(checkOptions({ preset: 'print', holesUpTo: 5 }).repair, 'auto');
  assert.equal(checkOptions({ preset: 'print', prefer: 'shape' }).maxError, 0.2);
});

test('a run with a preset is the run with its options, and the report names them', async () => {
  const { values } = presets.find(({ name }) => name === 'simulation');
  const asked = { vertices: 200, quality: 'draft' };
  const [one, other] = [await remesh(ring, { preset: 'simulation', ...asked }),
    await remesh(ring, { ...values, ...asked })];
  assert.deepEqual(one.mesh, other.mesh);
  assert.deepEqual(one.report.preset, values);
  assert.equal(other.report.preset, undefined);
  assert.match(reportInWords(one.report),
    new RegExp('^preset, in full: --adaptivity 0.3 --gradation 1.3 --feature-angle 30 '
      + '--min-angle 20 --repair auto\n'));
});

test('nothing is baked where there is nothing to bake from, or no file that would hold it',
  async () => {
    const bytes = new TextEncoder().encode(offText(sheet(8)));
    const asked = { name: 'sheet.off', preset: 'asset', vertices: 60, quality: 'draft' };
    const bare = { ...mended, dropBelow: 'auto', prefer: 'shape' };
    assert.deepEqual((await remeshFile(bytes, { ...asked, output: 'glb' })).report.preset, bare);
    assert.deepEqual((await remesh(ring, { preset: 'asset', vertices: 99 })).report.preset, bare);
  });

test('a model within the budget keeps its textures and triangles, and so do leaves', async () => {
  const maker = (alphaMode, count) => {
    const made = new GltfMaker();
    const { positions, indices } = ring;
    const texcoords = Float32Array.from({ length: positions.length / 3 * 2 }, (_, i) => i % 7 / 7);
    Object.assign(made.tree, {
      images: [{ bufferView: made.addView(png(4, 4, (x, y) => [60 * x, 60 * y, 9])),
        mimeType: 'image/png' }],
      textures: [{ source: 0 }],
      materials: Array.from({ length: count }, () =>
        ({ alphaMode, pbrMetallicRoughness: { baseColorTexture: { index: 0 } } })),
    });
    return made.show(Array.from({ length: count }, (_, material) => ({
      attributes: {
        POSITION: made.add(Float32Array.from(positions, (x) => x + 9 * material), 'VEC3'),
        TEXCOORD_0: made.add(texcoords, 'VEC2'),
      },
      indices: made.addIndices(indices), material,
    }))).glb().bytes;
  };
  const stoodFor = (bytes, faces, more) => remeshFile(bytes,
    { name: 'ring.glb', preset: 'asset', faces, textureSize: 64, ...more });
  const within = await stoodFor(maker('OPAQUE', 1), 5000);
  assert.equal(within.report.preset.textures, undefined);
  assert.equal(within.report.output.triangles, ring.indices.length / 3);
  const { report: { lods } } = await stoodFor(maker('MASK', 1), 5000, { lods: [0.5] });
  assert.ok(lods[0].output.triangles <= ring.indices.length / 6, 'a level has its share of them');
  assert.equal((await stoodFor(maker('MASK', 1), 300)).report.preset.textures, undefined);
  assert.equal((await stoodFor(maker('OPAQUE', 1), 50)).report.preset.textures, 'bake');
  assert.equal((await stoodFor(maker('OPAQUE', 2), 5000)).report.preset.textures, 'bake');
});

test('images that the preset asset keeps become WebP where that is lighter', async () => {
  const wave = (c) => 99 + Math.round(50 * Math.sin(c / 9));
  const pictures = [png(128, 128, (x, y) => [x, y, (x + y) / 2].map(wave)),
    png(1, 1, () => [9, 9, 9])];
  const made = new GltfMaker();
  Object.assign(made.tree, {
    images: pictures.map((bytes) =>
      ({ bufferView: made.addView(bytes), mimeType: 'image/png' })),
    textures: [{ source: 0 }, { source: 1 }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } },
      emissiveTexture: { index: 1 } }],
  });
  const given = made.show([{ attributes: {
    POSITION: made.add(Float32Array.from(ring.positions), 'VEC3'),
    TEXCOORD_0: made.add(new Float32Array(ring.positions.length / 3 * 2), 'VEC2'),
  }, indices: made.addIndices(ring.indices), material: 0 }]).glb().bytes;
  const asked = { name: 'ring.glb', preset: 'asset', faces: 5000 };
  const imagesIn = ({ bytes }) => {
    const { tree, data } = openGltf({ bytes });
    return tree.images.map(({ bufferView }) => {
      const { byteOffset = 0, byteLength } = tree.bufferViews[bufferView];
      return Buffer.from(data.subarray(byteOffset, byteOffset + byteLength));
    });
  };
  const kept = await remeshFile(given, { ...asked, textures: 'keep' });
  pictures.forEach((bytes, i) => assert.ok(imagesIn(kept)[i].equals(bytes), 'asked for'));
  const lighter = await remeshFile(given, asked);
  assert.deepEqual(await validate(lighter), []);
  assert.deepEqual(lighter.report.textures.map(({ type }) => type), ['image/webp', 'image/png']);
  assert.ok(imagesIn(lighter)[1].equals(Buffer.from(pictures[1])), 'hardly becomes smaller');
  assert.ok(lighter.bytes.length < kept.bytes.length);
  const [one, other] = [kept, lighter].map(({ bytes }) => openGltf({ bytes }));
  assert.deepEqual(other.tree.textures.map(({ source }) => source), [undefined, 1]);
  for (const accessor of one.tree.accessors.keys()) {
    assert.deepEqual(valuesOf(other, accessor), valuesOf(one, accessor), 'geometry stays');
  }
});

test('materials of one kind are baked to one; with light and without are two kinds', () => {
  const tree = (materials) => ({ materials, accessors: [{ count: 300 }, { count: 900 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }] });
  const unlit = { extensions: { KHR_materials_unlit: {} } };
  assert.ok(isWorthBaking(tree([{}, {}]), 5000));
  assert.ok(isWorthBaking(tree([unlit, unlit]), 5000));
  for (const other of [unlit, { doubleSided: true }, { alphaMode: 'BLEND' }]) {
    assert.ok(!isWorthBaking(tree([{}, other]), 5000));
  }
});

test('a surface of few seams keeps its textures unless it is reduced much', () => {
  const tree = (vertices, textures, material = {}) => ({ materials: [material], textures,
    accessors: [{ count: vertices }, { count: 3 * 4000 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }] });
  const [hardlyAny, few, many] = [2050, 2500, 12000];
  assert.ok(!isWorthBaking(tree(few, [{}]), 1500));
  assert.ok(isWorthBaking(tree(few, [{}]), 600), 'a normal map shows what shape is lost');
  assert.ok(!isWorthBaking(tree(hardlyAny, [{}]), 600));
  assert.ok(isWorthBaking(tree(hardlyAny, [{}]), 300));
  const blended = tree(few, [{}], { alphaMode: 'BLEND' });
  assert.ok(isWorthBaking(blended, 1500), 'baking shows the drawing order best');
  assert.ok(!isWorthBaking(blended, 5000));
  assert.ok(isWorthBaking(tree(many, [{}]), 3000), 'seams would take most vertices');
  assert.ok(isWorthBaking(tree(few, []), 1500), 'there are no texels to keep');
  assert.ok(!isWorthBaking(tree(few, []), 3000), 'the shape is hardly reduced');
});

test('a result that shows the shape itself gets no map of normals', async () => {
  const made = new GltfMaker();
  const { positions, indices } = sheetOf(20, (i, j) => [i, Math.abs(i - 10), j]);
  const bytes = made.show([{ attributes: { POSITION: made.add(positions, 'VEC3') },
    indices: made.addIndices(indices) }]).glb().bytes;
  const { report } = await remeshFile(bytes,
    { name: 'roof.glb', preset: 'asset', faces: 200, textureSize: 64 });
  assert.equal(report.preset.textures, undefined);
  assert.deepEqual(report.textures, []);
});

test('an unknown preset is refused, and the command line takes one', async () => {
  await rejectsWith(remesh(ring, { preset: 'game' }), 'INVALID_OPTION');
  const words = ['a.glb', '-o', 'b.glb', '--preset', 'asset', '--triangles', '500'];
  const { options } = parseCommandLine([...words, '--texture-size', '64']);
  assert.deepEqual(options, { preset: 'asset', faces: 500, textureSize: 64 });
  assert.throws(() => parseCommandLine(['repair', ...words]), { code: 'INVALID_OPTION' });
});
