// SPDX-License-Identifier: MIT
// A textured glTF goes in, a textured glTF comes out, whatever real files use: each kind of file
// is made here, remeshed, judged by the validator and read back.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remeshFile } from 'remesher';

import { dracoCompressed, meshoptCompressed } from '../support/compressed.js';
import { rejectsWith } from '../support/errors.js';
import { GltfMaker, openGltf, validate, valuesOf } from '../support/gltf.js';
import { sheet, torus } from '../support/shapes.js';

const { positions, indices } = sheet(24);
const small = Uint16Array.from(indices);
const count = positions.length / 3;
const perVertex = (make) => Array.from({ length: count }, (_, i) =>
  make(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2])).flat();
// The texture lies flat on the sheet, so that texture coordinates must be places.
const texcoords = Float32Array.from(perVertex((x, y) => [x, y]));
const whole = (array, Kind, one) => Kind.from(array, (value) => Math.round(value * one));
const png = Uint8Array.from(Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42'
  + 'mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg==', 'base64'));

/** A textured sheet; `change` has a say in its maker and primitive. */
function texturedSheet(change = () => {}) {
  const maker = new GltfMaker();
  const primitive = {
    attributes: {
      POSITION: maker.add(positions, 'VEC3'),
      TEXCOORD_0: maker.add(texcoords, 'VEC2'),
    },
    indices: maker.addIndices(small),
  };
  maker.show([primitive]);
  change(maker, primitive);
  return maker;
}

/** Every third texture coordinate replaced by a wrong one, which a sparse accessor puts right. */
function withSparseValues(maker, primitive) {
  const wrong = texcoords.map((value, i) => (i % 6 < 2 ? value + 0.5 : value));
  const rows = Uint16Array.from({ length: Math.ceil(count / 3) }, (_, i) => 3 * i);
  const right = Float32Array.from([...rows].flatMap((i) =>
    [...texcoords.subarray(2 * i, 2 * i + 2)]));
  primitive.attributes.TEXCOORD_0 = maker.add(wrong, 'VEC2');
  maker.tree.accessors[primitive.attributes.TEXCOORD_0].sparse = sparse(maker, rows, right);
}

/** A sparse accessor that replaces zeros, which are nowhere. */
function withSparseZeros(maker, primitive) {
  const rows = Uint32Array.from({ length: count - 1 }, (_, i) => i + 1);  // the first one is zero
  const accessor = { componentType: 5126, count, type: 'VEC2' };
  primitive.attributes.TEXCOORD_0 = maker.describe(
    { ...accessor, sparse: sparse(maker, rows, texcoords.slice(2)) });
}

function sparse(maker, rows, values) {
  const componentType = rows instanceof Uint16Array ? 5123 : 5125;
  return {
    count: rows.length,
    indices: { bufferView: maker.addView(rows), componentType },
    values: { bufferView: maker.addView(values) },
  };
}

function withIntegers(maker, primitive) {
  primitive.attributes.TEXCOORD_0 =
    maker.add(whole(texcoords, Uint16Array, 65535), 'VEC2', { normalized: true });
  primitive.attributes.COLOR_0 =
    maker.add(Uint8Array.from(perVertex((x) => [255, Math.round(255 * x), 0])), 'VEC3',
      { normalized: true });
}

function withQuantization(maker, primitive) {
  maker.tree.extensionsUsed = ['KHR_mesh_quantization'];
  maker.tree.extensionsRequired = ['KHR_mesh_quantization'];
  primitive.attributes.POSITION = maker.add(whole(positions, Int16Array, 16000), 'VEC3');
  maker.tree.nodes[0].scale = [1 / 16000, 1 / 16000, 1 / 16000];
  primitive.attributes.NORMAL =
    maker.add(Int8Array.from(perVertex(() => [0, 0, 127])), 'VEC3', { normalized: true });
}

