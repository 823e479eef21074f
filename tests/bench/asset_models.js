// SPDX-License-Identifier: MIT
// Textured models like those that people bring, by formula: a generated body of thousands of charts
// with floaters and inner shells, four materials, foliage, cloth and a skinned figure.
import { GltfMaker } from '../support/gltf.js';
import { png } from '../support/png.js';
import { addChart, layOut, texels } from '../support/atlas_torus.js';
import { skinnedTorus } from '../support/skinned_torus.js';

/** A colour for each place: bands along three axes. @param {number[]} p */
const colourAt = ([x, y, z]) => [
  127 + 100 * Math.sin(3 * x + 2 * y), 127 + 90 * Math.sin(4 * y - z), 127 + 110 * Math.sin(5 * z),
].map(Math.round);

// A cube's corner by its three bits, and six tetrahedra around the diagonal from corner 0 to 7.
const tetrahedra = [[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7],
  [0, 5, 1, 7]];

/** A tetrahedron's triangles where a function passes zero, with the inside on their back.
 * @param {{ p: number[], value: number }[]} corners */
function crossed(corners) {
  const [inner, outer] = [corners.filter(({ value }) => value < 0),
    corners.filter(({ value }) => value >= 0)];
  if (inner.length === 0 || outer.length === 0) return [];
  const between = (a, b) => a.p.map((x, k) => x + (b.p[k] - x) * a.value / (a.value - b.value));
  const [a, b] = inner;
  const [c, d] = outer;
  const fans = inner.length === 2
    ? [[between(a, c), between(a, d), between(b, d)], [between(a, c), between(b, d), between(b, c)]]
    : [inner.length === 1 ? outer.map((o) => between(a, o)) : inner.map((i) => between(i, c))];
  const outwards = outer[0].p.map((x, k) => x - inner[0].p[k]);
  return fans.map((fan) => (dot(normalOf(fan), outwards) < 0 ? [fan[0], fan[2], fan[1]] : fan));
}

const dot = (u, v) => u.reduce((sum, x, k) => sum + x * v[k], 0);

function normalOf([a, b, c]) {
  const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
  return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
}

/** The triangles of the surface f = 0 in a cube from −1.5 to 1.5, by marching tetrahedra.
 * @param {(p: number[]) => number} f @param {number} n cells along an edge */
function surfaceOf(f, n) {
  const at = (i, j, k) => [i, j, k].map((index) => 3 * index / n - 1.5);
  const values = new Float64Array((n + 1) ** 3);
  const slot = (i, j, k) => (i * (n + 1) + j) * (n + 1) + k;
  for (let i = 0; i <= n; i += 1) {
    for (let j = 0; j <= n; j += 1) {
      for (let k = 0; k <= n; k += 1) values[slot(i, j, k)] = f(at(i, j, k));
    }
  }
  const triangles = [];
  for (let cell = 0; cell < n ** 3; cell += 1) {
    const [i, j, k] = [Math.floor(cell / n ** 2), Math.floor(cell / n) % n, cell % n];
    const corners = Array.from({ length: 8 }, (_, bits) => {
      const [a, b, c] = [i + (bits & 1), j + ((bits >> 1) & 1), k + (bits >> 2)];
      return { p: at(a, b, c), value: values[slot(a, b, c)] };
    });
    for (const four of tetrahedra) triangles.push(...crossed(four.map((c) => corners[c])));
  }
  return triangles.filter((triangle) => dot(normalOf(triangle), normalOf(triangle)) > 0);
}

/** Charts as a generator makes them: a block of space, seen along one axis, in a tile of a texture.
 * @param {number[][][]} triangles @param {number} blocks along an edge of the cube */
