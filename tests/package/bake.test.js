// SPDX-License-Identifier: MIT
// Baking onto a mesh of one's own, and unwrapping: colours arrive, seams do not show, the low mesh
// stays as it is, and what cannot be done is said in a sentence.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { bake, bakeFile, unwrap, unwrapFile } from 'remesher';
import { Pool } from 'remesher/pool';

import { parseCommandLine } from '../../dist/cli/cli_arguments.js';
import { reportInWords } from '../../dist/cli/report_in_words.js';
import { baked, bilinear } from '../support/baked.js';
import { rejectsWith } from '../support/errors.js';
import { validate } from '../support/gltf.js';
import { paintedBoxes } from '../support/painted_boxes.js';
import { octahedron, stl, torus } from '../support/shapes.js';

const bytesOf = (text) => new TextEncoder().encode(text);
const high = torus({ columns: 96, rows: 48 });
const low = torus({ columns: 24, rows: 12 });

/** A soft pattern: fractions of red, green and blue. */
const colourAt = (x, y, z) => [0.5 + 0.4 * Math.sin(x), 0.5 + 0.4 * Math.sin(y), 0.5 + 0.4 * z];

const placesOf = ({ positions }) => Array.from({ length: positions.length / 3 }, (_, v) =>
  [...positions.subarray(3 * v, 3 * v + 3)]);

/** An OBJ, with a colour for each vertex if there is a pattern, and lines that are quads. */
function objText(mesh, { colour, quads = false } = {}) {
  const lines = placesOf(mesh).map((place) =>
    `v ${[...place, ...(colour ? colour(...place) : [])].join(' ')}`);
  const step = quads ? 6 : 3;
  for (let i = 0; i < mesh.indices.length; i += step) {
    const [a, b, c, , , d] = [...mesh.indices.subarray(i, i + 6)].map((v) => v + 1);
    lines.push(`f ${(quads ? [a, b, c, d] : [a, b, c]).join(' ')}`);
  }
  return bytesOf(`${lines.join('\n')}\n`);
}

/** A glTF with materials that show images of 8192 × 8192 texels; of each there is the header. */
function largeImages(count) {
  const header = Buffer.alloc(40);
  header.write('\x89PNG\r\n\x1a\n\0\0\0\rIHDR', 'latin1');
  header.writeUInt32BE(8192, 16);
  header.writeUInt32BE(8192, 20);
  const each = (make) => Array.from({ length: count }, (_, i) => make(i));
  const image = { uri: `data:image/png;base64,${header.toString('base64')}` };
  return bytesOf(JSON.stringify({ asset: { version: '2.0' }, images: each(() => image),
    textures: each((source) => ({ source })), materials: each((index) => (
      { pbrMetallicRoughness: { baseColorTexture: { index } } })) }));
}

/** Per copy of a place the largest difference of a channel from the first copy's colour. */
function stepsOverSeams({ POSITION, TEXCOORD_0 }, image) {
  const first = new Map();
  return POSITION.flatMap((position, v) => {
    const colour = bilinear(image, TEXCOORD_0[v]);
    const known = first.get(position.join());
    if (!known) first.set(position.join(), colour);
    return known ? [Math.max(...[0, 1, 2].map((k) => Math.abs(colour[k] - known[k])))] : [];
  });
}

const options = { name: 'high.obj', nameLow: 'low.obj', textureSize: 256, textureFormat: 'png',
  worker: false };

test('colours of vertices come to a coarser mesh, without seams that show', async () => {
  const { bytes, report } = await bakeFile(objText(high, { colour: colourAt }), objText(low),
    options);
  assert.deepEqual(await validate({ bytes }), []);
  assert.ok(report.atlas.notFound <= 1);
  assert.equal(report.atlas.given, false);
  assert.equal(report.output.vertices, report.input.vertices);
  assert.equal(report.output.triangles, report.input.triangles);
  const model = await baked({ bytes });
  const { baseColor } = model.images;
  let error = 0;
  model.primitive.TEXCOORD_0.forEach((uv, v) => {
    const expected = colourAt(...model.primitive.POSITION[v]);
    const found = bilinear(baseColor, uv);
    error += expected.reduce((sum, value, k) => sum + Math.abs(255 * value - found[k]), 0) / 3;
  });
  assert.ok(error / model.primitive.TEXCOORD_0.length < 6);
  const steps = stepsOverSeams(model.primitive, baseColor);
  assert.ok(steps.length > 0);
  const mean = steps.reduce((sum, step) => sum + step, 0) / steps.length;
  assert.ok(mean <= 0.02 * 255, `the mean step over seams is ${mean}`);
  assert.match(reportInWords(report), /texture coordinates \(new\): \d+ charts/);
});

