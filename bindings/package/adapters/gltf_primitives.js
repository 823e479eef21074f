// SPDX-License-Identifier: MIT
// Makes one mesh in groups of a mesh of glTF-Transform, a group for each primitive of triangles,
// and makes primitives of it again. Primitives that share accessors still do.

import { Primitive } from '@gltf-transform/core';

import {
  canRoundPositions, decoded, encoded, makeUnitLength, normalizeWeights,
} from './number_types.js';
import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { picked, pickedPositions, separated } from './vertex_pools.js';

/** @import { Accessor, Document, Mesh as GltfMesh } from '@gltf-transform/core' */
/** @import { Mesh, NumberArray } from '../base/messages.js' */
/** @import { PoolResult, VertexPool } from './vertex_pools.js' */

/** @typedef {Map<string, Accessor>} Accessors by semantic, morph targets' too */

/**
 * @typedef {object} Part
 * @property {GltfMesh} mesh
 * @property {{ pool: VertexPool, accessors: Accessors, primitives: Map<number, Primitive> }[]}
 *   streams primitives by group, which is their number in the mesh
 */

const { TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN } = Primitive.Mode;

/** @param {Primitive} primitive one that can be remeshed */
export const isTriangles = (primitive) =>
  [TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN].includes(/** @type {4} */ (primitive.getMode()))
  && Boolean(primitive.getAttribute('POSITION'));

/** @param {Primitive} primitive @returns {Accessors} */
function accessorsOf(primitive) {
  const accessors = new Map(primitive.listSemantics().map((semantic) =>
    [semantic, /** @type {Accessor} */ (primitive.getAttribute(semantic))]));
  primitive.listTargets().forEach((target, i) => {
    for (const semantic of target.listSemantics()) {
      accessors.set(`TARGET_${i}/${semantic}`,
        /** @type {Accessor} */ (target.getAttribute(semantic)));
    }
  });
  return accessors;
}

/** @param {Accessors} a @param {Accessors} b */
const areSame = (a, b) => a.size === b.size
  && [...a].every(([semantic, accessor]) => b.get(semantic) === accessor);

/** @param {Accessor} accessor @param {string} label @param {number} count */
function floatsOf(accessor, label, count) {
  const array = accessor.getArray();
  if (!array || accessor.getCount() < count) {
    throw new RemeshError('PARSE_ERROR',
      `${label} has values for ${accessor.getCount()} vertices, but there are ${count}.`);
  }
  return decoded(/** @type {NumberArray} */ (array), accessor.getNormalized());
}

/** @param {string} label @param {Accessors} accessors @returns {VertexPool} */
function readPool(label, accessors) {
  const position = /** @type {Accessor} */ (accessors.get('POSITION'));
  const count = position.getCount();
  const others = [...accessors].filter(([semantic]) => semantic !== 'POSITION');
  return {
    label,
    positions: floatsOf(position, `${label}: POSITION`, count),
    attributes: new Map(others.map(([semantic, accessor]) => [semantic, {
      values: floatsOf(accessor, `${label}: ${legible(semantic)}`, count),
      itemSize: accessor.getElementSize(),
    }])),
    triangles: new Map(),
  };
}

/** Strips are stitched together by triangles that name a vertex twice.
 * @param {ArrayLike<number>} sequence */
function* stripTriangles(sequence) {
  for (let i = 0; i + 2 < sequence.length; i += 1) {
    const [a, b, c] = [sequence[i], sequence[i + 1 + (i % 2)], sequence[i + 2 - (i % 2)]];
    if (a !== b && b !== c && c !== a) yield* [a, b, c];
  }
}

/** @param {ArrayLike<number>} sequence */
function* fanTriangles(sequence) {
  for (let i = 0; i + 2 < sequence.length; i += 1) {
    yield* [sequence[i + 1], sequence[i + 2], sequence[0]];
  }
}