function withTexture(maker, primitive) {
  Object.assign(maker.tree, {
    extensionsUsed: ['KHR_texture_transform'],
    images: [{ bufferView: maker.addView(png), mimeType: 'image/png' }],
    samplers: [{ wrapS: 33071 }],
    textures: [{ source: 0, sampler: 0 }],
    materials: [{
      name: 'paper',
      extras: { grams: 80 },
      pbrMetallicRoughness: {
        baseColorTexture: {
          index: 0, extensions: { KHR_texture_transform: { offset: [0.25, 0.5], rotation: 1 } },
        },
      },
    }],
  });
  primitive.material = 0;
}

function interleaved() {
  const maker = new GltfMaker();
  const rows = new Float32Array(5 * count);
  for (let i = 0; i < count; i += 1) {
    rows.set(positions.subarray(3 * i, 3 * i + 3), 5 * i);
    rows.set(texcoords.subarray(2 * i, 2 * i + 2), 5 * i + 3);
  }
  const bufferView = maker.addView(rows, { byteStride: 20 });
  const accessor = { bufferView, componentType: 5126, count };
  return maker.show([{
    attributes: {
      POSITION: maker.describe({ ...accessor, type: 'VEC3' }, positions),
      TEXCOORD_0: maker.describe({ ...accessor, type: 'VEC2', byteOffset: 12 }),
    },
    indices: maker.addIndices(small),
  }]);
}

/** Left and right half as primitives of two materials, sharing their vertices. */
function shared() {
  return texturedSheet((maker, primitive) => {
    const halves = [[], []];
    for (let i = 0; i < small.length; i += 3) {
      const triangle = [...small.subarray(i, i + 3)];
      const centre = triangle.reduce((sum, v) => sum + positions[3 * v], 0) / 3;
      halves[centre < 0.5 ? 0 : 1].push(...triangle);
    }
    maker.tree.materials = [{ name: 'left' }, { name: 'right' }];
    maker.tree.accessors.pop();
    maker.tree.bufferViews.pop();
    maker.views.pop();
    maker.show(halves.map((half, material) =>
      ({ ...primitive, indices: maker.addIndices(Uint16Array.from(half)), material })));
  });
}

const withIndices = (Kind) => () => {
  if (Kind !== Uint8Array) {
    return texturedSheet((maker, primitive) =>
      (primitive.indices = maker.addIndices(Kind.from(indices)))).glb();
  }
  // 15 × 15 vertices are as many as a byte counts.
  const tiny = sheet(14);
  const maker = new GltfMaker();
  const flat = Float32Array.from(tiny.positions.filter((_, i) => i % 3 < 2));
  return maker.show([{
    attributes: {
      POSITION: maker.add(tiny.positions, 'VEC3'),
      TEXCOORD_0: maker.add(flat, 'VEC2'),
    },
    indices: maker.addIndices(Uint8Array.from(tiny.indices)),
  }]).glb();
};

function withoutIndices() {
  const maker = new GltfMaker();
  const unrolled = (values, width) => Float32Array.from(Array.from(small)
    .flatMap((v) => [...values.subarray(width * v, width * (v + 1))]));
  return maker.show([{
    attributes: {
      POSITION: maker.add(unrolled(positions, 3), 'VEC3'),
      TEXCOORD_0: maker.add(unrolled(texcoords, 2), 'VEC2'),
    },
  }]).glb();
}

const kinds = {
  'a GLB': () => texturedSheet().glb(),
  'a .gltf with its .bin': () => texturedSheet().gltf(),
  'a data URI': () => texturedSheet().embedded(),
  'a sparse accessor': () => texturedSheet(withSparseValues).glb(),
  'a sparse accessor of zeros': () => texturedSheet(withSparseZeros).glb(),
  'normalised integers': () => texturedSheet(withIntegers).glb(),
  'KHR_mesh_quantization': () => texturedSheet(withQuantization).glb(),
  'KHR_texture_transform': () => texturedSheet(withTexture).glb(),
  'interleaved buffers': () => interleaved().glb(),
  'no indices': withoutIndices,
  'indices of bytes': withIndices(Uint8Array),
  'indices of shorts': withIndices(Uint16Array),
  'indices of ints': withIndices(Uint32Array),
  'shared accessors': () => shared().glb(),
  'EXT_meshopt_compression': () => meshoptCompressed(texturedSheet().glb()),
  'KHR_draco_mesh_compression': () => dracoCompressed({ positions, indices, texcoords }),
};

