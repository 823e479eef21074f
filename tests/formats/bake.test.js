// SPDX-License-Identifier: MIT
// Baked textures: the right colours, normals and tangents in files that any viewer takes,
// and a sentence for what cannot be painted from.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remesh, remeshFile } from 'remesher';

import { compileCodec } from '../../dist/platform_node.js';
import { ImageCodecs } from '../../dist/textures/image_codecs.js';
import { addChart, columns, layOut, rows, texels } from '../support/atlas_torus.js';
import { baked, colourSteps, forEachTexel, halved, linear, tangentsOf } from '../support/baked.js';
import { rejectsWith } from '../support/errors.js';
import { GltfMaker, openGltf, validate } from '../support/gltf.js';
import { png } from '../support/png.js';
import { offText, torus } from '../support/shapes.js';

const scraps = { around: [0, 8, 16, 24, 32, 40, 48, 56, 64], across: [0, 8, 16, 24, 32] };
const colourOf = (i, j) => [
  Math.round(127 + 100 * Math.cos((2 * Math.PI * i) / columns)),
  Math.round(127 + 100 * Math.cos((2 * Math.PI * j) / rows)), 90];

/** The texture of a torus of scraps. */
const torusTexture = (() => {
  const charts = layOut(scraps);
  return png(texels, texels, (x, y) => {
    const on = charts.find(({ left, top, width, height }) => x >= left - 4 && x < left + width + 4
      && y >= top - 4 && y < top + height + 4) ?? charts[0];
    return colourOf(on.i0 + ((on.i1 - on.i0) * (x + 0.5 - on.left)) / on.width,
      on.j0 + ((on.j1 - on.j0) * (y + 0.5 - on.top)) / on.height);
  });
})();

/** A torus of scraps, its colours continuous over every seam; `change` has a say in it. */
function paintedTorus(change = () => {}) {
  const charts = layOut(scraps);
  const mesh = { positions: [], texcoords: [], indices: [] };
  charts.forEach((chart) => addChart(mesh, chart));
  const maker = new GltfMaker();
  Object.assign(maker.tree, {
    images: [{ bufferView: maker.addView(torusTexture), mimeType: 'image/png' }],
    textures: [{ source: 0 }],
    materials: [{ name: 'paint', pbrMetallicRoughness: {
      baseColorTexture: { index: 0 }, metallicFactor: 0.25 } }],
  });
  const primitive = {
    attributes: {
      POSITION: maker.add(Float32Array.from(mesh.positions), 'VEC3'),
      TEXCOORD_0: maker.add(Float32Array.from(mesh.texcoords), 'VEC2'),
    },
    indices: maker.addIndices(Uint32Array.from(mesh.indices)),
    material: 0,
  };
  maker.show([primitive]);
  change(maker, primitive);
  return maker.glb();
}

const torusFile = paintedTorus();

const bake = (file, options = {}) => remeshFile(file.bytes,
  { name: file.name, resources: file.resources, textures: 'bake', ...options });

/** The torus baked, for the tests that only look at it. */
const bakedTorus = bake(torusFile, { vertices: 300, textureFormat: 'png', textureSize: 512 });

/** How far round and how far across a place on the torus lies, in its columns and rows. */
function onTorus([x, y, z]) {
  const turn = (angle) => (angle / (2 * Math.PI) + 1) % 1;
  return [columns * turn(Math.atan2(y, x)), rows * turn(Math.atan2(z, Math.hypot(x, y) - 2))];
}

/** Whether the colours on a painted torus are where they were. */
function lookRight(model) {
  let [sum, count] = [0, 0];
  forEachTexel(model, ({ position, colour }) => {
    const expected = colourOf(...onTorus(position));
    for (let k = 0; k < 3; k += 1) sum += Math.abs(colour[k] - expected[k]);
    count += 3;
  });
  assert.ok(count > 10_000);
  assert.ok(sum / count / 255 < 0.01, `${(100 * sum) / count / 255} % off`);
}

test('colours are where they were, in one atlas, and the old image is gone', async () => {
  const result = await bakedTorus;
  assert.deepEqual(await validate(result), []);
  assert.equal(result.report.output.vertices, 300);
  const model = await baked(result);
  assert.deepEqual(model.tree.images.map(({ name }) => name).sort(), ['baseColor', 'normal']);
  const [material] = model.tree.materials;
  assert.equal(material.name, 'paint');
  assert.equal(material.pbrMetallicRoughness.metallicFactor, 0.25);
  lookRight(model);
});

