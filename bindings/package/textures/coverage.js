// SPDX-License-Identifier: MIT
// How much of their texture the charts of a painted glTF use.

import { loadBuffers, slice } from '../codecs/buffer_views.js';
import { openContainer } from '../codecs/gltf_container.js';
import { GltfData } from '../codecs/gltf_data.js';

/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */

const arrays = /** @type {Record<number, any>} */ (
  { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array });

/** The numbers of meshes that stand for finer ones from afar. @param {any} tree */
function coarserMeshes(tree) {
  const levels = (tree.nodes ?? []).flatMap((/** @type {any} */ node) =>
    node.extensions?.MSFT_lod?.ids ?? []);
  return new Set(levels.map((/** @type {number} */ node) => tree.nodes[node]?.mesh));
}

/** The number of a texture that a material has; undefined if it has none. @param {any} material */
const textureOf = (material) => material?.pbrMetallicRoughness?.baseColorTexture?.index
  ?? material?.normalTexture?.index;

/** The area of a primitive's triangles in the square. @param {GltfData} data
 * @param {any} primitive */
function areaOf(data, { attributes, indices }) {
  const texcoords = data.floats(attributes.TEXCOORD_0);
  const { componentType } = data.tree.accessors[indices];
  const corners = new arrays[componentType](data.rows(indices).buffer);
  let area = 0;
  for (let i = 0; i + 2 < corners.length; i += 3) {
    const [a, b, c] = [corners[i], corners[i + 1], corners[i + 2]];
    const [u, v] = [texcoords[2 * a], texcoords[2 * a + 1]];
    area += Math.abs((texcoords[2 * b] - u) * (texcoords[2 * c + 1] - v)
      - (texcoords[2 * c] - u) * (texcoords[2 * b + 1] - v)) / 2;
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
  const data = new GltfData(tree, (tree.bufferViews ?? []).map((/** @type {any} */ view) =>
    slice(buffers[view.buffer], view)));
  const coarser = coarserMeshes(tree);
  /** @type {Map<number, number>} */
  const areas = new Map();
  for (const [number, mesh] of (tree.meshes ?? []).entries()) {
    for (const primitive of coarser.has(number) ? [] : mesh.primitives) {
      const texture = textureOf(tree.materials?.[primitive.material]);
      const { attributes: { TEXCOORD_0: texcoords }, indices } = primitive;
      if (texture === undefined || texcoords === undefined || indices === undefined) continue;
      if (!data.isFloats(texcoords) || !data.isPlain(indices)) continue;
      areas.set(texture, (areas.get(texture) ?? 0) + areaOf(data, primitive));
    }
  }
  const sum = [...areas.values()].reduce((all, area) => all + area, 0);
  return areas.size > 0 ? 100 * sum / areas.size : undefined;
}
