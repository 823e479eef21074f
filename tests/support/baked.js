// SPDX-License-Identifier: MIT
// Takes a file with baked textures apart, and reads the surface data of each texel.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

import decodePng, { init } from '@jsquash/png/decode.js';
import { generateTangents } from 'mikktspace';

import { openGltf, valuesOf } from './gltf.js';

globalThis.ImageData ??= class {
  constructor(data, width, height) {
    Object.assign(this, { data, width, height });
  }
};

const wasm = createRequire(import.meta.url).resolve('@jsquash/png/codec/pkg/squoosh_png_bg.wasm');
await init(new WebAssembly.Module(readFileSync(wasm)));

/** @param {Uint8Array} bytes a PNG */
const decodeImage = (bytes) => decodePng(bytes.slice().buffer);

/**
 * The tangents that a reader gives the corners of triangles without any, by MikkTSpace, for
 * textures that begin at the bottom.
 * @param {any} primitive its indices, and its values by attribute
 * @returns {number[][]}
 */
export function tangentsOf(primitive) {
  // MikkTSpace forgets to sort the last vertex's edges, and may miss neighbours there: so another
  // triangle, far from all, stands last.
  const last = { POSITION: [7, 7, 7, 8, 7, 7, 7, 8, 7], NORMAL: [0, 0, 1, 0, 0, 1, 0, 0, 1],
    TEXCOORD_0: [0, 0, 1, 0, 0, 1] };
  const corners = (name, size) => Float32Array.from(
    [...primitive.indices.flatMap((i) => primitive[name][i].slice(0, size)), ...last[name]]);
  const tangents = generateTangents(corners('POSITION', 3), corners('NORMAL', 3),
    corners('TEXCOORD_0', 2));
  return primitive.indices.map((_, i) =>
    [...tangents.subarray(4 * i, 4 * i + 3), -tangents[4 * i + 3]]);
}

/** @param {any} primitive without tangents, whose textures need some */
function addTangents(primitive) {
  primitive.TANGENT = [];
  tangentsOf(primitive).forEach((tangent, corner) => {
    primitive.TANGENT[primitive.indices[corner]] = tangent;
  });
}

/** The glTF tree, the first primitive's attributes and indices, and the PNG images by name. */
export async function baked(file) {
  const { tree, data } = openGltf(file);
  const [{ attributes, indices }] = tree.meshes[0].primitives;
  const values = (accessor) => valuesOf({ tree, data }, accessor);
  const primitive = { indices: values(indices).flat() };
  for (const [name, accessor] of Object.entries(attributes)) primitive[name] = values(accessor);
  const images = {};
  for (const { name, mimeType, bufferView } of tree.images) {
    const { byteOffset = 0, byteLength } = tree.bufferViews[bufferView];
    if (mimeType !== 'image/png') continue;
    images[name] = await decodeImage(data.subarray(byteOffset, byteOffset + byteLength));
  }
  if (images.normal && !primitive.TANGENT) addTangents(primitive);
  return { tree, primitive, images };
}

/** The colour at a texture coordinate, interpolated between the texels around it. */
export function bilinear({ width, height, data }, [u, v]) {
  const [x, y] = [u * width - 0.5, v * height - 0.5];
  const [x0, y0] = [Math.floor(x), Math.floor(y)];
  const at = (i, j, k) => data[4 * (Math.min(Math.max(j, 0), height - 1) * width
    + Math.min(Math.max(i, 0), width - 1)) + k];
  return [0, 1, 2, 3].map((k) => (y0 + 1 - y) * ((x0 + 1 - x) * at(x0, y0, k)
    + (x - x0) * at(x0 + 1, y0, k)) + (y - y0) * ((x0 + 1 - x) * at(x0, y0 + 1, k)
    + (x - x0) * at(x0 + 1, y0 + 1, k)));
}

/** The next smaller mip level: each texel is the mean of four. */
export function halved({ width, height, data }) {
  const [w, h] = [width / 2, height / 2];
  const half = new Uint8Array(4 * w * h);
  for (let y = 0; y < h; y += 1) {
    for (let x = 0; x < w; x += 1) {
      for (let k = 0; k < 4; k += 1) {
        const of = (i, j) => data[4 * ((2 * y + j) * width + 2 * x + i) + k];
        half[4 * (y * w + x) + k] = (of(0, 0) + of(1, 0) + of(0, 1) + of(1, 1)) / 4;
      }
    }
  }
  return { width: w, height: h, data: half };
}