/** Per primitive its positions in the world (the node may scale) and texture coordinates. */
function flatVertices(opened) {
  const [{ scale = [1, 1, 1] }] = opened.tree.nodes;
  return opened.tree.meshes[0].primitives.map(({ attributes }) => ({
    places: valuesOf(opened, attributes.POSITION).map((p) => p.map((x, k) => x * scale[k])),
    texcoords: valuesOf(opened, attributes.TEXCOORD_0),
  }));
}

for (const [kind, make] of Object.entries(kinds)) {
  test(`${kind}: remeshed to an exact count, valid, its texture where it was`, async () => {
    const { bytes, ...options } = await make();
    const result = await remeshFile(bytes, { ...options, vertices: 400 });
    assert.equal(result.report.output.vertices, 400);
    assert.deepEqual(await validate(result), []);
    for (const { places, texcoords: found } of flatVertices(openGltf(result))) {
      places.forEach(([x, y], i) => {
        const distance = Math.hypot(found[i][0] - x, found[i][1] - y);
        assert.ok(distance < 0.01, `texture moved by ${distance} at ${x}, ${y}`);
      });
    }
  });
}

test('encodings, materials, images and texture transforms come out as they went in', async () => {
  const maker = texturedSheet((...all) => {
    withTexture(...all);
    withIntegers(...all);
  });
  const { bytes } = maker.glb();
  const result = await remeshFile(bytes, { name: 'made.glb', vertices: 400 });
  const { tree, data } = openGltf(result);
  for (const member of ['materials', 'textures', 'samplers', 'nodes', 'scenes', 'extensionsUsed']) {
    assert.deepEqual(tree[member], maker.tree[member]);
  }
  const { byteOffset, byteLength } = tree.bufferViews[tree.images[0].bufferView];
  assert.deepEqual(data.slice(byteOffset, byteOffset + byteLength), png);
  const { TEXCOORD_0, COLOR_0 } = tree.meshes[0].primitives[0].attributes;
  assert.equal(tree.accessors[TEXCOORD_0].componentType, 5123);
  assert.equal(tree.accessors[COLOR_0].componentType, 5121);
  assert.ok(tree.accessors[COLOR_0].normalized);
});

test('images beside the file and in data URIs come back bit for bit', async () => {
  const maker = texturedSheet((tree, primitive) => {
    withTexture(tree, primitive);
    const uri = `data:image/png;base64,${Buffer.from(png).toString('base64')}`;
    Object.assign(tree.tree, { images: [{ uri: 'paint%20can.png' }, { uri }],
      textures: [{ source: 0, sampler: 0 }, { source: 1, sampler: 0 }] });
    tree.tree.materials[0].emissiveTexture = { index: 1 };
  });
  const { bytes, resources, ...options } = maker.gltf();
  Object.assign(resources, { 'paint can.png': png });
  const beside = await remeshFile(bytes, { ...options, resources, vertices: 400 });
  assert.deepEqual(await validate({ ...beside, files: beside.files.slice(1) }), []);
  assert.deepEqual(openGltf(beside).tree.images, maker.tree.images);
  assert.deepEqual(beside.files.find(({ name }) => name === 'paint can.png')?.bytes, png);

  const inside = await remeshFile(bytes, { ...options, resources, output: 'glb', vertices: 400 });
  assert.deepEqual(await validate(inside), []);
  const { tree, data } = openGltf(inside);
  const { byteOffset, byteLength } = tree.bufferViews[tree.images[0].bufferView];
  assert.deepEqual(data.slice(byteOffset, byteOffset + byteLength), png);
});

