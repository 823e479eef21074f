// SPDX-License-Identifier: MIT
// How large new textures are if nobody says: as fine as the old ones, but not for the sake of what
// these show several times; as fine as colours of vertices need; and what is lost in files.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { remeshFile } from 'remesher';

import { compileCodec } from '../../bindings/package/platform_node.js';
import { ImageCodecs } from '../../bindings/package/textures/image_codecs.js';
import { baked } from '../support/baked.js';
import { GltfMaker } from '../support/gltf.js';
import { png } from '../support/png.js';
import { sheetOf } from '../support/shapes.js';

const ramp = (x, y) => [9, 99, 8 * (x + y) % 256];

/** Two sheets side by side, the texture's column where each begins, and how wide they are on it. */
function sheets([width, height], begins, wide,
  image = { bytes: png(width, height, ramp), mimeType: 'image/png' }) {
  const [positions, texcoords, indices] = [[], [], []];
  for (let at = 0; at < 81 * begins.length; at += 1) {
    const [n, i, j] = [Math.floor(at / 81), Math.floor(at / 9) % 9, at % 9];
    positions.push(n * 10 + i, j, 0);
    texcoords.push(begins[n] + (wide * i) / 8, (0.65 * j) / 8);
    if (i < 8 && j < 8) indices.push(at, at + 9, at + 10, at, at + 10, at + 1);
  }
  const maker = new GltfMaker();
  Object.assign(maker.tree, {
    images: [{ bufferView: maker.addView(image.bytes), mimeType: image.mimeType }],
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

/** How many texels wide the new texture is. */
async function widthOf({ name, bytes }) {
  const options = { name, vertices: 80, textures: 'bake', textureFormat: 'png' };
  return (await baked(await remeshFile(bytes, options))).images.baseColor.width;
}

test('texels that are shown twice make no larger map, texels side by side do', async () => {
  assert.equal(await widthOf(sheets([512, 512], [0, 0], 1)), 512);
  assert.equal(await widthOf(sheets([1024, 512], [0, 0.5], 0.5)), 1024);
});

/** A sheet of so many cells along a side, its vertices coloured by a formula. */
function colouredSheet(cells, colourAt) {
  const { positions, indices } = sheetOf(cells, (i, j) => [i, j, 0]);
  const colours = sheetOf(cells, colourAt).positions;
  const maker = new GltfMaker();
  return maker.show([{
    attributes: {
      POSITION: maker.add(Float32Array.from(positions), 'VEC3'),
      COLOR_0: maker.add(Float32Array.from(colours), 'VEC3'),
    },
    indices: maker.addIndices(indices),
  }]).glb();
}

test('colours of vertices get texels for their steps, up to a small map of them', async () => {
  const smooth = (i, j) => [i, j, 0].map((x) => 0.3 + x / 200);
  const checks = (i, j) => Array(3).fill((Math.floor(i / 6) + Math.floor(j / 6)) % 2 ? 0.9 : 0.3);
  const sizeOf = (cells, colourAt) => widthOf(colouredSheet(cells, colourAt));
  // Four texels to a triangle, of which there are 1152 and 18,432.
  assert.equal(await sizeOf(24, smooth), 64);
  assert.equal(await sizeOf(96, smooth), 256);
  // A step of 0.4 of what is seen, in every third triangle: a dozen texels along its edges.
  assert.equal(await sizeOf(24, checks), 256);
  assert.equal(await sizeOf(96, checks), 512);
});

test('hundreds of leaves without a texture get a map that is large enough for them', async () => {
  const leaves = 900;
  const corners = [[0, 0], [0.6, 0], [0.6, 0.6], [0, 0.6]];
  const positions = Float32Array.from(Array.from({ length: leaves }, (_, i) =>
    corners.map(([x, y]) => [x + (i % 30), y + Math.floor(i / 30), Math.sin(i)])).flat(2));
  const indices = Uint16Array.from(Array.from({ length: leaves }, (_, i) =>
    [0, 1, 2, 0, 2, 3].map((v) => 4 * i + v)).flat());
  const maker = new GltfMaker();
  maker.tree.materials = [{ pbrMetallicRoughness: { baseColorFactor: [0, 0.4, 0, 1] } }];
  const { name, bytes } = maker.show([{ attributes: { POSITION: maker.add(positions, 'VEC3') },
    indices: maker.addIndices(indices), material: 0 }]).glb();
  const options = { name, textures: 'bake', textureFormat: 'png' };
  const { report } = await remeshFile(bytes, options);
  assert.equal(report.output.components, leaves);
  const error = await remeshFile(bytes, { ...options, textureSize: 64 })
    .then(assert.fail, (fault) => fault);
  assert.match(error.message, /64 texels are too small for 900 charts/);
});

const codecs = new ImageCodecs({ compile: compileCodec });

/** A picture to be a JPEG, its colours by a formula of column, row and number of the byte. */
function pictureOf(width, valueAt) {
  const texels = Uint8Array.from({ length: 4 * width * width }, (_, at) => (at % 4 === 3 ? 255
    : valueAt((at >> 2) % width, Math.floor((at >> 2) / width), at)));
  return { name: '', type: 'image/jpeg', width, height: width, texels };
}

/** How far a JPEG is from an image of steps and noise, of 255, in the mean. */
async function lossOf(width) {
  const picture = pictureOf(width, (x, y, at) =>
    60 + 120 * ((x >> 3) + (y >> 3) & 1) + (7 * x * y + 31 * at) % 17);
  const { texels } = picture;
  const bytes = await codecs.encode(picture);
  const decoded = await codecs.decode({ name: 'decoded', bytes });
  return decoded.texels.reduce((sum, v, at) => sum + Math.abs(v - texels[at]), 0) / texels.length;
}

test('small images, which are seen from near, lose less than large ones', async () => {
  const [small, large] = [await lossOf(512), await lossOf(1024)];
  assert.ok(small < 0.75 * large, `${small}, ${large}`);
});

test('new images take no more bytes than those that they were baked from', async () => {
  const mimeType = 'image/jpeg';
  const waves = pictureOf(512, (x, y, at) =>
    128 + 50 * Math.sin(x / 5 + at % 4) + 50 * Math.sin(x / 11 + y / 3.7));
  const bytes = await codecs.encode({ ...waves, lowered: 6 });
  const model = sheets([512, 512], [0], 1, { bytes, mimeType });
  const { report } = await remeshFile(model.bytes,
    { name: model.name, vertices: 80, textures: 'bake', textureFormat: 'jpeg' });
  const sizes = report.textures.map((texture) => texture.bytes);
  const all = sizes.reduce((sum, size) => sum + size, 0);
  assert.ok(all <= bytes.length, `${sizes} of ${bytes.length}`);
});
