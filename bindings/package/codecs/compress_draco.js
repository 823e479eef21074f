// SPDX-License-Identifier: MIT
// KHR_draco_mesh_compression: each primitive of triangles becomes one compressed range. Where their
// order matters, as of quads and under morph targets, triangles and vertices keep it.

import { directionBits, finestTexcoord } from './gltf_data.js';
import { areApart, extentOf, shareMoved, stepFor } from './rounded_positions.js';

/** @typedef {import('./gltf_data.js').GltfData} GltfData */

const extension = 'KHR_draco_mesh_compression';
const [unsignedInt, float] = [5125, 5126];

const mostBits = 24; // more than floats hold


const arrays = /** @type {Record<number, any>} */ ({ 5120: Int8Array, 5121: Uint8Array,
  5122: Int16Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array });
const adders = /** @type {Record<number, string>} */ ({ 5120: 'AddInt8Attribute',
  5121: 'AddUInt8Attribute', 5122: 'AddInt16Attribute', 5123: 'AddUInt16Attribute',
  5125: 'AddUInt32Attribute', 5126: 'AddFloatAttribute' });

/** @param {string} semantic */
function kindOf(semantic) {
  if (semantic === 'POSITION' || semantic === 'NORMAL') return semantic;
  if (semantic.startsWith('COLOR_')) return 'COLOR';
  return semantic.startsWith('TEXCOORD_') ? 'TEX_COORD' : 'GENERIC';
}

/**
 * The rows of an array that are named, in the order of their first naming.
 * @param {ArrayLike<number>} indices
 */
function usedRows(indices) {
  /** @type {Map<number, number>} */
  const places = new Map();
  const renamed = Uint32Array.from(indices, (index) => {
    const place = places.get(index) ?? places.size;
    places.set(index, place);
    return place;
  });
  return { rows: [...places.keys()], renamed };
}

/** @param {any} values @param {number} width @param {number[]} rows */
function taken(values, width, rows) {
  const result = new values.constructor(width * rows.length);
  rows.forEach((row, i) => {
    result.set(values.subarray(width * row, width * (row + 1)), width * i);
  });
  return result;
}

/** Texture coordinates to less than a tenth of a texel of 4096, where they are not very large.
 * @param {any} encoder @param {number} id @param {Float32Array} values */
function quantizeTexcoords(encoder, id, values) {
  let [least, most] = [Infinity, -Infinity];
  for (const value of values) [least, most] = [Math.min(least, value), Math.max(most, value)];
  const bits = Math.ceil(Math.log2((most - least) / finestTexcoord + 1));
  if (bits <= mostBits) encoder.SetAttributeQuantization(id, Math.max(1, bits));
}

// Draco takes origin and range as texts of six decimals.
const decimal = 1e-6;

/** The points as Draco decodes them. @param {Float32Array} points @param {Grid} grid */
function decoded(points, { low, bits, range }) {
  const step = Math.fround(range / (2 ** bits - 1));
  return points.map((value, i) => low[i % 3] + Math.round((value - low[i % 3]) / step) * step);
}

/** @typedef {{ low: number[], bits: number, range: number }} Grid */

/**
 * One grid for all positions of a file, so that parts keep common borders; undefined if floats
 * could hold none that is fine enough.
 * @param {Float32Array[]} meshes
 * @returns {Grid | undefined}
 */
function gridFor(meshes) {
  const step = stepFor(meshes);
  if (step === undefined) return undefined;
  const extents = meshes.map(extentOf);
  const low = [0, 1, 2].map((k) =>
    Math.floor(Math.min(...extents.map((extent) => extent.low[k])) / decimal) * decimal);
  const sides = extents.flatMap(({ high }) => high.map((value, k) => value - low[k]));
  const range = Math.ceil(Math.max(...sides) / decimal + 1) * decimal;
  for (let bits = Math.ceil(Math.log2(range / step + 1)); bits <= mostBits; bits += 1) {
    const grid = { low, bits, range };
    if (meshes.every((points) => areApart(points, decoded(points, grid)))) return grid;
  }
  return undefined;
}