test('quads stay quads', async () => {
  const { bytes } = await bakeFile(objText(high, { colour: colourAt }),
    objText(low, { quads: true }), options);
  const { tree } = await baked({ bytes });
  assert.ok(tree.extensionsUsed?.includes('FB_ngon_encoding'));
});

test('a textured file is baked onto itself with its own texture coordinates or new ones',
  async () => {
    const { bytes: given, name } = paintedBoxes();
    const { report } = await bakeFile(given, given, { ...options, name, nameLow: name });
    // Its sides share the cells of a palette.
    assert.ok(report.warnings.some(({ code }) => code === 'TEXCOORDS_REPLACED'));
    assert.equal(report.atlas.given, false);
    const unwrapped = await unwrapFile(given, { name, output: 'boxes.glb', worker: false });
    assert.ok(unwrapped.report.warnings.some(({ code }) => code === 'IMAGES_NOT_FITTING'));
    const again = await bakeFile(given, unwrapped.bytes,
      { ...options, name, nameLow: 'boxes.glb' });
    assert.equal(again.report.atlas.given, true);
  });

test('what is not found is said, and a larger cage finds it', async () => {
  const away = { ...low, positions: low.positions.map((x, i) => (i % 3 === 2 ? x + 0.5 : x)) };
  const wide = { ...options, cage: 20 };
  const far = await bakeFile(objText(high), objText(away), { ...options, cage: 1 });
  assert.ok(far.report.warnings.some(({ code }) => code === 'TEXELS_NOT_FOUND'));
  const near = await bakeFile(objText(high), objText(away), wide);
  assert.ok(near.report.atlas.notFound < far.report.atlas.notFound / 2);
});

test('of arrays the maps come as bytes, and the pool gives the same', async () => {
  const colours = Float32Array.from(placesOf(high).flatMap((place) => colourAt(...place)));
  const painted = { ...high, attributes: { COLOR_0: { array: colours, itemSize: 3 } } };
  const { mesh, maps, report } = await bake(painted, low, { textureSize: 64, ao: true });
  assert.deepEqual(Object.keys(maps).sort(), ['baseColor', 'normal', 'surface']);
  for (const { width, height, data } of Object.values(maps)) {
    assert.deepEqual([width, height, data.length], [64, 64, 4 * 64 * 64]);
  }
  assert.deepEqual(mesh.positions.subarray(0, low.positions.length), low.positions);
  assert.equal(mesh.indices.length, low.indices.length);
  assert.ok(report.atlas.charts > 0);
  const pool = new Pool({ size: 1 });
  const again = await pool.bake(painted, low, { textureSize: 64, ao: true });
  const alone = await pool.unwrap(low);
  pool.close();
  assert.deepEqual(again.maps, maps);
  assert.deepEqual(alone.mesh, (await unwrap(low)).mesh);
});

test('unwrapped files have the same triangles and new texture coordinates', async () => {
  for (const output of ['out.obj', 'out.ply', 'out.off', 'out.glb']) {
    const { report, bytes } = await unwrapFile(objText(low), { name: 'low.obj', output });
    assert.equal(report.output.triangles, report.input.triangles);
    assert.ok(report.atlas.coverage > 25 && report.atlas.worstStretch < 1.6);
    if (output === 'out.obj') assert.match(new TextDecoder().decode(bytes), /^vt /m);
  }
});

test('what cannot be done is refused in a sentence', async () => {
  const file = objText(low);
  await rejectsWith(unwrapFile(stl(octahedron()), { name: 'a.stl' }), 'UNSUPPORTED',
    /Texture coordinates cannot be written/);
  await rejectsWith(bakeFile(file, file, { ...options, output: 'a.obj' }), 'UNSUPPORTED',
    /glTF only/);
  await rejectsWith(bakeFile(largeImages(17), file, options), 'OUT_OF_MEMORY',
    /^high\.obj: Decoded, its 17 images take 4\.56 GB of memory; there are 4\.03 GB, enough for /);
  await rejectsWith(bake(low, low, { vertices: 9 }), 'INVALID_OPTION', /does not remesh: vertices/);
  await rejectsWith(unwrap(low, { cage: 9 }), 'INVALID_OPTION', /does not remesh: cage/);
  for (const [words, pattern] of [
    ['bake a.glb -o b.glb', /needs the model to paint onto/],
    ['bake a.glb b.glb --onto c.glb -o d.glb', /one model to paint from, not 2/],
    ['bake a.glb --onto b.glb -o c/', /writes one file/],
    ['bake a.glb --onto b.glb -o c.glb --faces 9', /does not remesh: --faces/],
    ['unwrap a.glb -o b.glb --ao', /does not remesh: --ao/],
    ['a.glb --onto b.glb -o c.glb', /--onto is for remesher bake/],
  ]) assert.throws(() => parseCommandLine(words.split(' ')), pattern);
});
