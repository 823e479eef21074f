// SPDX-License-Identifier: MIT
// A textured model looks from all sides as it did: its texture is an atlas of charts with nothing
// but a strange colour between them, which shows as soon as a triangle reaches from one to another.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { inspect, remeshFile } from 'remesher';
import { remesh } from 'remesher/gltf-transform';

import {
  addChart, columns, layOut, narrow, rows, texels, wide,
} from '../../support/atlas_torus.js';
import { openContainer, packGlb } from '../../../bindings/package/codecs/gltf_container.js';
import { GltfMaker } from '../../support/gltf.js';
import { lookAlikes } from '../../support/look_alikes.js';
import { openGallery } from '../../support/pictures.js';
import { png } from '../../support/png.js';
import { simplified } from '../../support/simplified.js';
import { skinnedTorus } from '../../support/skinned_torus.js';

const strange = [255, 0, 255];

/** Red around the torus, green across, blue in checks: continuous over every seam. */
function paint(i, j) {
  const wave = (turn) => Math.round(127 + 100 * Math.cos(2 * Math.PI * turn));
  const check = Math.sin((16 * Math.PI * i) / columns) * Math.sin((8 * Math.PI * j) / rows);
  return [wave(i / columns), wave(j / rows), Math.round(90 + 80 * Math.tanh(6 * check))];
}

/** One texel beyond its border belongs to a chart, since pictures are sampled to a texel. */
function texture(charts) {
  return png(texels, texels, (x, y) => {
    const on = charts.find(({ left, top, width, height }) => x >= left - 1 && x <= left + width
      && y >= top - 1 && y <= top + height);
    if (!on) return strange;
    return paint(on.i0 + ((on.i1 - on.i0) * (x + 0.5 - on.left)) / on.width,
      on.j0 + ((on.j1 - on.j0) * (y + 0.5 - on.top)) / on.height);
  });
}

/** The painted torus as a GLB without shading, so that a picture shows the texture itself. */
function paintedTorus(cuts) {
  const charts = layOut(cuts);
  const mesh = { positions: [], texcoords: [], indices: [] };
  charts.forEach((chart) => addChart(mesh, chart));
  const maker = new GltfMaker();
  Object.assign(maker.tree, {
    extensionsUsed: ['KHR_materials_unlit'],
    images: [{ bufferView: maker.addView(texture(charts)), mimeType: 'image/png' }],
    samplers: [{ magFilter: 9728, minFilter: 9728 }],
    textures: [{ source: 0, sampler: 0 }],
    materials: [{
      pbrMetallicRoughness: { baseColorTexture: { index: 0 } },
      extensions: { KHR_materials_unlit: {} },
    }],
  });
  return maker.show([{
    attributes: {
      POSITION: maker.add(Float32Array.from(mesh.positions), 'VEC3'),
      TEXCOORD_0: maker.add(Float32Array.from(mesh.texcoords), 'VEC2'),
    },
    indices: maker.addIndices(Uint32Array.from(mesh.indices)),
    material: 0,
  }]).glb();
}

/** @type {Awaited<ReturnType<typeof openGallery>>} */
let gallery;

before(async () => {
  gallery = await openGallery();
});

after(() => gallery?.close());

/** Remeshes the torus and looks whether it is `within` of its pictures before. */
async function holdsUp(cuts, { vertices, within }) {
  const { name, bytes } = paintedTorus(cuts);
  const result = await remeshFile(bytes, { name, vertices });
  const views = await gallery.compare(bytes, result.bytes, { forbidden: strange });
  assert.equal(views.length, 12);
  for (const [n, view] of views.entries()) {
    assert.equal(view.strange, 0, `view ${n} shows what is beside the charts`);
    assert.ok(view.difference < within, `view ${n} differs by ${view.difference}`);
  }
}

test('a file and itself give the same pictures, with nothing strange in them', async () => {
  const { bytes } = paintedTorus(wide);
  for (const view of await gallery.compare(bytes, bytes, { forbidden: strange })) {
    assert.ok(view.pixels > 10000);
    assert.deepEqual([view.difference, view.strange], [0, 0]);
  }
});

// A texture that is off by a hundredth of the way around the torus differs by 0.01 or more.
test('a torus of several charts looks as it did', async () => {
  await holdsUp(wide, { vertices: 1500, within: 0.005 });
});

test('charts narrower than the edges look as they did and do not bleed', async () => {
  await holdsUp(narrow, { vertices: 400, within: 0.02 });
});

