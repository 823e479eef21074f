// SPDX-License-Identifier: MIT
// KHR_draco_mesh_compression: each compressed primitive gets plain accessors. A primitive of
// triangle strips comes out as triangles.

import { requireDracoHolds } from './claims.js';

const dracoExtension = 'KHR_draco_mesh_compression';

/** @type {Record<string, number>} */
const componentsOfType = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 };
/** @type {Record<number, { name: string, size: number }>} by glTF component type */
const componentTypes = {
  5120: { name: 'DT_INT8', size: 1 },
  5121: { name: 'DT_UINT8', size: 1 },
  5122: { name: 'DT_INT16', size: 2 },
  5123: { name: 'DT_UINT16', size: 2 },
  5125: { name: 'DT_UINT32', size: 4 },
  5126: { name: 'DT_FLOAT32', size: 4 },
};
const unsignedInt = 5125;
const float = 5126;

/**
 * Copies out the values that the decoder writes into its own memory. If the sizes do not agree it
 * writes nothing, and the bytes there are not ours.
 * @param {any} draco
 * @param {number} byteLength
 * @param {(pointer: number) => boolean} fill
 */
function copyOut(draco, byteLength, fill) {
  const pointer = draco._malloc(byteLength);
  if (pointer === 0) throw new Error('it needs more memory than the decoder has');
  try {
    if (!fill(pointer)) throw new Error('an accessor is of another type than what is compressed');
    return draco.HEAPU8.slice(pointer, pointer + byteLength);
  } finally {
    draco._free(pointer);
  }
}

/**
 * Rows that begin at multiples of four bytes, as vertex attributes need.
 * @param {Uint8Array} bytes
 * @param {number} rowBytes
 * @param {number} stride
 */
function spread(bytes, rowBytes, stride) {
  if (rowBytes === stride) return bytes;
  const rows = bytes.length / rowBytes;
  const result = new Uint8Array(rows * stride);
  for (let i = 0; i < rows; i += 1) {
    result.set(bytes.subarray(i * rowBytes, (i + 1) * rowBytes), i * stride);
  }
  return result;
}

/**
 * Draco rounds positions, so that the bounds stated before no longer fit.
 * @param {any} accessor
 * @param {Uint8Array} bytes
 */
function correctBounds(accessor, bytes) {
  if (!accessor.min || accessor.componentType !== float) return;
  const values = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4);
  const width = componentsOfType[accessor.type];
  accessor.min = Array.from(values.subarray(0, width));
  accessor.max = [...accessor.min];
  values.forEach((value, i) => {
    accessor.min[i % width] = Math.min(accessor.min[i % width], value);
    accessor.max[i % width] = Math.max(accessor.max[i % width], value);
  });
}

class PrimitiveDecoder {
  /**
   * @param {any} draco the decoder's module
   * @param {any} tree
   * @param {Uint8Array[]} contents per buffer view; grows
   */
  constructor(draco, tree, contents) {
    this.draco = draco;
    this.tree = tree;
    this.contents = contents;
    this.compressed = [...contents];
    this.done = new Set(); // accessors, and buffer views whose place was taken
  }

  /** @param {any} primitive */
  decode(primitive) {
    const { bufferView, attributes } = primitive.extensions[dracoExtension];
    const bytes = this.compressed[bufferView];
    requireDracoHolds(bytes);
    const decoder = new this.draco.Decoder();
    const mesh = new this.draco.Mesh();
    try {
      const status = decoder.DecodeArrayToMesh(bytes, bytes.length, mesh);
      if (!status.ok() || mesh.ptr === 0) throw new Error(status.error_msg());
      for (const [semantic, id] of Object.entries(attributes)) {
        this.addAttribute(decoder, mesh, id, primitive.attributes[semantic]);
      }
      this.addIndices(decoder, mesh, primitive, bufferView);
    } finally {
      this.draco.destroy(mesh);
      this.draco.destroy(decoder);
    }
    delete primitive.extensions[dracoExtension];
    if (Object.keys(primitive.extensions).length === 0) delete primitive.extensions;
    primitive.mode = 4;
  }

  /** @param {any} decoder @param {any} mesh @param {number} id @param {number} accessorNumber */
  addAttribute(decoder, mesh, id, accessorNumber) {
    if (this.isDone(accessorNumber)) return;
    const accessor = this.tree.accessors[accessorNumber];
    const { name, size } = componentTypes[accessor.componentType];
    const rowBytes = size * componentsOfType[accessor.type];
    const count = mesh.num_points();
    const byteLength = count * rowBytes;
    const attribute = decoder.GetAttributeByUniqueId(mesh, id);
    if (this.draco.getPointer(attribute) === 0) {
      throw new Error(`attribute ${String(id)} is not among what is compressed`);
    }
    const bytes = copyOut(this.draco, byteLength, (pointer) =>
      decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, this.draco[name], byteLength,
        pointer));
    const byteStride = Math.ceil(rowBytes / 4) * 4;
    const bufferView = this.tree.bufferViews.push({ buffer: 0, byteStride }) - 1;
    this.contents[bufferView] = spread(bytes, rowBytes, byteStride);
    Object.assign(accessor, { bufferView, count });
    delete accessor.byteOffset;
    correctBounds(accessor, bytes);
  }

  /**
   * The indices take the place of the compressed data.
   * @param {any} decoder
   * @param {any} mesh
   * @param {any} primitive
   * @param {number} compressedView
   */
  addIndices(decoder, mesh, primitive, compressedView) {
    primitive.indices ??= this.tree.accessors.push({ type: 'SCALAR' }) - 1;
    if (this.isDone(primitive.indices)) return;
    const count = 3 * mesh.num_faces();
    const bytes = copyOut(this.draco, 4 * count, (pointer) =>
      decoder.GetTrianglesUInt32Array(mesh, 4 * count, pointer));
    const isFree = !this.isDone(`view ${compressedView}`);
    const bufferView = isFree ? compressedView : this.tree.bufferViews.length;
    this.tree.bufferViews[bufferView] = { buffer: 0 };
    this.contents[bufferView] = bytes;
    const accessor = this.tree.accessors[primitive.indices];
    Object.assign(accessor, { bufferView, componentType: unsignedInt, count });
    delete accessor.byteOffset;
    delete accessor.min;
    delete accessor.max;
  }

  /** Whether it was asked about before. @param {number | string} key */
  isDone(key) {
    const isDone = this.done.has(key);
    this.done.add(key);
    return isDone;
  }
}

/**
 * Changes the tree, and adds to the contents.
 * @param {any} tree
 * @param {Uint8Array[]} contents per buffer view; grows
 * @returns {Promise<void>}
 */
export async function decodeDracoPrimitives(tree, contents) {
  const primitives = (tree.meshes ?? [])
    .flatMap((/** @type {any} */ mesh) => mesh.primitives)
    .filter((/** @type {any} */ primitive) => primitive.extensions?.[dracoExtension]);
  if (primitives.length === 0) return;
  const { default: createDraco } = await import('../draco_decoder.mjs');
  const decoder = new PrimitiveDecoder(await createDraco(), tree, contents);
  for (const primitive of primitives) decoder.decode(primitive);
}

export { dracoExtension };
