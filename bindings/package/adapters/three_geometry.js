// SPDX-License-Identifier: MIT
// Joins geometries of three.js to one mesh in groups, and makes new ones of the remeshed mesh.
// Geometries that share attributes (primitives of a glTF mesh, for instance) share the new ones.

import { BufferAttribute, BufferGeometry, InstancedBufferGeometry } from 'three';

import { RemeshError } from '../base/errors.js';
import { canRoundPositions, makeUnitLength, normalizeWeights } from './number_types.js';
import { attributeLike, floatsOf, positionsOf, semanticOf } from './three_attributes.js';
import { addGroups, materialSets } from './three_groups.js';
import { picked, pickedPositions, separated } from './vertex_pools.js';

/** @import { Mesh, NumberArray } from '../base/messages.js' */
/** @import { AnyAttribute } from './three_attributes.js' */
/** @import { MaterialSet } from './three_groups.js' */
/** @import { VertexPool, PoolResult } from './vertex_pools.js' */

/**
 * An attribute that is remeshed.
 * @typedef {object} Slot
 * @property {string} name in three.js
 * @property {number} [target] of a morph target
 * @property {string} semantic
 * @property {AnyAttribute} attribute
 */

/**
 * @typedef {object} Part
 * @property {BufferGeometry[]} geometries
 * @property {VertexPool[]} pools
 * @property {Map<BufferGeometry, VertexPool>} poolOf
 * @property {Map<BufferGeometry, Map<number, MaterialSet>>} setsOf by group
 */

/** @param {AnyAttribute} attribute */
const isInstanced = (attribute) => 'isInstancedBufferAttribute' in attribute
  || ('data' in attribute && 'isInstancedInterleavedBuffer' in attribute.data);

/** All but the positions. @param {BufferGeometry} geometry @returns {Slot[]} */
function slotsOf({ attributes, morphAttributes }) {
  const own = Object.entries(attributes).filter(([name, attribute]) =>
    name !== 'position' && !isInstanced(attribute))
    .map(([name, attribute]) => ({ name, semantic: semanticOf(name), attribute }));
  const morphs = Object.entries(morphAttributes).flatMap(([name, list = []]) =>
    list.map((attribute, target) =>
      ({ name, target, semantic: `TARGET_${target}/${semanticOf(name)}`, attribute })));
  return [...own, ...morphs];
}

/** Geometries with the same data share vertices. @param {BufferGeometry} geometry */
const vertexData = (geometry) => [geometry.morphTargetsRelative, geometry.attributes.position,
  ...slotsOf(geometry).flatMap(({ semantic, attribute }) => [semantic, attribute])];

/** @param {BufferGeometry} a @param {BufferGeometry} b */
function onSameVertices(a, b) {
  const others = vertexData(b);
  return vertexData(a).every((value, i, all) => value === others[i]
    && all.length === others.length);
}

/** @param {Float32Array} values @param {ArrayLike<number>} base @param {1 | -1} sign */
const shifted = (values, base, sign) => values.map((value, i) => value + sign * base[i]);

/** Morph targets are mixed as displacements. @param {BufferGeometry} geometry */
function readPool(geometry) {
  const positions = positionsOf(geometry.attributes.position);
  const count = positions.length / 3;
  /** @type {VertexPool['attributes']} */
  const attributes = new Map();
  for (const { name, target, semantic, attribute } of slotsOf(geometry)) {
    let values = floatsOf(attribute, name, count);
    const base = geometry.attributes[name];
    if (target !== undefined && !geometry.morphTargetsRelative && base) {
      values = shifted(values, name === 'position' ? positions : floatsOf(base, name, count), -1);
    }
    attributes.set(semantic, { values, itemSize: attribute.itemSize });
  }
  const label = geometry.name ? `The geometry '${geometry.name}'` : 'The geometry';
  return { label, positions, attributes, triangles: new Map() };
}

/** @param {BufferGeometry} geometry @param {MaterialSet} set @returns {Uint32Array} */
function trianglesOf({ index }, { ranges }) {
  const length = ranges.reduce((sum, [from, to]) => sum + to - from, 0);
  const triangles = new Uint32Array(length);
  let at = 0;
  for (const [from, to] of ranges) {
    for (let i = from; i < to; i += 1) triangles[at++] = index ? index.getX(i) : i;
  }
  return triangles;
}

/** @param {unknown} geometry */
function checkGeometry(geometry) {
  const { isBufferGeometry, attributes } = /** @type {any} */ (geometry ?? {});
  if (!isBufferGeometry) {
    throw new RemeshError('INVALID_MESH', 'The geometry must be a BufferGeometry of three.js.');
  }
  if (!attributes.position) {
    throw new RemeshError('INVALID_MESH', 'The geometry has no attribute position.');
  }
}

/** @param {BufferGeometry[]} geometries @returns {Part} */
export function readPart(geometries) {
  /** @type {Part} */
  const part = { geometries, pools: [], poolOf: new Map(), setsOf: new Map() };
  let group = 0;
  for (const geometry of geometries) {
    checkGeometry(geometry);
    const same = [...part.poolOf.keys()].find((other) => onSameVertices(other, geometry));
    const pool = (same && part.poolOf.get(same)) ?? readPool(geometry);
    if (!same) part.pools.push(pool);
    part.poolOf.set(geometry, pool);
    const length = geometry.index?.count ?? geometry.attributes.position.count;
    const sets = new Map();
    for (const set of materialSets(geometry, length)) {
      pool.triangles.set(group, trianglesOf(geometry, set));
      sets.set(group, set);
      group += 1;
    }
    part.setsOf.set(geometry, sets);
  }
  return part;
}