/** What their root says of a texture, an image or a material, by number. */
const rootExtensions = {
  VRM: { meta: { texture: 1 } },
  VRMC_vrm: { meta: { thumbnailImage: 1 } },
  EXT_lights_image_based: { lights: [{ specularImages: [[1]] }] },
  KHR_materials_variants: undefined,
};
for (const [extension, content] of Object.entries(rootExtensions)) {
  const stay = content ? 'stay where they were' : 'go';
  test(`${extension}: images that a new painting replaces ${stay}`, async () => {
    const file = texturedSheet((maker, primitive) => {
      withTexture(maker, primitive);
      const { tree } = maker;
      tree.images.push({ ...tree.images[0], name: 'portrait' });
      tree.textures.push({ source: 1, name: 'portrait' });
      tree.extensionsUsed.push(extension);
      tree.extensions = { [extension]: content ?? { variants: [{ name: 'one' }] } };
    });
    const { bytes, name } = file.glb();
    const { tree } = openGltf(await remeshFile(bytes, { name, vertices: 400, textures: 'bake' }));
    for (const list of ['images', 'textures']) {
      assert.equal(tree[list].findIndex((one) => one.name === 'portrait'), content ? 1 : -1);
    }
  });
}

test('two materials meet without a crack', async () => {
  const { bytes, name } = shared().glb();
  const result = await remeshFile(bytes, { name, vertices: 400 });
  const [left, right] = flatVertices(openGltf(result));
  const total = new Set([...left.places, ...right.places].map(String)).size;
  assert.equal(total, 400);
  assert.equal(result.report.output.boundaryEdges, (await inspect(result.bytes, { name })).input
    .boundaryEdges);
  assert.equal(result.report.output.eulerCharacteristic, 1);
});

test('a file with nothing to remesh comes back equal', async () => {
  const maker = new GltfMaker();
  maker.show([{ attributes: { POSITION: maker.add(positions, 'VEC3') }, mode: 0 }]);
  const { bytes, name } = maker.glb();
  const result = await remeshFile(bytes, { name, vertices: 400 });
  assert.deepEqual(result.bytes, bytes);
  assert.deepEqual(result.report.warnings.map(({ code }) => code),
    ['NOT_TRIANGLES', 'NOTHING_TO_REMESH']);
});

test('an instanced mesh stays instanced, points beside it stay untouched', async () => {
  const maker = texturedSheet();
  maker.tree.nodes = [{ mesh: 0, name: 'one' }, { mesh: 0, translation: [2, 0, 0] }];
  maker.tree.scenes[0].nodes = [0, 1];
  maker.tree.meshes[0].primitives.push({ attributes: { POSITION: maker.add(positions, 'VEC3') },
    mode: 0 });
  const { bytes, name } = maker.glb();
  const result = await remeshFile(bytes, { name, vertices: 400 });
  const opened = openGltf(result);
  assert.deepEqual(await validate(result), []);
  assert.deepEqual(opened.tree.nodes, maker.tree.nodes);
  const points = opened.tree.meshes[0].primitives[1];
  assert.equal(points.mode, 0);
  assert.deepEqual(valuesOf(opened, points.attributes.POSITION).flat(), [...positions]);
});

test('a model that is turned where it is shown is as far from its result as before', async () => {
  const mesh = torus({ columns: 60, rows: 30 });
  const maker = new GltfMaker();
  maker.show([{
    attributes: { POSITION: maker.add(Float32Array.from(mesh.positions), 'VEC3') },
    indices: maker.addIndices(Uint32Array.from(mesh.indices)),
  }]);
  const upright = maker.glb();
  maker.tree.nodes[0].rotation = [Math.SQRT1_2, 0, 0, Math.SQRT1_2];
  const turned = maker.glb();
  const changes = { hausdorff: [], rms: [] };
  // At some numbers rounding tips a near tie, and the largest distance is another.
  for (let vertices = 697; vertices <= 703; ++vertices) {
    const [{ fidelity: was }, { fidelity: is }] = await Promise.all([upright, turned].map(
      async (file) => (await remeshFile(file.bytes, { name: file.name, vertices })).report));
    for (const figure of ['hausdorff', 'rms'])
      changes[figure].push(is[figure] / was[figure] - 1);
  }
  for (const [figure, ratios] of Object.entries(changes))
    assert.ok(Math.abs(ratios.sort((a, b) => a - b)[3]) < 0.02, `${figure}: ${ratios}`);
});

