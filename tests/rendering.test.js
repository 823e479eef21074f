// SPDX-License-Identifier: MIT
// A textured model looks from all sides as it did: its texture is an atlas of charts with nothing
// but a strange colour between them, which shows as soon as a triangle reaches from one to another.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { remeshFile } from 'remesher';

import { GltfMaker } from './support/gltf.js';
import { openGallery } from './support/pictures.js';
import { png } from './support/png.js';

const strange = [255, 0, 255];
const [columns, rows] = [64, 32];
const texels = 512;
const gap = 8;  // texels around a chart

/** Where on the way around the charts begin and end, in columns or rows of the torus. */
const wide = { around: [0, 20, 40, 64], across: [0, 12, 32] };
// The second chart of either kind is narrower than half an edge of the result.
const narrow = { around: [0, 31, 32, 64], across: [0, 15, 16, 32] };

const spans = (cuts) => cuts.slice(1).map((end, i) => [cuts[i], end]);

/** The charts, each in a cell of its own of a texture divided into rows and columns. */
function layOut({ around, across }) {
  const cell = [texels / (around.length - 1), texels / (across.length - 1)];
  return spans(around).flatMap(([i0, i1], a) => spans(across).map(([j0, j1], b) => ({
    i0, i1, j0, j1,
    left: a * cell[0] + gap, top: b * cell[1] + gap,
    width: cell[0] - 2 * gap, height: cell[1] - 2 * gap,
  })));
}

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

function place(i, j) {
  const [u, v] = [(2 * Math.PI * (i % columns)) / columns, (2 * Math.PI * (j % rows)) / rows];
  const reach = 2 + 0.8 * Math.cos(v);
  return [reach * Math.cos(u), reach * Math.sin(u), 0.8 * Math.sin(v)];
}

/** Adds a chart as a grid of its own: places on a seam come once per chart. */
function addChart(mesh, { i0, i1, j0, j1, left, top, width, height }) {
  const first = mesh.positions.length / 3;
  for (let i = i0; i <= i1; i += 1) {
    for (let j = j0; j <= j1; j += 1) {
      mesh.positions.push(...place(i, j));
      mesh.texcoords.push((left + (width * (i - i0)) / (i1 - i0)) / texels,
        (top + (height * (j - j0)) / (j1 - j0)) / texels);
      if (i === i1 || j === j1) continue;
      const at = (a, b) => first + (i + a - i0) * (j1 - j0 + 1) + j + b - j0;
      mesh.indices.push(at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1));
    }
  }
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
