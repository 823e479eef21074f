// SPDX-License-Identifier: MIT
// Models whose looks a few vertices cannot carry: scans with colours in small charts of an atlas or
// in their vertices, sheets that touch, alpha in a map, a skin that bends.
import { addChart, columns, gutter, layOut, rows, texels } from './atlas_torus.js';
import { GltfMaker } from './gltf.js';
import { png } from './png.js';
import { skinnedTorus } from './skinned_torus.js';

const unlit = { KHR_materials_unlit: {} };

/** Spots that few triangles cannot follow. */
const spots = (i, j) => [
  Math.round(127 + 100 * Math.cos((2 * Math.PI * i) / columns)),
  Math.round(127 + 100 * Math.cos((2 * Math.PI * j) / rows)),
  Math.round(127 + 100 * Math.tanh(6 * Math.sin((16 * Math.PI * i) / columns)
    * Math.sin((8 * Math.PI * j) / rows)))];

const every = (step, count) => Array.from({ length: count / step + 1 }, (_, i) => step * i);

/** The place on the torus of a texel in a chart's cell. Gutters continue the chart up to the next
 * cell, so that the original shows no seam either. */
function onTorus(charts, x, y) {
  const chart = charts.find(({ left, top, width, height }) => x >= left - gutter
    && y >= top - gutter && x < left + width + gutter && y < top + height + gutter);
  return [
    chart.i0 + ((chart.i1 - chart.i0) * (x + 0.5 - chart.left)) / chart.width,
    chart.j0 + ((chart.j1 - chart.j0) * (y + 0.5 - chart.top)) / chart.height];
}

function addTexture(maker, colour) {
  Object.assign(maker.tree, {
    extensionsUsed: ['KHR_materials_unlit'],
    images: [{ bufferView: maker.addView(png(texels, texels, colour)), mimeType: 'image/png' }],
    textures: [{ source: 0 }],
  });
}

function addPrimitive(maker, charts, material) {
  const mesh = { positions: [], texcoords: [], indices: [] };
  for (const chart of charts) addChart(mesh, chart);
  return {
    attributes: {
      POSITION: maker.add(Float32Array.from(mesh.positions), 'VEC3'),
      TEXCOORD_0: maker.add(Float32Array.from(mesh.texcoords), 'VEC2'),
    },
    indices: maker.addIndices(Uint32Array.from(mesh.indices)),
    material,
  };
}

const paint = (factor, rest) => ({
  pbrMetallicRoughness: { baseColorTexture: { index: 0 }, baseColorFactor: factor },
  extensions: unlit,
  ...rest,
});

/** A torus in an atlas of 128 small charts, with nothing between them. */
function scrappyScan() {
  const maker = new GltfMaker();
  const charts = layOut({ around: every(4, columns), across: every(4, rows) });
  addTexture(maker, (x, y) => spots(...onTorus(charts, x, y)));
  maker.tree.materials = [paint([1, 1, 1, 1])];
  return maker.show([addPrimitive(maker, charts, 0)]).glb();
}

/** A torus with one transparent half. */
function halfGlass() {
  const maker = new GltfMaker();
  const charts = layOut({ around: every(8, columns), across: every(8, rows) });
  addTexture(maker, (x, y) => spots(...onTorus(charts, x, y)));
  maker.tree.materials = [paint([1, 1, 1, 1]), paint([1, 1, 1, 0.5], { alphaMode: 'BLEND' })];
  const isFront = ({ i0 }) => i0 < columns / 2;
  return maker.show([
    addPrimitive(maker, charts.filter(isFront), 0),
    addPrimitive(maker, charts.filter((chart) => !isFront(chart)), 1),
  ]).glb();
}

/** A strip folded over itself: checks of one colour lie close to checks of another. */
function foldedSheet() {
  const [long, wide, gap] = [96, 24, 0.02];
  const positions = [];
  const colours = [];
  const indices = [];
  for (let i = 0; i <= long; i += 1) {
    for (let j = 0; j <= wide; j += 1) {
      const along = (2 * i) / long - 1;
      const isUpper = i > long / 2;
      positions.push(1 - Math.abs(along), j / wide, i === long / 2 ? 0 : isUpper ? gap : -gap);
      const check = (Math.floor(i / 6) + Math.floor(j / 6)) % 2 ? 0.9 : 0.3;
      colours.push(...(isUpper ? [check, 0.1, 0.1] : [0.1, 0.1, check]));
      if (i === long || j === wide) continue;
      const at = (a, b) => (i + a) * (wide + 1) + j + b;
      indices.push(at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0));
    }
  }
  const maker = new GltfMaker();
  Object.assign(maker.tree, { extensionsUsed: ['KHR_materials_unlit'],
    materials: [{ extensions: unlit }] });
  return maker.show([{
    attributes: {
      POSITION: maker.add(Float32Array.from(positions), 'VEC3'),
      COLOR_0: maker.add(Float32Array.from(colours), 'VEC3'),
    },
    indices: maker.addIndices(Uint32Array.from(indices)),
    material: 0,
  }]).glb();
}

/** For each name: the maker of a file, and whether its joints are bent for the pictures. */
export const lookAlikes = {
  'a scan in scraps': { make: scrappyScan },
  'a folded sheet': { make: foldedSheet },
  'a body half of glass': { make: halfGlass },
  'a body with a skin': { make: skinnedTorus, isPosed: true },
};