test('an attribute that means nothing without another goes with it, in a sentence', async () => {
  const four = (value) => Uint8Array.from(perVertex(() => [value, 0, 0, 0]));
  const broken = {
    JOINTS_0: (maker, { attributes }) => {
      attributes.JOINTS_0 = maker.add(four(0), 'VEC4');
    },
    WEIGHTS_0: (maker, { attributes }) => {
      attributes.JOINTS_0 = maker.add(four(0).slice(count), 'VEC3');
      attributes.WEIGHTS_0 = maker.add(four(255), 'VEC4', { normalized: true });
    },
    'TARGET_0/NORMAL': (maker, primitive) => {
      primitive.targets = [{ POSITION: maker.add(positions, 'VEC3'),
        NORMAL: maker.add(positions, 'VEC3') }, { NORMAL: maker.add(positions, 'VEC3') }];
    },
  };
  for (const [name, change] of Object.entries(broken)) {
    const maker = texturedSheet(change);
    if (name !== 'TARGET_0/NORMAL') {
      maker.tree.skins = [{ joints: [1] }];
      maker.tree.nodes = [{ mesh: 0, skin: 0 }, {}];
      maker.tree.scenes[0].nodes = [0, 1];
    }
    const result = await remeshFile(maker.glb().bytes, { name: 'made.glb', vertices: 300 });
    assert.deepEqual(await validate(result), [], name);
    const said = result.report.warnings.filter(({ code }) => code === 'ATTRIBUTE_NOT_CARRIED');
    assert.ok(said.some(({ message }) => message.includes(`${name} means nothing without`)), name);
  }
});

test('morph targets are one kind of what a format has no place for, however many', async () => {
  const maker = texturedSheet((made, primitive) => {
    primitive.targets = Array.from({ length: 9 },
      () => ({ POSITION: made.add(positions, 'VEC3') }));
  });
  const { report } = await remeshFile(maker.glb().bytes,
    { name: 'made.glb', output: 'stl', vertices: 100, quality: 'draft' });
  const { message } = report.warnings.find(({ code }) => code === 'ATTRIBUTE_NOT_CARRIED');
  assert.equal(message, 'The STL has no place for TEXCOORD_0, morph targets.');
});

test('damaged compressed data is refused in a sentence', async () => {
  for (const extension of ['EXT_meshopt_compression', 'KHR_draco_mesh_compression']) {
    const { bytes, name } = await kinds[extension]();
    const { tree } = openGltf({ bytes });
    bytes.fill(0x55, bytes.length - tree.buffers[0].byteLength);
    await rejectsWith(remeshFile(bytes, { name, vertices: 400 }),
      'PARSE_ERROR', /^made\.glb: its compressed data cannot be decoded/);
  }
});

test('a file that says wrongly what is compressed is refused in words for people', async () => {
  const used = '"extensionsUsed":["KHR_draco_mesh_compression"]';
  for (const rest of ['"meshes":[{}]', '"meshes":5', '"bufferViews":[{}]']) {
    const bytes = new TextEncoder().encode(`{"asset":{"version":"2.0"},${used},${rest}}`);
    await rejectsWith(inspect(bytes, { name: 'a.gltf' }), 'PARSE_ERROR',
      /^a\.gltf: its compressed data cannot be decoded: the JSON does not say/);
  }
});
