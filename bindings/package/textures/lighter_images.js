// SPDX-License-Identifier: MIT
// Makes the images that a .glb keeps lighter: as WebP, where that takes clearly fewer bytes.

import { openContainer, packGlb } from '../codecs/gltf_container.js';
import { ImageWorkers } from './image_workers.js';
import { imageHeader } from './image_header.js';

/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */

const extension = 'EXT_texture_webp';
/** Images that lose less than a tenth, or a kilobyte, stay as they are: each encoding loses some of
 * the look, and fewer programs read WebP. */
const [mostKept, leastSaved] = [0.9, 1000];
const alignment = 8;

/** The numbers of the images that textures show by their own source alone, in a view of their own.
 * @param {any} tree @returns {number[]} */
function plainImages({ textures = [], images = [], bufferViews = [] }) {
  const others = new Set(textures.flatMap((/** @type {any} */ { source, extensions = {} }) => {
    const sources = Object.values(extensions).map((/** @type {any} */ own) => own?.source)
      .filter((number) => number !== undefined);
    return sources.length > 0 ? [...sources, source] : [];
  }));
  const shown = new Set(textures.map((/** @type {any} */ { source }) => source));
  return [...images.keys()].filter((number) => shown.has(number) && !others.has(number)
    && bufferViews[images[number]?.bufferView]?.buffer === 0);
}

/** The binary data with other bytes in some views, and its tree changed accordingly.
 * @param {any} tree @param {Uint8Array} chunk @param {Map<number, Uint8Array>} replaced by view */
function withViews(tree, chunk, replaced) {
  const parts = tree.bufferViews.map(
    (/** @type {any} */ { byteOffset = 0, byteLength }, /** @type {number} */ view) =>
      replaced.get(view) ?? chunk.subarray(byteOffset, byteOffset + byteLength));
  let end = 0;
  const starts = parts.map((/** @type {Uint8Array} */ { length }) => {
    const start = end;
    end = Math.ceil((start + length) / alignment) * alignment;
    return start;
  });
  const whole = new Uint8Array(end);
  parts.forEach((/** @type {Uint8Array} */ bytes, /** @type {number} */ view) => {
    whole.set(bytes, starts[view]);
    Object.assign(tree.bufferViews[view], { byteOffset: starts[view], byteLength: bytes.length });
  });
  tree.buffers[0].byteLength = whole.length;
  return packGlb(tree, whole);
}

/** @param {any} tree @param {number[]} numbers of images that are WebP now */
function nameWebp(tree, numbers) {
  for (const number of numbers) tree.images[number].mimeType = 'image/webp';
  for (const texture of tree.textures) {
    if (!numbers.includes(texture.source)) continue;
    texture.extensions = { ...texture.extensions, [extension]: { source: texture.source } };
    delete texture.source;
  }
  for (const list of ['extensionsUsed', 'extensionsRequired']) {
    tree[list] = [...new Set([...tree[list] ?? [], extension])];
  }
}

/** An image as WebP; as it is where it cannot be decoded, such as without a package for it, or
 * hardly becomes smaller. @param {ImageWorkers} workers @param {Uint8Array} bytes */
async function lighter(workers, bytes) {
  if (!['image/png', 'image/jpeg'].includes(imageHeader(bytes)?.type ?? '')) return bytes;
  const run = (/** @type {import('../base/messages.js').ImageJob} */ job) =>
    workers.run([job], () => {});
  try {
    const [decoded] = await run({ work: 'decode', image: { name: '', bytes } });
    const [made] = await run({ work: 'encode',
      image: { name: '', type: 'image/webp', ...decoded } });
    const most = Math.min(mostKept * bytes.length, bytes.length - leastSaved);
    return made.length <= most ? made : bytes;
  } catch {
    return bytes;
  }
}

/** @param {NamedBytes} file @param {ImageWorkers} workers @returns {Promise<NamedBytes>} */
async function lighterFile(file, workers) {
  const { text, chunk } = /\.glb$/i.test(file.name) ? openContainer(file.bytes) : { text: '{}' };
  const tree = JSON.parse(text);
  if (!chunk || tree.buffers?.length !== 1 || tree.buffers[0].uri !== undefined) return file;
  /** @type {Map<number, Uint8Array>} */
  const replaced = new Map();
  const numbers = [];
  for (const number of plainImages(tree)) {
    const view = tree.images[number].bufferView;
    const { byteOffset = 0, byteLength } = tree.bufferViews[view];
    const given = chunk.subarray(byteOffset, byteOffset + byteLength);
    const made = replaced.get(view) ?? await lighter(workers, given);
    if (made === given) continue;
    replaced.set(view, made);
    numbers.push(number);
  }
  if (numbers.length === 0) return file;
  nameWebp(tree, numbers);
  return { name: file.name, bytes: withViews(tree, chunk, replaced) };
}

/**
 * @param {NamedBytes[]} files of a result
 * @param {import('./image_codecs.js').CodecSource} source
 * @returns {Promise<NamedBytes[]>}
 */
export async function withLighterImages(files, source) {
  const workers = new ImageWorkers(source);
  try {
    const result = [];
    for (const file of files) result.push(await lighterFile(file, workers));
    return result;
  } finally {
    workers.end();
  }
}