test('seams hold no vertices: angles are as on a surface without any', async () => {
  const { report: keep } =
    await remeshFile(torusFile.bytes, { name: torusFile.name, vertices: 300 });
  const { report } = await bakedTorus;
  assert.ok(report.output.minAngle.mean > 54, `${report.output.minAngle.mean}°`);
  assert.ok(report.output.minAngle.mean > keep.output.minAngle.mean);
});

test('the same bytes every time, in the calling thread, too', async () => {
  const options = { vertices: 150, textureSize: 64 };
  const first = await bake(torusFile, options);
  const second = await bake(torusFile, { ...options, worker: false });
  assert.deepEqual(first.bytes, second.bytes);
});

test('tangents are those of MikkTSpace, and written where the file had some', async () => {
  const without = openGltf(await bakedTorus).tree.meshes[0].primitives[0].attributes;
  assert.deepEqual(Object.keys(without).sort(), ['NORMAL', 'POSITION', 'TEXCOORD_0']);
  const given = paintedTorus((maker, { attributes }) => {
    const { count } = maker.tree.accessors[attributes.POSITION];
    attributes.NORMAL = maker.add(new Float32Array(3 * count).fill(Math.sqrt(1 / 3)), 'VEC3');
    const tangent = [Math.SQRT1_2, -Math.SQRT1_2, 0, 1];
    attributes.TANGENT = maker.add(
      Float32Array.from({ length: 4 * count }, (_, i) => tangent[i % 4]), 'VEC4');
  });
  const { primitive } = await baked(await bake(given, { vertices: 300, textureFormat: 'png' }));
  const expected = tangentsOf(primitive);
  primitive.indices.forEach((vertex, i) => {
    const own = primitive.TANGENT[vertex];
    for (let k = 0; k < 3; k += 1) assert.ok(Math.abs(own[k] - expected[i][k]) < 1e-4);
    assert.equal(own[3], expected[i][3]);
  });
});

/** A sphere with waves in its normals and colours, by formulas. */
const waves = ([x, y, z]) => {
  const bent = [x + 0.15 * Math.cos(9 * y), y + 0.15 * Math.cos(9 * z), z + 0.15 * Math.cos(9 * x)];
  const length = Math.hypot(...bent);
  return {
    normal: bent.map((v) => v / length),
    colour: [x, y, z].map((v) => 0.5 + 0.3 * Math.sin(5 * v)),
  };
};

function wavySphere() {
  const [around, down] = [120, 60];
  const positions = [];
  for (let j = 0; j <= down; j += 1) {
    for (let i = 0; i <= around; i += 1) {
      const [a, b] = [(2 * Math.PI * (i % around)) / around, (Math.PI * j) / down];
      const ring = j === down ? 0 : Math.sin(b);
      positions.push([ring * Math.cos(a), ring * Math.sin(a), Math.cos(b)]);
    }
  }
  const indices = [];
  for (let j = 0; j < down; j += 1) {
    for (let i = 0; i < around; i += 1) {
      const at = j * (around + 1) + i;
      if (j < down - 1) indices.push(at, at + around + 1, at + around + 2);
      if (j > 0) indices.push(at, at + around + 2, at + 1);
    }
  }
  const maker = new GltfMaker();
  return maker.show([{
    attributes: {
      POSITION: maker.add(Float32Array.from(positions.flat()), 'VEC3'),
      NORMAL: maker.add(Float32Array.from(positions.flatMap((p) => waves(p).normal)), 'VEC3'),
      COLOR_0: maker.add(Float32Array.from(positions.flatMap((p) => waves(p).colour)), 'VEC3'),
    },
    indices: maker.addIndices(Uint32Array.from(indices)),
  }]).glb();
}

test('normals and colours of vertices are painted as the formulas say', async () => {
  const result = await bake(wavySphere(),
    { vertices: 300, textureFormat: 'png', textureSize: 256 });
  assert.deepEqual(await validate(result), []);
  const model = await baked(result);
  let [angles, colours, count] = [0, 0, 0];
  forEachTexel(model, ({ position, normal, colour }) => {
    const length = Math.hypot(...position);
    const expected = waves(position.map((v) => v / length));
    const cosine = normal.reduce((sum, v, k) => sum + v * expected.normal[k], 0);
    angles += Math.acos(Math.min(1, cosine)) ** 2;
    for (let k = 0; k < 3; k += 1) {
      colours += Math.abs(linear(colour[k]) - expected.colour[k]) / 3;
    }
    count += 1;
  });
  const rms = (Math.sqrt(angles / count) * 180) / Math.PI;
  assert.ok(rms < 2, `normals ${rms}° rms`);
  assert.ok(colours / count < 0.01, `colours ${(100 * colours) / count} %`);
});