function charted(triangles, blocks, size) {
  const side = 3 / blocks;
  const charts = new Map();
  for (const triangle of triangles) {
    const normal = normalOf(triangle);
    const axis = [0, 1, 2].sort((a, b) => Math.abs(normal[b]) - Math.abs(normal[a]))[0];
    const block = [0, 1, 2].map((k) =>
      Math.floor((triangle.reduce((sum, p) => sum + p[k], 0) / 3 + 1.5) / side));
    const key = [axis, normal[axis] > 0, ...block].join();
    if (!charts.has(key)) charts.set(key, { axis, block, triangles: [] });
    charts.get(key).triangles.push(triangle);
  }
  const across = Math.ceil(Math.sqrt(charts.size));
  const tile = Math.floor(size / across);
  const mesh = { positions: [], texcoords: [], indices: [] };
  const tiles = [...charts.values()];
  // A triangle reaches beyond its block by less than the block's size.
  const start = ({ block }, k) => (block[k] - 0.5) * side - 1.5;
  tiles.forEach((chart, t) => {
    const [left, top] = [t % across * tile, Math.floor(t / across) * tile];
    const plane = [0, 1, 2].filter((k) => k !== chart.axis);
    for (const p of chart.triangles.flat()) {
      const [u, v] = plane.map((k) => (p[k] - start(chart, k)) / (2 * side));
      mesh.indices.push(mesh.positions.length / 3);
      mesh.positions.push(...p);
      mesh.texcoords.push((left + u * tile) / size, (top + v * tile) / size);
    }
  });
  const paint = (x, y) => {
    const chart = tiles[Math.floor(y / tile) * across + Math.floor(x / tile)];
    if (!chart || x >= across * tile) return [0, 0, 0];
    const plane = [0, 1, 2].filter((k) => k !== chart.axis);
    const p = chart.block.map((b) => (b + 0.5) * side - 1.5);
    [x, y].forEach((texel, k) => {
      p[plane[k]] = start(chart, plane[k]) + (texel % tile + 0.5) / tile * 2 * side;
    });
    return colourAt(p);
  };
  return { mesh, picture: png(size, size, paint) };
}

const ball = (p, [x, y, z], radius) => Math.hypot(p[0] - x, p[1] - y, p[2] - z) - radius;

/** A body of blobs, as generators make them: bumps, hollows inside, and crumbs around it. */
function generatedBody(p) {
  const bumps = 0.02 * Math.sin(9 * p[0]) * Math.sin(8 * p[1]) * Math.sin(10 * p[2]);
  const body = Math.min(ball(p, [0, 0, 0], 0.8), ball(p, [0.1, 0.9, 0], 0.45),
    ball(p, [-0.7, 0.2, 0.3], 0.4), ball(p, [0.7, 0.1, 0.35], 0.4),
    ball(p, [-0.3, -0.9, 0], 0.35), ball(p, [0.35, -0.9, 0.1], 0.35)) + bumps;
  const hollows = Math.min(ball(p, [0, 0, 0], 0.4), ball(p, [0.1, 0.9, 0], 0.2));
  const crumbs = Math.min(...Array.from({ length: 9 }, (_, k) => ball(p,
    [1.3 * Math.cos(2.4 * k), 1.2 * Math.sin(1.7 * k), 1.3 * Math.sin(2.4 * k)],
    0.03 + 0.001 * k)));
  return Math.min(Math.max(body, -hollows), crumbs);
}

/** @param {GltfMaker} maker @param {any} mesh */
const addPrimitive = (maker, { positions, texcoords, indices }, material) => ({
  attributes: {
    POSITION: maker.add(Float32Array.from(positions), 'VEC3'),
    TEXCOORD_0: maker.add(Float32Array.from(texcoords), 'VEC2'),
  },
  indices: maker.addIndices(Uint32Array.from(indices)),
  material,
});

const addImage = (maker, picture) =>
  ({ bufferView: maker.addView(picture), mimeType: 'image/png' });

const textured = (index, rest = {}) =>
  ({ pbrMetallicRoughness: { baseColorTexture: { index }, metallicFactor: 0 }, ...rest });