class Packer {
  /** @param {any} draco the encoder's module @param {GltfData} data */
  constructor(draco, data) {
    this.draco = draco;
    this.data = data;
    /** @type {Grid | undefined} of positions */
    this.grid = undefined;
    /** @type {Set<number>} accessors that keep their data, or that are compressed already */
    this.kept = new Set();
  }

  /** @param {any} primitive */
  canPack({ attributes = {}, indices, mode = 4, extensions = {} }) {
    const { data } = this;
    const numbers = Object.values(attributes);
    const isPlain = (/** @type {number} */ number) => data.isPlain(number);
    return mode === 4 && attributes.POSITION !== undefined && !extensions[extension]
      && numbers.every(isPlain) && data.isFloats(attributes.POSITION)
      && (indices === undefined || isPlain(indices));
  }

  /** The corners of the triangles. @param {any} primitive */
  #cornersOf({ attributes, indices }) {
    const { accessors } = this.data.tree;
    if (indices === undefined) {
      return Uint32Array.from({ length: accessors[attributes.POSITION].count }, (_, i) => i);
    }
    const { componentType } = accessors[indices];
    return Uint32Array.from(new arrays[componentType](this.data.rows(indices).buffer));
  }

  /**
   * Adds an attribute of a primitive, quantized or as it is.
   * @param {any} builder @param {any} mesh @param {any} encoder
   * @param {{ semantic: string, number: number, rows: number[] }} attribute
   * @returns {number} Draco's number of it
   */
  #add(builder, mesh, encoder, { semantic, number, rows }) {
    const { draco, data } = this;
    const { componentType } = data.tree.accessors[number];
    const width = data.widthOf(number);
    const kind = kindOf(semantic);
    const values = taken(new arrays[componentType](data.rows(number).buffer), width, rows);
    const id = builder[adders[componentType]](mesh, draco[kind], rows.length, width, values);
    if (componentType !== float) return id;
    if (kind === 'NORMAL') encoder.SetAttributeQuantization(id, directionBits);
    if (kind === 'TEX_COORD') quantizeTexcoords(encoder, id, values);
    if (kind === 'POSITION' && this.grid) {
      const { bits, low, range } = this.grid;
      encoder.SetAttributeExplicitQuantization(id, bits, width, low, range);
    }
    return id;
  }

  /** The corners that are encoded, and the vertices, by their numbers. @param {any} primitive */
  #shown(primitive) {
    const given = this.#cornersOf(primitive);
    if (!primitive.targets) return usedRows(given);
    const { count } = this.data.tree.accessors[primitive.attributes.POSITION];
    return { rows: Array.from({ length: count }, (_, i) => i), renamed: given };
  }

  /**
   * @param {any} primitive @param {boolean} isOrdered
   * @returns {{ bytes: Uint8Array, ids: Record<string, number>, points: number, corners: number }
   *   | undefined} undefined if it cannot be encoded
   */
  #encoded(primitive, isOrdered) {
    const { draco } = this;
    const { rows, renamed } = this.#shown(primitive);
    const [builder, mesh] = [new draco.MeshBuilder(), new draco.Mesh()];
    const [encoder, target] = [new draco.ExpertEncoder(mesh), new draco.DracoInt8Array()];
    try {
      const ids = Object.fromEntries(Object.entries(primitive.attributes).map(
        ([semantic, number]) =>
          [semantic, this.#add(builder, mesh, encoder, { semantic, number, rows })]));
      builder.AddFacesToMesh(mesh, renamed.length / 3, renamed);
      encoder.SetSpeedOptions(5, 5);
      encoder.SetTrackEncodedProperties(true);
      encoder.SetEncodingMethod(
        isOrdered ? draco.MESH_SEQUENTIAL_ENCODING : draco.MESH_EDGEBREAKER_ENCODING);
      const length = encoder.EncodeToDracoBuffer(!isOrdered, target);
      if (length <= 0) return undefined;
      return { ids, bytes: Uint8Array.from({ length }, (_, i) => target.GetValue(i)),
        points: encoder.GetNumberOfEncodedPoints(),
        corners: 3 * encoder.GetNumberOfEncodedFaces() };
    } finally {
      for (const object of [target, encoder, mesh, builder]) draco.destroy(object);
    }
  }

  /** The number of an accessor whose data is compressed: the same one for its first primitive.
   * @param {number} number @param {number} count */
  #described(number, count) {
    const { accessors } = this.data.tree;
    const isFree = !this.kept.has(number);
    this.kept.add(number);
    const place = isFree ? number : accessors.push({ ...accessors[number] }) - 1;
    delete accessors[place].bufferView;
    delete accessors[place].byteOffset;
    accessors[place].count = count;
    return place;
  }

  /** @param {any} primitive @param {NonNullable<ReturnType<Packer['encode']>>} encoded */
  put(primitive, { bytes, ids, points, corners }) {
    const { data } = this;
    const indices = primitive.indices
      ?? data.tree.accessors.push({ componentType: unsignedInt, type: 'SCALAR', count: 0 }) - 1;
    for (const [semantic, number] of Object.entries(primitive.attributes)) {
      primitive.attributes[semantic] = this.#described(number, points);
    }
    primitive.indices = this.#described(indices, corners);
    primitive.mode = 4;
    primitive.extensions = { ...primitive.extensions,
      [extension]: { bufferView: data.addView(bytes), attributes: ids } };
  }

  /** @param {any} primitive @param {boolean} areQuads */
  encode(primitive, areQuads) {
    return this.#encoded(primitive, areQuads || primitive.targets !== undefined);
  }
}

