// SPDX-License-Identifier: MIT
// Checks and copies the meshes and files that the caller gives: the arrays stay the caller's, and
// the copies can be handed over to a worker.

import { abortError, RemeshError } from '../base/errors.js';
import { bytesAsked, bytesLooked, isLeftToCore } from '../base/contents.js';
import { withoutGz } from '../base/formats.js';
import { legible } from '../base/legible.js';
import { nearest } from '../base/nearest.js';
import { OpenFile } from '../base/open_file.js';
import { Pieces } from '../base/pieces.js';

/** @import {
 *   FileRequest, Indices, Mesh, MeshAttribute, NumberArray, PlacedMesh,
 * } from '../base/messages.js' */

/**
 * A file's contents, at once or as a stream of `Uint8Array`s: a web stream, one of Node's, or any
 * other async iterable. Of a `File`, the name is known too.
 * @typedef {Uint8Array | ArrayBuffer | Blob | ReadableStream<Uint8Array>
 *   | AsyncIterable<Uint8Array>} Bytes
 */

/**
 * @typedef {object} FileOptions
 * @property {string} [name] The file's name; its extension, before a .gz, tells the format.
 * @property {Record<string, Bytes>} [resources] Files it refers to, by the names it uses for them.
 */

/**
 * @typedef {object} OutputOptions
 * @property {string} [output] A name, or a bare format like `glb`; the input's if not given.
 * @property {boolean} [metres] `false`: a glTF keeps the numbers of a model in another unit,
 *   without the scale that makes metres of them.
 */

/** @param {string} message @param {string} [hint] @returns {never} */
function refuseMesh(message, hint) {
  throw new RemeshError('INVALID_MESH', message, hint);
}

/** Fields of a caller's own are left alone, but not one that was probably meant to be one of ours.
 * @param {object} given @param {readonly string[]} known its fields @param {string} label */
function refuseMisspelt(given, known, label) {
  for (const name of Object.keys(given)) {
    const meant = known.includes(name) ? undefined : nearest(name, known);
    if (meant) refuseMesh(`${label}.${legible(name)} is not known.`, `Did you mean ${meant}?`);
  }
}

/** @param {unknown} value */
function isArrayOfNumbers(value) {
  return ArrayBuffer.isView(value) && !(value instanceof DataView)
    && !(value instanceof BigInt64Array) && !(value instanceof BigUint64Array);
}

/** A copy, on memory of its own. @template Values @param {Values} array @param {string} label */
function copyArray(array, label) {
  try {
    return /** @type {Values} */ (new (/** @type {any} */ (array).constructor)(array));
  } catch (cause) {
    throw new RemeshError('INVALID_MESH', `${label} has lost its memory.`,
      'Its buffer was transferred elsewhere: give a copy there, or here.', { cause });
  }
}

/** @param {unknown} array @returns {array is Indices} */
const isIndices = (array) => array instanceof Uint32Array || array instanceof Uint16Array;

/** @param {unknown} mesh @returns {Mesh} the same in arrays of our own */
export function copyMesh(mesh) {
  if (typeof mesh !== 'object' || mesh === null) {
    refuseMesh('The mesh must be an object { positions, indices, attributes }.',
      'Of a file, give the bytes.');
  }
  const { positions, indices, attributes, groups } = /** @type {any} */ (mesh);
  if (!(positions instanceof Float32Array || positions instanceof Float64Array)) {
    refuseMesh('mesh.positions must be a Float32Array or a Float64Array.');
  }
  if (!isIndices(indices)) {
    refuseMesh('mesh.indices must be a Uint32Array or a Uint16Array.',
      'For a mesh without indices, give 0, 1, 2, …: equal positions are welded.');
  }
  if (positions.length % 3 !== 0) {
    refuseMesh(`mesh.positions has ${positions.length} numbers, which is not a multiple of 3.`);
  }
  if (indices.length % 3 !== 0) {
    refuseMesh(`mesh.indices has ${indices.length} numbers, which is not a multiple of 3.`);
  }
  refuseMisspelt(mesh, ['positions', 'indices', 'attributes', 'groups', 'quads'], 'mesh');
  return {
    positions: copyArray(positions, 'mesh.positions'),
    indices: copyArray(indices, 'mesh.indices'),
    attributes: copyAttributes(attributes ?? {}, positions.length / 3),
    ...(groups === undefined ? {} : { groups: copyGroups(groups, indices.length / 3) }),
  };
}

