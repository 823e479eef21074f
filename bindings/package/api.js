// SPDX-License-Identifier: MIT
// The public functions, for whichever platform they are made: checks what the caller gave, copies
// it (the caller's arrays stay the caller's), and hands a job to the client.

import { Client } from './client.js';
import { RemeshError } from './errors.js';
import { checkOptions } from './options.js';
import { compileBinary } from './wasm_source.js';

/** @typedef {import('./messages.js').Mesh} Mesh */
/** @typedef {import('./messages.js').MeshAttribute} MeshAttribute */
/** @typedef {import('./messages.js').NamedBytes} NamedBytes */
/** @typedef {import('./messages.js').Inspection} Inspection */
/** @typedef {import('./messages.js').RemeshReport} RemeshReport */
/** @typedef {import('./options.js').RemeshOptions} RemeshOptions */
/** @typedef {import('./client.js').RunOptions} RunOptions */

/** @typedef {Uint8Array | ArrayBuffer | Blob} Bytes */

/**
 * @typedef {object} InitOptions
 * @property {string | URL} [wasmUrl] where remesher.wasm is, if not beside the script
 * @property {BufferSource} [wasmBinary] its bytes, if they are there already
 */

/**
 * @typedef {object} FileOptions
 * @property {string} [name] the file's name; its extension tells the format
 * @property {Record<string, Bytes>} [resources] files it refers to, by the names it uses for them
 */

/**
 * @typedef {object} OutputOptions
 * @property {string} [output] a name, or a bare format; the input's if not given
 */

/** @typedef {{ mesh: Mesh, report: RemeshReport }} RemeshResult */

/**
 * @typedef {object} RemeshFileResult
 * @property {string} name
 * @property {Uint8Array} bytes
 * @property {NamedBytes[]} files this file first, then those it refers to (a .bin, a .mtl)
 * @property {RemeshReport} report
 */

/** @typedef {Omit<RemeshFileResult, 'report'>} ConvertFileResult */

const runNames = /** @type {const} */ (['signal', 'onProgress', 'worker']);
const fileNames = /** @type {const} */ (['name', 'resources']);

/** @param {string} message @param {string} [hint] @returns {never} */
function refuseMesh(message, hint) {
  throw new RemeshError('INVALID_MESH', message, hint);
}

/** @param {unknown} value */
function isArrayOfNumbers(value) {
  return ArrayBuffer.isView(value) && !(value instanceof DataView)
    && !(value instanceof BigInt64Array) && !(value instanceof BigUint64Array);
}

/** @param {any} mesh @returns {Mesh} the same in arrays of our own */
function copyMesh(mesh) {
  const { positions, indices, attributes } = mesh;
  if (!(positions instanceof Float32Array || positions instanceof Float64Array)) {
    refuseMesh('mesh.positions must be a Float32Array or a Float64Array.');
  }
  if (!(indices instanceof Uint32Array || indices instanceof Uint16Array)) {
    refuseMesh('mesh.indices must be a Uint32Array or a Uint16Array.',
      'For a mesh without indices, give 0, 1, 2, …: equal positions are welded.');
  }
  if (positions.length % 3 !== 0) {
    refuseMesh(`mesh.positions has ${positions.length} numbers, which is not a multiple of 3.`);
  }
  if (indices.length % 3 !== 0) {
    refuseMesh(`mesh.indices has ${indices.length} numbers, which is not a multiple of 3.`);
  }
  return {
    positions: positions.slice(),
    indices: indices.slice(),
    attributes: copyAttributes(attributes ?? {}, positions.length / 3),
  };
}

/** @param {Record<string, MeshAttribute>} attributes @param {number} vertexCount */
function copyAttributes(attributes, vertexCount) {
  /** @type {Record<string, MeshAttribute>} */
  const result = {};
  for (const [semantic, attribute] of Object.entries(attributes)) {
    const { array, itemSize } = attribute ?? {};
    if (!isArrayOfNumbers(array) || !Number.isInteger(itemSize) || itemSize < 1) {
      refuseMesh(`mesh.attributes.${semantic} must be { array, itemSize }, a typed array and a `
        + 'whole number.');
    }
    if (array.length !== vertexCount * itemSize) {
      refuseMesh(`mesh.attributes.${semantic} has ${array.length} numbers, but ${vertexCount} `
        + `vertices × ${itemSize} are ${vertexCount * itemSize}.`);
    }
    result[semantic] = { array: new (/** @type {any} */ (array.constructor))(array), itemSize };
  }
  return result;
}

/** @param {Mesh} mesh @returns {ArrayBuffer[]} */
function buffersOf(mesh) {
  const arrays = [mesh.positions, mesh.indices,
    ...Object.values(mesh.attributes ?? {}).map(({ array }) => array)];
  return arrays.map((array) => /** @type {ArrayBuffer} */ (array.buffer));
}

/** @param {unknown} value @returns {value is Bytes} */
function isBytes(value) {
  return value instanceof Uint8Array || value instanceof ArrayBuffer
    || (typeof Blob !== 'undefined' && value instanceof Blob);
}