test('two materials and a skin look as they did, through glTF-Transform', async () => {
  const { bytes } = skinnedTorus();
  const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);
  const document = await io.readBinary(bytes);
  await document.transform(remesh({ vertices: 2000 }));
  const views = await gallery.compare(bytes, await io.writeBinary(document));
  assert.equal(views.length, 12);
  for (const [n, { difference, pixels }] of views.entries()) {
    assert.ok(pixels > 10000);
    assert.ok(difference < 0.02, `view ${n} differs by ${difference}`);
  }
});

/** The file with its right joint bent. */
function posed(bytes) {
  const { text, chunk } = openContainer(bytes);
  const tree = JSON.parse(text);
  tree.nodes.find(({ name }) => name === 'right').rotation = [0, 0, 0.3, Math.sqrt(1 - 0.3 ** 2)];
  return packGlb(tree, chunk);
}

/** How alike and how different two files look, over some views. */
async function likeness(original, result, { isPosed, views: numbers = [0, 7], anisotropy }) {
  const [a, b] = isPosed ? [posed(original), posed(result)] : [original, result];
  const views = await gallery.compare(a, b, { views: numbers, anisotropy });
  const mean = (key) => views.reduce((sum, view) => sum + view[key], 0) / views.length;
  return { ssim: mean('ssim'), difference: mean('difference') };
}

/** How alike files with so few triangles look: textures baked; by meshoptimizer and kept, if they
 * have no more. */
async function alike(shape, ratio) {
  const { name, bytes } = shape.make();
  const options = { name, ratio };
  const baked = await remeshFile(bytes, { ...options, textures: 'bake' });
  const { triangles } = baked.report.output;
  const rivals = [await simplified(bytes, triangles), (await remeshFile(bytes, options)).bytes];
  const found = [await likeness(bytes, baked.bytes, shape)];
  for (const rival of rivals) {
    const { input } = await inspect(rival);
    found.push(input.triangles <= 1.05 * triangles ? await likeness(bytes, rival, shape)
      : { ssim: 0, difference: 1 });
  }
  return found;
}

/** Of the files with so few vertices the one with baked textures looks the most like what was, in
 * the mean of three neighbouring numbers. */
async function looksMostAlike(shape, ratio) {
  const runs = [];
  for (const near of [0.95, 1, 1.05]) runs.push(await alike(shape, near * ratio));
  const mean = (place, key) => runs.reduce((sum, run) => sum + run[place][key], 0) / runs.length;
  for (const other of [1, 2]) {
    assert.ok(mean(0, 'ssim') > mean(other, 'ssim'), `${mean(0, 'ssim')}, ${mean(other, 'ssim')}`);
    assert.ok(mean(0, 'difference') < mean(other, 'difference'),
      `${mean(0, 'difference')}, ${mean(other, 'difference')}`);
  }
}

for (const [what, shape] of Object.entries(lookAlikes)) {
  for (const [share, ratio] of Object.entries({ tenth: 1 / 10, thirtieth: 1 / 30 })) {
    test(`${what} looks like itself at a ${share} of its vertices, if its textures are baked`,
      () => looksMostAlike(shape, ratio));
  }
}

// Texels of its scraps are up to five times as long as wide. A viewer that filters as wide as long
// blurs the original, and what is kept of it, more than an atlas of even texels.
test('a scan in scraps looks like itself at a third, too, if filtered along its texels',
  () => looksMostAlike({ ...lookAlikes['a scan in scraps'], anisotropy: 16 }, 1 / 3));

/** Where charts cost few of the vertices, what is baked is as good as what was, but for the
 * pixels at the outline; from behind, too, where a small body is lit as its shape would not be. */
async function looksAsIfKept({ make, isPosed }) {
  const { name, bytes } = make();
  const [own, kept] = await Promise.all(['bake', 'keep'].map((textures) =>
    remeshFile(bytes, { name, ratio: 1 / 3, textures }).then((result) =>
      likeness(bytes, result.bytes, { isPosed, views: [0, 3, 7, 10] }))));
  assert.ok(own.ssim > kept.ssim - 0.01, `${own.ssim}, ${kept.ssim}`);
  assert.ok(own.difference < kept.difference + 0.005, `${own.difference}, ${kept.difference}`);
}

for (const [what, shape] of Object.entries(lookAlikes)) {
  test(`${what} looks at a third of its vertices as with its charts kept`,
    () => looksAsIfKept(shape));
}

test('steps between the colours of neighbours are steps in the texture, too', async () => {
  const shape = lookAlikes['a folded sheet'];
  const { name, bytes } = shape.make();
  const baked = await remeshFile(bytes, { name, ratio: 1 / 10, textures: 'bake' });
  const { ssim, difference } = await likeness(bytes, baked.bytes, shape);
  assert.ok(ssim > 0.995 && difference < 0.005, `${ssim}, ${difference}`);
});