/** @param {unknown} groups @param {number} triangleCount */
function copyGroups(groups, triangleCount) {
  if (!isIndices(groups)) refuseMesh('mesh.groups must be a Uint32Array or a Uint16Array.');
  if (groups.length !== triangleCount) {
    refuseMesh(`mesh.groups has ${groups.length} numbers for ${triangleCount} triangles.`,
      'Give one number for each triangle.');
  }
  return copyArray(groups, 'mesh.groups');
}

/** @param {unknown} place @param {string} label */
function copyPlace(place, label) {
  const matrix = Float64Array.from(/** @type {ArrayLike<number>} */ (place ?? []));
  const isAffine = matrix.length === 16 && matrix.every(Number.isFinite)
    && [0, 0, 0, 1].every((value, row) => matrix[4 * row + 3] === value);
  if (!isAffine) {
    refuseMesh(`${label} must be an affine matrix of 16 finite numbers, column after column.`);
  }
  return matrix;
}

/** Levels of detail are of meshes that are no levels. @param {any} part @param {any[]} parts
 * @param {string} label */
function copyFiner({ finer }, parts, label) {
  if (finer === undefined) return {};
  const numbers = Array.from(/** @type {ArrayLike<number>} */ (Object(finer)));
  const isFinest = (/** @type {number} */ number) => Number.isInteger(number) && number in parts
    && !(parts[number]?.finer?.length > 0);
  if (!numbers.every(isFinest)) {
    refuseMesh(`${label} must be a list of numbers of meshes in the scene that have no finer ones `
      + 'themselves.');
  }
  return { finer: Uint32Array.from(numbers) };
}

/** @param {unknown} parts @returns {PlacedMesh[]} the same in arrays of our own */
export function copyScene(parts) {
  if (!Array.isArray(parts) || parts.length === 0) {
    refuseMesh('The scene must be a list of { mesh, places } with at least one mesh.');
  }
  return parts.map((part, i) => {
    refuseMisspelt(Object(part), ['mesh', 'places', 'finer'], `parts[${i}]`);
    if (!Array.isArray(part?.places ?? [])) {
      refuseMesh(`parts[${i}].places must be a list of matrices.`);
    }
    return {
      mesh: copyMesh(part?.mesh),
      places: (part.places ?? []).map((/** @type {unknown} */ place, /** @type {number} */ k) =>
        copyPlace(place, `parts[${i}].places[${k}]`)),
      ...copyFiner(Object(part), parts, `parts[${i}].finer`),
    };
  });
}

/** @param {Record<string, MeshAttribute>} attributes @param {number} vertexCount */
function copyAttributes(attributes, vertexCount) {
  /** @type {Record<string, MeshAttribute>} */
  const result = {};
  for (const [semantic, attribute] of Object.entries(attributes)) {
    const { array, itemSize } = attribute ?? {};
    const label = `mesh.attributes.${legible(semantic)}`;
    if (!isArrayOfNumbers(array) || !Number.isInteger(itemSize) || itemSize < 1) {
      refuseMesh(`${label} must be { array, itemSize }, a typed array and a `
        + 'whole number.');
    }
    if (array.length !== vertexCount * itemSize) {
      refuseMesh(`${label} has ${array.length} numbers, but ${vertexCount} `
        + `vertices × ${itemSize} are ${vertexCount * itemSize}.`);
    }
    result[semantic] = { array: copyArray(array, label), itemSize };
  }
  return result;
}