/** @param {unknown} value @param {string} label @returns {Promise<Uint8Array<ArrayBuffer>>} */
async function copyBytes(value, label) {
  if (!isBytes(value)) {
    throw new RemeshError('PARSE_ERROR',
      `${label} must be a Uint8Array, an ArrayBuffer or a Blob.`);
  }
  if (value instanceof Uint8Array) return new Uint8Array(value);
  return new Uint8Array(value instanceof ArrayBuffer ? value.slice(0) : await value.arrayBuffer());
}

/**
 * @param {unknown} bytes
 * @param {FileOptions & OutputOptions} options
 * @returns {Promise<import('./messages.js').FileRequest>}
 */
async function fileRequest(bytes, { name, output, resources = {} }) {
  const givenName = name ?? /** @type {any} */ (bytes)?.name ?? '';
  if (typeof givenName !== 'string' || !(output === undefined || typeof output === 'string')) {
    throw new RemeshError('INVALID_OPTION', 'name and output must be strings.');
  }
  const files = [];
  for (const [resource, content] of Object.entries(resources)) {
    files.push({ name: resource, bytes: await copyBytes(content, `resources['${resource}']`) });
  }
  return {
    name: givenName,
    bytes: await copyBytes(bytes, 'The file'),
    resources: files,
    output: outputName(givenName, output),
  };
}

/**
 * `glb` becomes the input's name with that extension.
 * @param {string} name
 * @param {string} [output]
 */
function outputName(name, output) {
  if (output === undefined) return name;
  if (output.includes('.')) return output;
  return `${name.replace(/\.[^./\\]*$/, '') || 'remeshed'}.${output}`;
}

/** @param {import('./messages.js').FileRequest} file @returns {ArrayBuffer[]} */
function fileBuffers(file) {
  return [file, ...file.resources].map(({ bytes }) => /** @type {ArrayBuffer} */ (bytes.buffer));
}

/** @param {import('./client.js').Platform} platform */
export function createApi(platform) {
  const client = new Client(platform);

  /**
   * Loads the WebAssembly and starts the worker ahead of time. Optional, and cheap to repeat: the
   * first call decides where the WebAssembly comes from.
   * @param {InitOptions} [options]
   * @returns {Promise<void>}
   */
  async function init({ wasmUrl, wasmBinary } = {}) {
    if (wasmBinary) await client.load(() => compileBinary(wasmBinary, 'wasmBinary'));
    else if (wasmUrl) await client.load(() => platform.compileUrl(wasmUrl));
    await client.warmUp();
  }

  /**
   * Remeshes a mesh. Its arrays are copied, and stay the caller's.
   * @param {Mesh} mesh
   * @param {RemeshOptions & RunOptions} [options]
   * @returns {Promise<RemeshResult>}
   */
  async function remesh(mesh, options = {}) {
    const checked = checkOptions(options, { others: runNames });
    const copy = copyMesh(mesh ?? {});
    return client.run({ kind: 'remesh', mesh: copy, options: checked }, buffersOf(copy), options);
  }

  /**
   * Remeshes a file, given and returned as bytes.
   * @param {Bytes} bytes
   * @param {RemeshOptions & FileOptions & OutputOptions & RunOptions} options
   * @returns {Promise<RemeshFileResult>}
   */
  async function remeshFile(bytes, options = {}) {
    const checked = checkOptions(options, { others: [...runNames, ...fileNames, 'output'] });
    const file = await fileRequest(bytes, options);
    const { files, report } = await client.run(
      { kind: 'remeshFile', file, options: checked }, fileBuffers(file), options);
    return { ...files[0], files, report };
  }

  /**
   * Writes a file in another format; its triangles stay as they are.
   * @param {Bytes} bytes
   * @param {FileOptions & OutputOptions & RunOptions} options
   * @returns {Promise<ConvertFileResult>}
   */
  async function convertFile(bytes, options = {}) {
    refuseOthers(options, [...runNames, ...fileNames, 'output']);
    const file = await fileRequest(bytes, options);
    const { files } = await client.run({ kind: 'convertFile', file }, fileBuffers(file), options);
    return { ...files[0], files };
  }

  /**
   * Reports on a file or a mesh; changes nothing.
   * @param {Bytes | Mesh} bytesOrMesh
   * @param {FileOptions & RunOptions} [options]
   * @returns {Promise<Inspection>}
   */
  async function inspect(bytesOrMesh, options = {}) {
    refuseOthers(options, [...runNames, ...fileNames]);
    if (isBytes(bytesOrMesh)) {
      const file = await fileRequest(bytesOrMesh, options);
      return client.run({ kind: 'inspectFile', file }, fileBuffers(file), options);
    }
    const copy = copyMesh(bytesOrMesh ?? {});
    return client.run({ kind: 'inspect', mesh: copy }, buffersOf(copy), options);
  }

  return { init, remesh, remeshFile, convertFile, inspect };
}

/** @param {object} options @param {readonly string[]} known */
function refuseOthers(options, known) {
  const unknown = Object.keys(options).find((name) => !known.includes(name));
  if (unknown) {
    throw new RemeshError('UNKNOWN_OPTION', `There is no option ${unknown} here.`,
      `There are ${known.join(', ')}.`);
  }
}
