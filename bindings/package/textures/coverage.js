// SPDX-License-Identifier: MIT
// How much of their texture the charts of a painted glTF use.

import { loadBuffers, slice } from '../codecs/buffer_views.js';
import { openContainer } from '../codecs/gltf_container.js';

/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */

const float = 5126, triangles = 4;

/** Bytes and reader of each type of component that painted files have. */
const readers = /** @type {Record<number, [number, string]>} */ ({ 5121: [1, 'getUint8'],
  5123: [2, 'getUint16'], 5125: [4, 'getUint32'], [float]: [4, 'getFloat32'] });

/** The numbers of meshes that stand for finer ones from afar. @param {any} tree */
function coarserMeshes(tree) {
  const levels = (tree.nodes ?? []).flatMap((/** @type {any} */ node) =>
    node.extensions?.MSFT_lod?.ids ?? []);
  return new Set(levels.map((/** @type {number} */ node) => tree.nodes[node]?.mesh));
}

/** The number of a texture that a material has; undefined if it has none. @param {any} material */
const textureOf = (material) => material?.pbrMetallicRoughness?.baseColorTexture?.index
  ?? material?.normalTexture?.index;

/**
 * Reads a number of an accessor that is not sparse: component k of element i.
 * @param {any} tree @param {Uint8Array[]} buffers @param {number} number
 * @returns {{ count: number, read: (i: number, k: number) => number }}
 */
function accessorOf(tree, buffers, number) {
  const { bufferView, byteOffset = 0, componentType, count } = tree.accessors[number];
  const view = tree.bufferViews[bufferView];
  const bytes = slice(buffers[view.buffer], view);
  const data = new DataView(bytes.buffer, bytes.byteOffset + byteOffset);
  const [size, name] = readers[componentType];
  const step = view.byteStride ?? size * (componentType === float ? 2 : 1);
  return { count, read: (i, k) =>
    /** @type {any} */ (data)[name](i * step + k * size, true) };
}

/** The area of a primitive's triangles in the square.
 * @param {(number: number) => ReturnType<typeof accessorOf>} open @param {any} primitive */
function areaOf(open, { attributes, indices }) {
  const { read } = open(attributes.TEXCOORD_0);
  const corners = open(indices);
  let area = 0;
  for (let i = 0; i + 2 < corners.count; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => corners.read(i + k, 0));
    const [u, v] = [read(a, 0), read(a, 1)];
    area += Math.abs((read(b, 0) - u) * (read(c, 1) - v)
      - (read(c, 0) - u) * (read(b, 1) - v)) / 2;
  }
  return area;
}

/**
 * Percent of the square that the charts of painted textures cover; the mean, if there are several
 * sets of textures; undefined if there is none.
 * @param {NamedBytes[]} files a glTF file and those that it refers to
 * @returns {number | undefined}
 */
export function coverageOf([{ name, bytes }, ...resources]) {
  const { text, chunk } = openContainer(bytes);
  const tree = JSON.parse(text);
  const buffers = loadBuffers(tree, chunk, { name, resources });
  const open = (/** @type {number} */ number) => accessorOf(tree, buffers, number);
  const canRead = (/** @type {number | undefined} */ number) => {
    const { bufferView, sparse, componentType } = tree.accessors?.[number ?? -1] ?? {};
    return bufferView !== undefined && !sparse && componentType in readers;
  };
  const coarser = coarserMeshes(tree);
  /** @type {Map<number, number>} */
  const areas = new Map();
  for (const [number, mesh] of (tree.meshes ?? []).entries()) {
    for (const primitive of coarser.has(number) ? [] : mesh.primitives) {
      const texture = textureOf(tree.materials?.[primitive.material]);
      const { mode = triangles, attributes: { TEXCOORD_0: texcoords }, indices } = primitive;
      if (texture === undefined || mode !== triangles) continue;
      if (!canRead(texcoords) || !canRead(indices)) continue;
      if (tree.accessors[texcoords].componentType !== float) continue;
      areas.set(texture, (areas.get(texture) ?? 0) + areaOf(open, primitive));
    }
  }
  const sum = [...areas.values()].reduce((all, area) => all + area, 0);
  return areas.size > 0 ? 100 * sum / areas.size : undefined;
}