/** The number that is white, or full, in colours of this type. @param {NumberArray} array */
function whiteIn(array) {
  if (array instanceof Uint8Array || array instanceof Uint8ClampedArray) return 255;
  return array instanceof Uint16Array ? 65535 : 1;
}

/**
 * Colours of both meshes in the first one's range, since bytes and fractions mean different things;
 * white bytes for a mesh without colours beside one that has bytes.
 * @param {Mesh} mesh @param {Mesh} other @returns {Mesh}
 */
function withColorsLike(mesh, other) {
  const attributes = { ...mesh.attributes };
  for (const [semantic, { array, itemSize }] of Object.entries(other.attributes ?? {})) {
    if (!semantic.startsWith('COLOR_')) continue;
    const own = attributes[semantic];
    const white = whiteIn(array);
    const colors = own ? Float32Array.from(own.array, (x) => (x * white) / whiteIn(own.array))
      : new (/** @type {any} */ (array).constructor)((mesh.positions.length / 3) * itemSize)
        .fill(white);
    attributes[semantic] = { array: colors, itemSize: own?.itemSize ?? itemSize };
  }
  return { ...mesh, attributes };
}

/** Copies of both operands, which can become one mesh. @param {unknown} a @param {unknown} b
 * @returns {[Mesh, Mesh]} */
export function copyOperands(a, b) {
  const [first, second] = [copyMesh(a), copyMesh(b)];
  return [withColorsLike(first, { ...second, attributes: onlyIn(second, first) }),
    withColorsLike(second, first)];
}

/** The attributes of a mesh that another lacks. @param {Mesh} mesh @param {Mesh} other */
function onlyIn({ attributes = {} }, other) {
  return Object.fromEntries(Object.entries(attributes).filter(([semantic]) =>
    !other.attributes?.[semantic]));
}

/** @param {Mesh} mesh @returns {ArrayBuffer[]} */
export function buffersOf(mesh) {
  const arrays = [mesh.positions, mesh.indices, ...(mesh.groups ? [mesh.groups] : []),
    ...Object.values(mesh.attributes ?? {}).map(({ array }) => array)];
  return arrays.map((array) => /** @type {ArrayBuffer} */ (array.buffer));
}

/** @param {unknown} value @returns {value is Bytes} */
export function isBytes(value) {
  return value instanceof Uint8Array || value instanceof ArrayBuffer || value instanceof OpenFile
    || (typeof Blob !== 'undefined' && value instanceof Blob) || isStream(value);
}

/** @param {unknown} value @returns {value is ReadableStream<Uint8Array>} */
const isWebStream = (value) =>
  typeof ReadableStream !== 'undefined' && value instanceof ReadableStream;

/** @param {unknown} value
 * @returns {value is ReadableStream<Uint8Array> | AsyncIterable<Uint8Array>} */
const isStream = (value) => isWebStream(value)
  || typeof (/** @type {any} */ (value)?.[Symbol.asyncIterator]) === 'function';

/** A web stream as an async iterable, which it is not in every browser.
 * @param {ReadableStream<Uint8Array>} stream */
async function* chunksOf(stream) {
  const reader = stream.getReader();
  try {
    for (let step = await reader.read(); !step.done; step = await reader.read()) yield step.value;
  } finally {
    await reader.cancel().catch(() => {});  // where nobody wants the rest
  }
}

/** @param {ReadableStream<Uint8Array> | AsyncIterable<Uint8Array>} stream
 * @param {AbortSignal} [signal] */
async function collected(stream, signal) {
  const pieces = new Pieces();
  for await (const chunk of isWebStream(stream) ? chunksOf(stream) : stream) {
    if (signal?.aborted) throw abortError();
    if (!(chunk instanceof Uint8Array)) throw new TypeError('The stream is not of bytes.');
    pieces.add(chunk);
  }
  return pieces;
}

