// SPDX-License-Identifier: MIT
// Compresses glTF that is written, by EXT_meshopt_compression or KHR_draco_mesh_compression. The
// encoders are loaded when the first file asks for them.

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { joinBuffers, loadBuffers, slice } from './buffer_views.js';
import { compressByDraco } from './compress_draco.js';
import { compressByMeshopt, setFallback } from './compress_meshopt.js';
import { dropUnusedViews, GltfData } from './gltf_data.js';
import { openContainer, packGlb } from './gltf_container.js';

/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */
/** @typedef {import('../base/messages.js').Compression} Compression */

const namesGltf = (/** @type {string} */ name) => /\.gl(b|tf)$/i.test(name);

/** Refuses to compress other formats than glTF. @param {string} output its name */
export function requireCompressible(output) {
  if (namesGltf(output)) return;
  throw new RemeshError('INVALID_OPTION',
    `compress works for glTF only, and ${legible(output)} is another format.`,
    'Name the output .glb or .gltf.');
}

/** @param {Uint8Array} bytes */
function inDataUri(bytes) {
  let text = '';
  for (let at = 0; at < bytes.length; at += 8192) {
    text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  }
  return `data:application/octet-stream;base64,${btoa(text)}`;
}

/**
 * A .gltf with the data that it names, which is a file beside it unless it was embedded.
 * @param {string} name @param {any} tree @param {{ data: Uint8Array, uri?: string }} buffer
 * @returns {NamedBytes[]}
 */
function packText(name, tree, { data, uri = '' }) {
  const isEmbedded = uri.startsWith('data:');
  tree.buffers[0].uri = isEmbedded ? inDataUri(data) : uri;
  const text = { name, bytes: new TextEncoder().encode(`${JSON.stringify(tree, undefined, 2)}\n`) };
  return isEmbedded ? [text] : [text, { name: decodeURIComponent(uri), bytes: data }];
}

/**
 * @param {NamedBytes} file @param {NamedBytes[]} files all that were written
 * @param {'meshopt' | 'draco'} method
 * @returns {Promise<{ files: NamedBytes[], error: number }>}
 */
async function compressedFile({ name, bytes }, files, method) {
  const { text, chunk } = openContainer(bytes);
  const tree = JSON.parse(text);
  if (!tree.accessors || !tree.bufferViews) return { files: [{ name, bytes }], error: 0 };
  const uri = tree.buffers[0]?.uri;
  const buffers = loadBuffers(tree, chunk, { name, resources: files });
  const data = new GltfData(tree,
    tree.bufferViews.map((/** @type {any} */ view) => slice(buffers[view.buffer], view)));
  const error = await (method === 'meshopt' ? compressByMeshopt : compressByDraco)(data);
  dropUnusedViews(data);
  const joined = joinBuffers(tree, data.contents);
  if (method === 'meshopt') setFallback(tree);
  return { files: chunk ? [{ name, bytes: packGlb(tree, joined) }]
    : packText(name, tree, { data: joined, uri }), error };
}

const lengthOf = (/** @type {NamedBytes[]} */ files) =>
  files.reduce((sum, { bytes }) => sum + bytes.length, 0);

/**
 * The files with their glTF compressed, and the effect of that.
 * @param {NamedBytes[]} files
 * @param {'meshopt' | 'draco'} method
 * @returns {Promise<{ files: NamedBytes[], compression: Compression }>}
 */
export async function compressed(files, method) {
  /** @type {Map<string, NamedBytes>} */
  const made = new Map(files.map((file) => [file.name, file]));
  let error = 0;
  for (const file of files.filter(({ name }) => namesGltf(name))) {
    const result = await compressedFile(file, files, method);
    for (const one of result.files) made.set(one.name, one);
    error = Math.max(error, result.error);
  }
  const all = [...made.values()];
  return { files: all,
    compression: { method, before: lengthOf(files), after: lengthOf(all), error } };
}