/** Steps over borders beside steps within, at each mip level. `wide`: from that level on the charts
 * of others are so near that an edge is the measure. */
async function seams({ levels, wide }, options) {
  const model = await baked(await bake(torusFile, { textureFormat: 'png', ...options }));
  const shares = [];
  for (let image = model.images.baseColor; shares.length < levels; image = halved(image)) {
    const { over, edge, texel } = colourSteps(model, image);
    shares.push(over / (shares.length < wide ? texel : edge));
  }
  return shares;
}

/** In small maps it is chance which charts are beside each other: the median of three bakes. */
async function showsNoSeam(textureSize, depth) {
  const bakes = await Promise.all([297, 300, 303].map((vertices) =>
    seams(depth, { vertices, textureSize })));
  bakes[0].forEach((_, level) => {
    const shares = bakes.map((all) => all[level]).sort((x, y) => x - y);
    assert.ok(shares[1] <= 1, `${textureSize} texels, level ${level}: ${shares.join(', ')}`);
  });
}

test('no seam shows, on five mip levels', () => showsNoSeam(1024, { levels: 5, wide: 4 }));

test('no seam shows in small maps, on four', () => showsNoSeam(256, { levels: 4, wide: 4 }));

test('materials that differ only in their maps become one; others stay apart', async () => {
  const small = torus({ columns: 16, rows: 8, radius: 0.5, tube: 0.2 });
  const file = paintedTorus((maker) => {
    const lone = (material, height) => ({
      attributes: { POSITION: maker.add(small.positions.map((v, i) =>
        (i % 3 === 2 ? v + height : v)), 'VEC3') },
      indices: maker.addIndices(small.indices),
      material,
    });
    maker.tree.materials.push({ pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1] } },
      { alphaMode: 'BLEND', pbrMetallicRoughness: { baseColorFactor: [0, 1, 0, 0.5] } });
    maker.tree.meshes[0].primitives.push(lone(1, 3), lone(2, 6));
  });
  const result = await bake(file, { vertices: 600, textureFormat: 'png', textureSize: 256 });
  assert.deepEqual(await validate(result), []);
  const { tree } = openGltf(result);
  assert.deepEqual(tree.materials.map(({ alphaMode }) => alphaMode), [undefined, 'BLEND']);
  assert.equal(tree.meshes[0].primitives.length, 2);
  // What is the same all over stays a factor.
  assert.deepEqual(tree.materials[1].pbrMetallicRoughness.baseColorFactor, [0, 1, 0, 0.5]);
  assert.equal(tree.materials[1].pbrMetallicRoughness.baseColorTexture, undefined);
});

test('images in every format, in and out, within a .glb and beside a .gltf', async () => {
  const options = { vertices: 150, textureSize: 64 };
  for (const textureFormat of ['png', 'jpeg', 'webp']) {
    const result = await bake(torusFile, { ...options, textureFormat });
    assert.deepEqual(await validate(result), []);
    const { tree } = openGltf(result);
    const { mimeType } = tree.images.find(({ name }) => name === 'baseColor');
    assert.equal(mimeType, `image/${textureFormat}`);
    const again = await bake({ name: 'again.glb', bytes: result.bytes },
      { ...options, output: 'gltf' });
    assert.deepEqual(await validate(again), []);
    const ending = textureFormat === 'webp' ? 'webp' : 'jpg';  // WebP stays WebP
    assert.ok(again.files.some(({ name }) => name === `again_baseColor.${ending}`));
  }
});

/** A map of normals that lean a little. @param {'image/jpeg' | 'image/png'} type */
function leaning(type) {
  const width = 64;
  const pixels = Uint8Array.from({ length: 4 * width * width }, (_, at) =>
    [118 + (at >> 4) % 20, 128, 250, 255][at % 4]);
  return new ImageCodecs({ compile: compileCodec })
    .encode({ name: '', type, width, height: width, texels: pixels });
}