/** @typedef {Exclude<Bytes, Uint8Array | ArrayBuffer>} Source */

/** @param {Source} source */
const allOf = async (source) => new OpenFile(isStream(source) ? (await collected(source)).joined()
  : new Uint8Array(await source.arrayBuffer()));

/** The first bytes of what is left to the core, with the way to the others; all bytes of what is
 * not. @param {Source} source @param {AbortSignal} [signal] */
async function beginOf(source, signal) {
  if (isStream(source)) return (await collected(source, signal)).open();
  const first = async (/** @type {number} */ count) =>
    new Uint8Array(await source.slice(0, count).arrayBuffer());
  const begin = await first(bytesAsked(await first(bytesLooked)));
  if (begin.length === source.size) return new OpenFile(begin);
  return isLeftToCore(begin)
    ? new OpenFile(begin, { blob: source, size: source.size }) : allOf(source);
}

/** @param {unknown} value @param {string} label @param {(source: Source) => Promise<OpenFile>} open
 * @returns {Promise<OpenFile>} */
async function openBytes(value, label, open) {
  if (!isBytes(value)) {
    throw new RemeshError('PARSE_ERROR',
      `${label} must be a Uint8Array, an ArrayBuffer, a Blob or a stream of bytes.`,
      typeof value === 'string'
        ? 'Give its content: await readFile(path) in Node, (await fetch(url)).body in a browser.'
        : undefined);
  }
  try {
    if (value instanceof OpenFile) return value;
    if (value instanceof Uint8Array) return new OpenFile(new Uint8Array(value));
    if (value instanceof ArrayBuffer) return new OpenFile(new Uint8Array(value.slice(0)));
    return await open(value);
  } catch (cause) {
    if (cause instanceof Error && cause.name === 'AbortError') throw cause;
    throw new RemeshError('PARSE_ERROR', `${label} cannot be read: its memory or its file is gone.`,
      'Was its buffer transferred elsewhere?', { cause });
  }
}

/**
 * @param {unknown} bytes
 * @param {FileOptions & OutputOptions & { signal?: AbortSignal }} options
 * @returns {Promise<FileRequest>}
 */
export async function fileRequest(bytes, { name, output, metres, resources = {}, signal }) {
  const givenName = name ?? /** @type {any} */ (bytes)?.name ?? '';
  if (typeof givenName !== 'string' || !(output === undefined || typeof output === 'string')) {
    throw new RemeshError('INVALID_OPTION', 'name and output must be strings.');
  }
  if (typeof resources !== 'object' || resources === null) {
    throw new RemeshError('INVALID_OPTION', 'resources must be an object of bytes by name.');
  }
  const files = [];
  for (const [resource, content] of Object.entries(resources)) {
    const label = `resources['${legible(resource)}']`;
    files.push({ name: resource, bytes: (await openBytes(content, label, allOf)).bytes });
  }
  const { bytes: begin, handle } = await openBytes(bytes, 'The file',
    (source) => beginOf(source, signal));
  return {
    name: givenName || 'The file',
    bytes: begin,
    resources: files,
    output: outputName(givenName, output),
    isInMetres: metres ?? true,
    ...(handle ? { handle } : {}),
  };
}

/**
 * `glb` becomes the input's name with that extension.
 * @param {string} name
 * @param {string} [output]
 */
function outputName(name, output) {
  const inside = withoutGz(name);
  if (output === undefined) return inside;
  if (output.includes('.')) return output;
  return `${inside.replace(/\.[^./\\]*$/, '') || 'remeshed'}.${output}`;
}

/** @param {FileRequest} file @returns {ArrayBuffer[]} */
export function fileBuffers(file) {
  const arrays = [file, ...file.resources].map(({ bytes }) => bytes);
  return [...arrays, ...file.handle?.pieces ?? []].map(({ buffer }) =>
    /** @type {ArrayBuffer} */ (buffer));
}