/** The linear light, 0 to 1, of an sRGB byte. */
export const linear = (byte) => {
  const s = byte / 255;
  return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
};

const unit = (v) => {
  const length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return [v[0] / length, v[1] / length, v[2] / length];
};
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0]];

/** The texels that three coordinates along a side span: the first, and the one after the last. */
const span = (a, b, c) => [Math.floor(Math.min(a, b, c)), Math.ceil(Math.max(a, b, c))];

/** A texel's position, colour and normal, given its barycentric weights in a triangle. */
function texel({ primitive, images }, corners, weights, at) {
  const mix = (name) => {
    const [a, b, c] = corners.map((corner) => primitive[name][corner]);
    return a.map((x, k) => weights[0] * x + weights[1] * b[k] + weights[2] * c[k]);
  };
  const normal = unit(mix('NORMAL'));
  const place = { position: mix('POSITION'),
    colour: [...images.baseColor.data.subarray(at, at + 4)] };
  if (!images.normal) return { ...place, normal }; // they are flat
  const tangent = unit(mix('TANGENT').slice(0, 3));
  const bitangent = cross(normal, tangent).map((s) => s * primitive.TANGENT[corners[0]][3]);
  const [r, s, n] = [0, 1, 2].map((k) => (2 * images.normal.data[at + k]) / 255 - 1);
  return {
    ...place,
    normal: unit(normal.map((_, k) => r * tangent[k] + s * bitangent[k] + n * normal[k])),
  };
}

/** Visits the texels within one triangle. */
function visitWithin(model, corners, visit) {
  const { primitive, images: { baseColor: { width, height } } } = model;
  const [a, b, c] = corners.map((i) =>
    [primitive.TEXCOORD_0[i][0] * width, primitive.TEXCOORD_0[i][1] * height]);
  const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const [left, right] = span(a[0], b[0], c[0]);
  const [top, bottom] = span(a[1], b[1], c[1]);
  for (let y = top; y < bottom; y += 1) {
    for (let x = left; x < right; x += 1) {
      const p = x + 0.5 - a[0], q = y + 0.5 - a[1];
      const v = (p * (c[1] - a[1]) - q * (c[0] - a[0])) / area;
      const w = ((b[0] - a[0]) * q - (b[1] - a[1]) * p) / area;
      const isInside = v >= 0 && w >= 0 && v + w <= 1;
      if (isInside) visit(texel(model, corners, [1 - v - w, v, w], 4 * (y * width + x)));
    }
  }
}

/** Visits every texel within a triangle, with its position, its colour and its decoded normal. */
export function forEachTexel(model, visit) {
  const { indices } = model.primitive;
  for (let t = 0; t < indices.length; t += 3) visitWithin(model, indices.slice(t, t + 3), visit);
}

/** The largest step of a colour over the charts' borders, and usual ones within them: along an edge
 * of a triangle, and from one texel to the next. */
export function colourSteps({ primitive }, image) {
  const byPlace = new Map();
  const colours = primitive.TEXCOORD_0.map((texcoord) => bilinear(image, texcoord));
  primitive.POSITION.forEach((position, vertex) => {
    byPlace.set(position.join(), [...(byPlace.get(position.join()) ?? []), colours[vertex]]);
  });
  const difference = (a, b) => Math.max(...[0, 1, 2].map((k) => Math.abs(a[k] - b[k])));
  const over = [...byPlace.values()].filter(({ length }) => length > 1).map((all) =>
    Math.max(...all.map((colour) => difference(colour, all[0]))));
  const edges = primitive.indices.map((vertex, corner) => {
    const other = primitive.indices[corner % 3 === 2 ? corner - 2 : corner + 1];
    const [a, b] = [vertex, other].map((v) => primitive.TEXCOORD_0[v].map((x) => x * image.width));
    return { step: difference(colours[vertex], colours[other]),
      length: Math.max(1, Math.hypot(a[0] - b[0], a[1] - b[1])) };
  });
  const high = (list) => list.sort((a, b) => a - b)[Math.floor(0.95 * list.length)];
  return { over: high(over), edge: high(edges.map(({ step }) => step)),
    texel: high(edges.map(({ step, length }) => step / length)) };
}