/** The accessors that something else than primitives of triangles uses. @param {GltfData} data
 * @param {any[]} packed the primitives that are compressed @returns {Set<number>} */
function usedOtherwise({ tree }, packed) {
  /** @type {Set<number>} */
  const numbers = new Set();
  for (const { samplers = [] } of tree.animations ?? []) {
    for (const { input, output } of samplers) numbers.add(input).add(output);
  }
  for (const { inverseBindMatrices } of tree.skins ?? []) numbers.add(inverseBindMatrices);
  for (const { extensions = {} } of tree.nodes ?? []) {
    const { attributes = {} } = extensions.EXT_mesh_gpu_instancing ?? {};
    for (const number of Object.values(attributes)) numbers.add(number);
  }
  const primitives = (tree.meshes ?? []).flatMap((/** @type {any} */ mesh) => mesh.primitives);
  for (const primitive of primitives) {
    const { attributes = {}, indices, targets = [] } = primitive;
    const others = packed.includes(primitive) ? targets : [attributes, { indices }, ...targets];
    for (const one of others) for (const number of Object.values(one)) numbers.add(number);
  }
  return numbers;
}

/**
 * @param {GltfData} data
 * @returns {Promise<number>} how far a position moves at most, in percent of its mesh's diagonal
 */
export async function compressByDraco(data) {
  const { default: createDraco } = await import('../draco_encoder.mjs');
  const areQuads = data.tree.extensionsUsed?.includes('FB_ngon_encoding') === true;
  const packer = new Packer(await createDraco(), data);
  const fit = data.primitives().filter((primitive) => packer.canPack(primitive));
  const positions = [...new Set(fit.map(({ attributes }) => attributes.POSITION))]
    .map((number) => data.floats(number));
  const grid = gridFor(positions);
  packer.grid = grid;
  /** @type {[any, any][]} */
  const encoded = fit.map((primitive) => [primitive, packer.encode(primitive, areQuads)]);
  const packed = encoded.filter(([, result]) => result !== undefined);
  if (packed.length === 0) return 0;
  packer.kept = usedOtherwise(data, packed.map(([primitive]) => primitive));
  for (const [primitive, result] of packed) packer.put(primitive, result);
  data.require(extension);
  return grid ? 100 * Math.max(...positions.map((points) =>
    shareMoved(points, decoded(points, grid)))) : 0;
}