test('maps of normals stay JPEG if they were, and the report lists the images', async () => {
  for (const type of /** @type {const} */ (['image/jpeg', 'image/png'])) {
    const normals = await leaning(type);
    const file = paintedTorus((maker) => {
      const { tree } = maker;
      const view = maker.addView(normals);
      tree.images.push({ bufferView: view, mimeType: type });
      tree.textures.push({ source: 1 });
      tree.materials[0].normalTexture = { index: 1 };
    });
    const result = await bake(file, { vertices: 150, textureSize: 64 });
    assert.deepEqual(await validate(result), []);
    const { tree } = openGltf(result);
    assert.equal(tree.images.find(({ name }) => name === 'normal').mimeType, type);
    assert.deepEqual(result.report.textures.map((one) => [one.name, one.type, one.width]),
      tree.images.map(({ name, mimeType }) => [name, mimeType, 64]));
    assert.deepEqual(result.report.textures.map(({ bytes }) => bytes), tree.images.map((image) =>
      tree.bufferViews[image.bufferView].byteLength));
    const { textures } = await inspect(file.bytes, { name: 'a.glb' });
    assert.deepEqual(textures[1], { name: '1', type, width: 64, height: 64,
      bytes: normals.length });
  }
});

test('variants of materials are lost, which a warning says', async () => {
  const variants = (value) => ({ KHR_materials_variants: value });
  const result = await bake(paintedTorus(({ tree }, primitive) => {
    tree.extensions = variants({ variants: [{ name: 'red' }] });
    tree.extensionsUsed = Object.keys(tree.extensions);
    primitive.extensions = variants({ mappings: [{ material: 0, variants: [0] }] });
  }), { vertices: 150, textureSize: 64 });
  assert.deepEqual(await validate(result), []);
  assert.match(JSON.stringify(result.report.warnings), /Variants of materials/);
});

test('what cannot be painted from is said in a sentence', async () => {
  const withImage = (image) => paintedTorus((maker) => {
    maker.tree.images[0] = image;
  });
  const withBytes = (bytes) => withImage(
    { uri: `data:image/png;base64,${Buffer.from(bytes).toString('base64')}` });
  const whole = png(4, 4, () => [1, 2, 3]), huge = whole.slice();
  huge.set([0, 0, 0x27, 0x10, 0, 0, 0x27, 0x10], 16);
  await rejectsWith(bake(withImage({ uri: 'nowhere.png' })), 'MISSING_RESOURCE', /nowhere\.png/);
  for (const broken of [null, { uri: 7 }, { uri: 'data:image/png;base64,@' }]) {
    await rejectsWith(bake(withImage(broken)), 'MISSING_RESOURCE', /Image 0/);
  }
  await rejectsWith(bake(withBytes(whole.subarray(0, 50))), 'PARSE_ERROR', /Image 0/);
  await rejectsWith(bake(withBytes(huge)), 'UNSUPPORTED', /10000 × 10000/);
  const animated = new Uint8Array(30);
  animated.set(Buffer.from('RIFF\0\0\0\0WEBPVP8X\n\0\0\0\x02'));
  await rejectsWith(bake(withBytes(animated)), 'UNSUPPORTED', /animated/);
  await rejectsWith(bake(withBytes([1, 2, 3, 4])), 'UNSUPPORTED', /neither PNG/);
  await rejectsWith(bake(torusFile, { output: 'obj' }), 'UNSUPPORTED', /glTF/);
  await rejectsWith(bake(torusFile, { textureSize: 4, vertices: 2000 }), 'INVALID_OPTION',
    /too small/);
  const { positions, indices } = torus({ columns: 16, rows: 8 });
  const off = new TextEncoder().encode(offText({ positions, indices }));
  await rejectsWith(bake({ name: 'made.off', bytes: off }, { output: 'glb' }),
    'UNSUPPORTED', /made\.off/);
  await rejectsWith(remesh({ positions, indices }, { textures: 'bake' }),
    'INVALID_OPTION', /files/);
});

test('a scan with coloured vertices becomes a textured model', async () => {
  const { positions, indices } = torus({ columns, rows });
  const places = Array.from({ length: positions.length / 3 },
    (_, v) => positions.subarray(3 * v, 3 * v + 3));
  const corners = Array.from({ length: indices.length / 3 },
    (_, t) => indices.subarray(3 * t, 3 * t + 3));
  const bytes = new TextEncoder().encode(['ply', 'format ascii 1.0',
    `element vertex ${places.length}`, ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
    ...['red', 'green', 'blue'].map((channel) => `property uchar ${channel}`),
    `element face ${corners.length}`, 'property list uchar int vertex_indices', 'end_header',
    ...places.map((place) => [...place, ...colourOf(...onTorus(place))].join(' ')),
    ...corners.map((corner) => `3 ${corner.join(' ')}`), ''].join('\n'));
  const result = await bake({ name: 'scan.ply', bytes },
    { vertices: 300, textureFormat: 'png', textureSize: 256, output: 'glb' });
  assert.deepEqual(await validate(result), []);
  const model = await baked(result);
  lookRight(model);
  // Nothing says that it is of metal.
  assert.equal(model.tree.materials[0].pbrMetallicRoughness.metallicFactor, 0);
});