/** @param {Primitive} primitive @param {number} vertexCount */
function trianglesOf(primitive, vertexCount) {
  const sequence = primitive.getIndices()?.getArray()
    ?? Uint32Array.from({ length: vertexCount }, (_, i) => i);
  if (primitive.getMode() === TRIANGLE_STRIP) return Uint32Array.from(stripTriangles(sequence));
  if (primitive.getMode() === TRIANGLE_FAN) return Uint32Array.from(fanTriangles(sequence));
  return Uint32Array.from(sequence.subarray(0, sequence.length - (sequence.length % 3)));
}

/** @param {GltfMesh} mesh @returns {Part} */
export function readPart(mesh) {
  /** @type {Part} */
  const part = { mesh, streams: [] };
  mesh.listPrimitives().forEach((primitive, group) => {
    if (!isTriangles(primitive)) return;
    const accessors = accessorsOf(primitive);
    let stream = part.streams.find((other) => areSame(other.accessors, accessors));
    if (!stream) {
      const label = `Mesh '${legible(mesh.getName())}', primitive ${group}`;
      stream = { pool: readPool(label, accessors), accessors, primitives: new Map() };
      part.streams.push(stream);
    }
    const triangles = trianglesOf(primitive, stream.pool.positions.length / 3);
    stream.pool.triangles.set(group, triangles);
    stream.primitives.set(group, primitive);
  });
  return part;
}

/** An accessor like the old one, with other values. @param {Document} document
 * @param {Accessor} old @param {NumberArray} array */
function accessorLike(document, old, array) {
  return document.createAccessor(old.getName()).setType(old.getType())
    .setArray(/** @type {any} */ (array)).setBuffer(old.getBuffer())
    .setNormalized(old.getNormalized() && !(array instanceof Float32Array))
    .setSparse(old.getSparse()).setExtras(old.getExtras());
}

/** Integer positions stay so where integers are fine enough. @param {Mesh} mesh
 * @param {Uint32Array} vertices @param {Accessor} old @returns {NumberArray} */
function newPositions(mesh, vertices, old) {
  const values = Float32Array.from(pickedPositions(mesh.positions, vertices));
  const model = /** @type {NumberArray} */ (old.getArray());
  const isNormalized = old.getNormalized();
  return canRoundPositions(mesh, model, isNormalized)
    ? encoded(values, model, isNormalized) : values;
}

/**
 * @param {Document} document
 * @param {Mesh} mesh
 * @param {Uint32Array} vertices
 * @param {Accessors} olds
 * @returns {Accessors} new ones, by semantic
 */
function newAccessors(document, mesh, vertices, olds) {
  const attributes = mesh.attributes ?? {};
  const floats = new Map([...olds].filter(([semantic]) => semantic !== 'POSITION')
    .map(([semantic, old]) => {
      const itemSize = old.getElementSize();
      const values = picked(attributes[semantic], vertices, itemSize);
      makeUnitLength(semantic, { values, itemSize });
      return [semantic, { values, itemSize, isNormalized: old.getNormalized(),
        model: /** @type {NumberArray} */ (old.getArray()) }];
    }));
  normalizeWeights(floats);
  return new Map([...olds].map(([semantic, old]) => {
    const own = floats.get(semantic);
    const array = own ? encoded(own.values, own.model, own.isNormalized)
      : newPositions(mesh, vertices, old);
    return [semantic, accessorLike(document, old, array)];
  }));
}

/** Indices of 16 bits, or of 8 like the old ones, if that suffices. @param {Document} document
 * @param {Primitive} primitive @param {Uint32Array} triangles @param {number} vertexCount */
function newIndices(document, primitive, triangles, vertexCount) {
  const old = primitive.getIndices();
  const isByte = old?.getArray() instanceof Uint8Array && vertexCount <= 255;
  const Kind = vertexCount > 65535 ? Uint32Array : isByte ? Uint8Array : Uint16Array;
  const array = Kind.from(triangles);
  return old ? accessorLike(document, old, array)
    : document.createAccessor().setType('SCALAR').setArray(array)
      .setBuffer(primitive.getAttribute('POSITION')?.getBuffer() ?? null);
}