/** One material. @param {any} mesh @param {Uint8Array} picture @param {object} [rest] of it */
function oneMaterial(mesh, picture, rest) {
  const maker = new GltfMaker();
  Object.assign(maker.tree, { images: [addImage(maker, picture)], textures: [{ source: 0 }],
    materials: [textured(0, rest)] });
  return maker.show([addPrimitive(maker, mesh, 0)]).glb().bytes;
}

/** @param {number} cells of the surface along an edge @param {number} blocks of charts */
function generated(cells, blocks) {
  const { mesh, picture } = charted(surfaceOf(generatedBody, cells), blocks, 1024);
  return oneMaterial(mesh, picture);
}

/** A torus of four materials: three textures and a plain colour. */
function fourMaterials() {
  const maker = new GltfMaker();
  const charts = layOut({ around: [0, 16, 32, 48, 64], across: [0, 32] });
  const pictures = [0, 1, 2].map((n) => png(texels, texels,
    (x, y) => colourAt([x / 30 + n, y / 40, (x + y) / 50])));
  Object.assign(maker.tree, {
    images: pictures.map((picture) => addImage(maker, picture)),
    textures: [0, 1, 2].map((source) => ({ source })),
    materials: [...[0, 1, 2].map((n) => textured(n)),
      { pbrMetallicRoughness: { baseColorFactor: [0.8, 0.1, 0.1, 1], metallicFactor: 0 } }],
  });
  const primitives = charts.map((chart, material) => {
    const mesh = { positions: [], texcoords: [], indices: [] };
    addChart(mesh, chart);
    return addPrimitive(maker, mesh, material);
  });
  return maker.show(primitives).glb().bytes;
}

/** A grid of quads with texture coordinates from 0 to 1.
 * @param {number} n @param {(u: number, v: number) => number[]} placeAt */
function grid(n, placeAt, mesh = { positions: [], texcoords: [], indices: [] }) {
  const first = mesh.positions.length / 3;
  for (let i = 0; i <= n; i += 1) {
    for (let j = 0; j <= n; j += 1) {
      mesh.positions.push(...placeAt(i / n, j / n));
      mesh.texcoords.push(i / n, j / n);
      if (i === n || j === n) continue;
      const at = first + i * (n + 1) + j;
      mesh.indices.push(at, at + n + 1, at + n + 2, at, at + n + 2, at + 1);
    }
  }
  return mesh;
}

const stripes = png(256, 256, (x, y) => colourAt([x / 40, y / 60, (x - y) / 80]));

const cloth = () => oneMaterial(grid(100, (u, v) =>
  [2 * u - 1, 0.2 * Math.sin(7 * u) * Math.cos(5 * v), 2 * v - 1]), stripes, { doubleSided: true });

const leafShape = png(256, 256, (x, y) => [40 + x / 4, 120 + y / 4, 50,
  Math.abs(y - 128) < 120 * Math.sin(Math.PI * x / 256) ? 255 : 0].map(Math.round));

/** Leaves of a plant: bent cards whose texture says where they are. */
function foliage() {
  const mesh = { positions: [], texcoords: [], indices: [] };
  for (let leaf = 0; leaf < 60; leaf += 1) {
    const [turn, height] = [2.4 * leaf, leaf / 40];
    grid(10, (u, v) => {
      const [out, across] = [0.1 + 0.6 * u, 0.3 * (v - 0.5)];
      return [out * Math.cos(turn) - across * Math.sin(turn), height + 0.3 * u - 0.4 * u * u,
        out * Math.sin(turn) + across * Math.cos(turn)];
    }, mesh);
  }
  return oneMaterial(mesh, leafShape, { doubleSided: true, alphaMode: 'MASK' });
}

/** Names, and functions that make a GLB. @type {Record<string, () => Uint8Array>} */
export const assetModels = {
  'generated body': () => generated(64, 8),
  'thousands of charts': () => generated(48, 24),
  'four materials': fourMaterials,
  foliage,
  cloth,
  'skinned figure': () => skinnedTorus().bytes,
};