/**
 * New attributes on a pool's vertices, by semantic.
 * @typedef {Map<string, BufferAttribute>} NewAttributes
 */

/** Integer positions stay so where integers are fine enough. @param {Mesh} mesh
 * @param {Uint32Array} vertices @param {AnyAttribute} model */
function newPositions(mesh, vertices, model) {
  const values = pickedPositions(mesh.positions, vertices);
  const { array, normalized } = model;
  const isHalf = 'isFloat16BufferAttribute' in model;
  const fits = isHalf || canRoundPositions(mesh, /** @type {NumberArray} */ (array), normalized);
  if (fits) return attributeLike(model, values);
  const attribute = new BufferAttribute(Float32Array.from(values), 3);
  attribute.name = model.name;
  return attribute;
}

/** The pool's attributes, still as floats. @param {Mesh} mesh @param {Uint32Array} vertices
 * @param {Slot[]} slots */
function floatsOn({ attributes = {} }, vertices, slots) {
  const floats = new Map(slots.map(({ semantic, attribute }) => {
    const { itemSize, normalized, array } = attribute;
    const values = picked(attributes[semantic], vertices, itemSize);
    makeUnitLength(semantic, { values, itemSize });
    return [semantic, { values, itemSize, model: /** @type {NumberArray} */ (array),
      isNormalized: normalized }];
  }));
  normalizeWeights(floats);
  return floats;
}

/**
 * @param {Mesh} mesh
 * @param {Uint32Array} vertices
 * @param {BufferGeometry} model
 * @returns {NewAttributes}
 */
function newAttributes(mesh, vertices, model) {
  /** @type {NewAttributes} */
  const result = new Map();
  result.set('POSITION', newPositions(mesh, vertices, model.attributes.position));
  const slots = slotsOf(model);
  const floats = floatsOn(mesh, vertices, slots);
  for (const { name, target, semantic, attribute } of slots) {
    const { values } = /** @type {{ values: Float32Array }} */ (floats.get(semantic));
    const base = target === undefined || model.morphTargetsRelative
      ? undefined : result.get(semanticOf(name));
    const moved = base ? shifted(values, floatsOf(base, name, base.count), 1) : values;
    result.set(semantic, attributeLike(attribute, moved));
  }
  return result;
}

/** @param {BufferGeometry} from @param {BufferGeometry} to */
function copyTheRest(from, to) {
  to.name = from.name;
  to.morphTargetsRelative = from.morphTargetsRelative;
  for (const [name, attribute] of Object.entries(from.attributes)) {
    if (isInstanced(attribute)) to.setAttribute(name, attribute);
  }
  if (from.boundingBox) to.computeBoundingBox();
  if (from.boundingSphere) to.computeBoundingSphere();
}

/** Of 32 bits if needed, else of 16. @param {Uint32Array} index @param {number} vertexCount */
function newIndex(index, vertexCount) {
  return new BufferAttribute(vertexCount > 65535 ? index : Uint16Array.from(index), 1);
}

/**
 * @param {BufferGeometry} model
 * @param {NewAttributes} attributes
 * @param {PoolResult} pool
 * @param {Map<number, MaterialSet>} sets
 */
function newGeometry(model, attributes, pool, sets) {
  const geometry = 'isInstancedBufferGeometry' in model
    ? new InstancedBufferGeometry() : new BufferGeometry();
  if ('instanceCount' in geometry && 'instanceCount' in model) {
    geometry.instanceCount = /** @type {number} */ (model.instanceCount);
  }
  const take = (/** @type {string} */ semantic) =>
    /** @type {BufferAttribute} */ (attributes.get(semantic));
  geometry.setAttribute('position', take('POSITION'));
  const morphs = /** @type {Record<string, BufferAttribute[]>} */ (geometry.morphAttributes);
  for (const { name, target, semantic } of slotsOf(model)) {
    if (target === undefined) geometry.setAttribute(name, take(semantic));
    else (morphs[name] ??= [])[target] = take(semantic);
  }
  const runs = [...sets].map(([group, { materials }]) =>
    ({ materials, corners: pool.triangles.get(group) ?? new Uint32Array() }));
  const index = Uint32Array.from(runs.flatMap(({ corners }) => [...corners]));
  geometry.setIndex(newIndex(index, pool.vertices.length));
  addGroups(geometry,
    runs.map(({ materials, corners }) => ({ materials, length: corners.length })));
  copyTheRest(model, geometry);
  return geometry;
}

/** What the user keeps on a geometry, with a word on quads where there are any.
 * @param {BufferGeometry} from @param {boolean} isQuads */
function userDataOf({ userData }, isQuads) {
  if (isQuads) return { ...userData, quads: true };
  return userData.quads ? { ...userData, quads: false } : userData;
}

/**
 * @param {Part} part
 * @param {Mesh} mesh the part's, remeshed
 * @returns {Map<BufferGeometry, BufferGeometry>} new ones by old ones
 */
export function writePart({ geometries, pools, poolOf, setsOf }, mesh) {
  const results = new Map(pools.map((pool) => [pool, separated(mesh, pool)]));
  /** @type {Map<VertexPool, NewAttributes>} */
  const attributes = new Map();
  return new Map(geometries.map((geometry) => {
    const pool = /** @type {VertexPool} */ (poolOf.get(geometry));
    const result = /** @type {PoolResult} */ (results.get(pool));
    const own = attributes.get(pool) ?? newAttributes(mesh, result.vertices, geometry);
    attributes.set(pool, own);
    const made = newGeometry(geometry, own, result,
      /** @type {Map<number, MaterialSet>} */ (setsOf.get(geometry)));
    made.userData = userDataOf(geometry, Boolean(mesh.quads));
    return [geometry, made];
  }));
}