/** A morph target may be another primitive's too. @param {Document} document
 * @param {Primitive} primitive @param {Accessors} accessors */
function replaceTargets(document, primitive, accessors) {
  const olds = primitive.listTargets();
  for (const old of olds) primitive.removeTarget(old);
  olds.forEach((old, i) => {
    const target = document.createPrimitiveTarget(old.getName()).setExtras(old.getExtras());
    for (const semantic of old.listSemantics()) {
      target.setAttribute(semantic, accessors.get(`TARGET_${i}/${semantic}`) ?? null);
    }
    primitive.addTarget(target);
    disposeUnused(old);
  });
}

/** @param {Accessor | import('@gltf-transform/core').PrimitiveTarget | Primitive} property */
function disposeUnused(property) {
  if (property.listParents().every((parent) => parent.propertyType === 'Root')) property.dispose();
}

/** @param {Document} document @param {Primitive} primitive @param {Accessors} accessors
 * @param {Uint32Array} triangles */
function replacePrimitive(document, primitive, accessors, triangles) {
  const vertexCount = accessors.get('POSITION')?.getCount() ?? 0;
  primitive.setIndices(newIndices(document, primitive, triangles, vertexCount))
    .setMode(TRIANGLES);
  for (const semantic of primitive.listSemantics()) {
    primitive.setAttribute(semantic, accessors.get(semantic) ?? null);
  }
  replaceTargets(document, primitive, accessors);
}

/** Says of a primitive whether its triangles are quads, two in a row each.
 * @param {Primitive} primitive @param {boolean} isQuads */
function tellQuads(primitive, isQuads) {
  const extras = primitive.getExtras();
  if (isQuads || extras.quads) primitive.setExtras({ ...extras, quads: isQuads });
}

/** Gives the mesh primitives that no other mesh has. @param {Part} part */
function ownPrimitives({ mesh, streams }) {
  const all = mesh.listPrimitives();
  const isShared = (/** @type {Primitive} */ primitive) => primitive.listParents()
    .some((parent) => parent !== mesh && parent.propertyType === 'Mesh');
  if (!all.some(isShared)) return;
  for (const primitive of all) mesh.removePrimitive(primitive);
  all.forEach((primitive, group) => {
    const own = isShared(primitive) ? primitive.clone() : primitive;
    mesh.addPrimitive(own);
    const stream = streams.find(({ primitives }) => primitives.has(group));
    stream?.primitives.set(group, own);
  });
}

/** Accessors that go when nothing else holds them. @param {Part} part @returns {Set<Accessor>} */
const heldBy = ({ streams }) => new Set(streams.flatMap(({ accessors, primitives }) => [
  ...accessors.values(),
  ...[...primitives.values()].map((primitive) => primitive.getIndices())
    .filter((indices) => indices !== null)]));

/**
 * @param {Document} document
 * @param {Part} part
 * @param {Mesh} mesh the part's, remeshed
 */
export function writePart(document, part, mesh) {
  const olds = heldBy(part);
  ownPrimitives(part);
  for (const { pool, accessors, primitives } of part.streams) {
    const { vertices, triangles } = separated(mesh, pool);
    const news = vertices.length > 0
      ? newAccessors(document, mesh, vertices, accessors) : new Map();
    for (const [group, primitive] of primitives) {
      const own = /** @type {Uint32Array} */ (triangles.get(group));
      if (own.length > 0) {
        replacePrimitive(document, primitive, news, own);
        tellQuads(primitive, Boolean(mesh.quads));
      } else {
        primitive.dispose();
      }
    }
  }
  olds.forEach(disposeUnused);
  if (part.mesh.listPrimitives().length === 0) part.mesh.dispose();
}