/** The torus as an OBJ; its library names the texture, and one that nobody paints from. */
function objOfTorus() {
  const charts = layOut(scraps);
  const mesh = { positions: [], texcoords: [], indices: [] };
  charts.forEach((chart) => addChart(mesh, chart));
  const lines = ['mtllib paint.mtl', 'usemtl paint'];
  for (let v = 0; v < mesh.positions.length / 3; v += 1) {
    lines.push(`v ${mesh.positions.slice(3 * v, 3 * v + 3).join(' ')}`,
      `vt ${mesh.texcoords[2 * v]} ${1 - mesh.texcoords[2 * v + 1]}`);
  }
  for (let t = 0; t < mesh.indices.length; t += 3) {
    lines.push(`f ${mesh.indices.slice(t, t + 3).map((v) => `${v + 1}/${v + 1}`).join(' ')}`);
  }
  const library = 'newmtl paint\nmap_Kd -s 1 1 1 the paint.png\nmap_Bump bumps.png\n';
  const encode = (text) => new TextEncoder().encode(text);
  return { name: 'torus.obj', bytes: encode(`${lines.join('\n')}\n`),
    resources: { 'paint.mtl': encode(library), 'the paint.png': torusTexture } };
}

test('an OBJ is painted from what its material library says', async () => {
  const file = objOfTorus();
  const options = { vertices: 300, textureFormat: 'png', textureSize: 512, output: 'glb' };
  const result = await bake(file, options);
  assert.deepEqual(await validate(result), []);
  const model = await baked(result);
  lookRight(model);
  assert.equal(model.tree.materials[0].name, 'paint');
  assert.equal(model.tree.materials[0].pbrMetallicRoughness.metallicFactor, 0);
  const codes = result.report.warnings.map(({ code }) => code);
  assert.ok(codes.includes('MAP_NOT_PAINTED') && !codes.includes('MATERIAL_IMAGES_NOT_READ'));
  delete file.resources['the paint.png'];
  await rejectsWith(bake(file, options), 'MISSING_RESOURCE', /the paint\.png/);
});

test('coordinates beyond the square, and a texture of two materials', async () => {
  const file = paintedTorus((maker, primitive) => {
    const { bufferView } = maker.tree.accessors[primitive.attributes.TEXCOORD_0];
    const bytes = maker.views[bufferView];
    const coordinates = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
    coordinates.forEach((value, i) => {
      coordinates[i] = value + (i % 2 ? -2 : 3);
    });
    const all = maker.views[maker.tree.accessors[primitive.indices].bufferView];
    const indices = new Uint32Array(all.buffer, all.byteOffset, all.length / 4);
    const [paint] = maker.tree.materials;
    maker.tree.materials.push({ ...paint, name: 'more' });
    const half = indices.length / 2;
    primitive.indices = maker.addIndices(indices.slice(0, half));
    maker.tree.meshes[0].primitives.push(
      { ...primitive, indices: maker.addIndices(indices.slice(half)), material: 1 });
  });
  const result = await bake(file, { vertices: 300, textureFormat: 'png', textureSize: 512 });
  assert.deepEqual(await validate(result), []);
  const model = await baked(result);
  assert.equal(model.tree.meshes[0].primitives.length, 1);
  lookRight(model);
});

test('a texture without coordinates, and coordinates far outside, are no hindrance', async () => {
  const bare = paintedTorus((_, primitive) => delete primitive.attributes.TEXCOORD_0);
  assert.deepEqual(await validate(await bake(bare, { vertices: 150, textureSize: 64 })), []);
  const far = paintedTorus((maker, primitive) => {
    const { bufferView } = maker.tree.accessors[primitive.attributes.TEXCOORD_0];
    const bytes = maker.views[bufferView];
    const values = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
    values[0] = 1e30;
    values[1] = NaN;
  });
  assert.deepEqual(await validate(await bake(far, { vertices: 150, textureSize: 64 })), []);
});

test('texture coordinates that baked maps do not use go with a warning', async () => {
  const file = paintedTorus((maker, { attributes }) => {
    attributes.TEXCOORD_1 = attributes.TEXCOORD_0;
  });
  const { report } = await remeshFile(file.bytes, { name: file.name, vertices: 300,
    textures: 'bake', textureSize: 64, quality: 'draft' });
  assert.ok(report.warnings.some(({ code, message }) => code === 'ATTRIBUTE_NOT_CARRIED'
    && message.includes('TEXCOORD_1')));
});
