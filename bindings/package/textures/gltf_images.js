// SPDX-License-Identifier: MIT
// Takes the images of glTF files out to be decoded, and puts painted images into results that refer
// to them.

import { percentDecoded } from '../codecs/buffer_views.js';
import { openContainer, packGlb } from '../codecs/gltf_container.js';
import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { imageHeader } from './image_header.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */
/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */
/** @typedef {import('../base/messages.js').Texture} Texture */

const placeholder = /^painting:(\d+)$/;
const extensions = /** @type {Record<string, string>} */ (
  { 'image/png': 'png', 'image/jpeg': 'jpg', 'image/webp': 'webp' });

/** Undefined if it is broken. @param {string} uri */
function dataOf(uri) {
  const [head, body = ''] = uri.split(/,(.*)/s);
  const letters = body.replace(/%([\da-f]{2})/gi,
    (_, code) => String.fromCharCode(parseInt(code, 16)));
  try {
    return Uint8Array.from(head.endsWith(';base64') ? atob(letters) : letters,
      (letter) => letter.charCodeAt(0));
  } catch {
    return undefined;
  }
}

/** @param {any} image @param {any} tree @param {Uint8Array} chunk @param {FileRequest} file */
function bytesOf(image, tree, chunk, file) {
  const buffer = (/** @type {any} */ { uri }) => {
    if (typeof uri !== 'string') return chunk;
    return uri.startsWith('data:') ? dataOf(uri) : resource(uri, file);
  };
  if (typeof image.uri === 'string') return buffer(image);
  const view = tree.bufferViews?.[image.bufferView];
  const whole = view && tree.buffers?.[view.buffer] && buffer(tree.buffers[view.buffer]);
  const begin = view?.byteOffset ?? 0;
  return whole?.subarray(begin, begin + view.byteLength);
}

/** The resources of a file by name: it may name thousands.
 * @type {WeakMap<object, Map<string, Uint8Array>>} */
const byName = new WeakMap();

/** @param {string} uri @param {FileRequest} file */
function resource(uri, { resources }) {
  const named = byName.get(resources)
    ?? new Map([...resources].reverse().map(({ name, bytes }) => [name, bytes]));
  byName.set(resources, named);
  return named.get(uri) ?? named.get(percentDecoded(uri));
}

/**
 * The image of a texture, as the core chooses it: WebP, else what every program reads; else
 * whatever an extension has, which may be refused by its name.
 * @param {any} texture
 */
function sourceOf(texture) {
  const own = Object(texture?.extensions);
  const others = Object.values(own).map((extension) => extension?.source);
  return own.EXT_texture_webp?.source ?? texture?.source
    ?? others.find((number) => number !== undefined);
}

/** The numbers of the images that the known maps of materials show. @param {any} tree */
function paintedFrom(tree) {
  const materials = Array.isArray(tree.materials) ? tree.materials.map(Object) : [];
  const infos = materials.flatMap((/** @type {any} */ material) => [
    material.pbrMetallicRoughness?.baseColorTexture,
    material.pbrMetallicRoughness?.metallicRoughnessTexture,
    material.normalTexture, material.occlusionTexture, material.emissiveTexture]);
  const images = infos.map((/** @type {any} */ info) =>
    sourceOf(tree.textures?.[info?.index]));
  return [...new Set(images)].filter((number) =>
    Number.isInteger(number) && tree.images?.[number] !== undefined);
}

/** The tree of a file, and the binary data in it; an empty one if it cannot be read, of which the
 * core says what is wrong. @param {{ bytes: Uint8Array }} file */
function opened({ bytes }) {
  const { text, chunk = new Uint8Array() } = openContainer(bytes);
  try {
    return { tree: Object(JSON.parse(text)), chunk };
  } catch {
    return { tree: {}, chunk };
  }
}

/** The images that materials show as maps of normals. @param {FileRequest} file */
export function normalsOf(file) {
  const { tree, chunk } = opened(file);
  const materials = Array.isArray(tree.materials) ? tree.materials.map(Object) : [];
  const numbers = new Set(materials.map((/** @type {any} */ { normalTexture }) =>
    sourceOf(tree.textures?.[normalTexture?.index])));
  return [...numbers].filter((number) => tree.images?.[number] !== undefined)
    .map((number) => bytesOf(Object(tree.images[number]), tree, chunk, file) ?? new Uint8Array());
}

/**
 * All images of a glTF file, with their sizes; those that were not given are left out.
 * @param {Pick<FileRequest, 'name' | 'bytes' | 'resources'>} file
 * @returns {Texture[]}
 */
export function texturesOf(file) {
  const { tree, chunk } = opened(file);
  const images = Array.isArray(tree.images) ? tree.images.map(Object) : [];
  return images.flatMap((/** @type {any} */ image, /** @type {number} */ i) => {
    const bytes = bytesOf(image, tree, chunk, /** @type {FileRequest} */ (file));
    if (!bytes?.length) return [];
    const { type, width, height } = imageHeader(bytes) ?? { type: String(image.mimeType ?? '') };
    const named = [image.name, image.uri].find((name) =>
      typeof name === 'string' && !name.startsWith('data:'));
    const size = width === undefined ? {} : { width, height };
    return [{ name: named ?? String(i), type, ...size, bytes: bytes.length }];
  });
}

/**
 * The images of a file that new textures are painted from, called by their numbers.
 * @param {FileRequest} file
 * @returns {{ name: string, label: string, bytes: Uint8Array }[]}
 */
export function imagesOf(file) {
  const { tree, chunk } = opened(file);
  return paintedFrom(tree).map((number) => {
    const image = Object(tree.images[number]);
    const called = [image.name, image.uri].find((name) =>
      typeof name === 'string' && !name.startsWith('data:'));
    const label = `${legible(file.name)}: Image ${number}${called ? ` (${legible(called)})` : ''}`;
    const bytes = bytesOf(image, tree, chunk, file);
    if (!bytes?.length) {
      throw new RemeshError('MISSING_RESOURCE', `${label} was not given.`,
        'Give the image with the file, or keep the textures.');
    }
    return { name: String(number), label, bytes };
  });
}

/** The numbers of the painted images that the tree shows. @param {any} tree */
const paintingsIn = (tree) => (tree.images ?? []).flatMap((/** @type {any} */ { uri = '' }) =>
  (placeholder.test(uri) ? [Number(placeholder.exec(uri)?.[1])] : []));

/** @param {any} tree @param {Uint8Array} chunk @param {EncodedImage[]} encoded */
function embed(tree, chunk, encoded) {
  const alignment = 8;
  const aligned = (/** @type {number} */ length) => Math.ceil(length / alignment) * alignment;
  const shown = [...new Set(paintingsIn(tree))];
  let end = aligned(chunk.length);
  const whole = new Uint8Array(
    shown.reduce((sum, number) => sum + aligned(encoded[number].bytes.length), end));
  whole.set(chunk);
  const starts = new Map(shown.map((number) => {
    const start = end;
    whole.set(encoded[number].bytes, start);
    end += aligned(encoded[number].bytes.length);
    return [number, start];
  }));
  for (const image of tree.images ?? []) {
    const [number] = paintingsIn({ images: [image] });
    if (number === undefined) continue;
    delete image.uri;
    image.mimeType = encoded[number].type;
    tree.bufferViews.push({ buffer: 0, byteOffset: starts.get(number),
      byteLength: encoded[number].bytes.length });
    image.bufferView = tree.bufferViews.length - 1;
  }
  tree.buffers[0].byteLength = whole.length;
  return packGlb(tree, whole);
}

/** @param {NamedBytes[]} files @param {string} base @param {string} ending */
function freeName(files, base, ending) {
  const isTaken = (/** @type {string} */ name) => files.some((file) => file.name === name);
  let name = `${base}.${ending}`;
  for (let i = 2; isTaken(name); i += 1) name = `${base}_${i}.${ending}`;
  return name;
}

/** @typedef {NamedBytes & { type: string }} EncodedImage */

/** Names for images beside .gltf files, which all these files share.
 * @param {NamedBytes[]} files @param {EncodedImage[]} encoded */
function filesOf(files, encoded) {
  const base = files[0].name.replace(/\.[^.]*$/, '');
  const all = [...files];
  return encoded.map(({ name, bytes, type }) => {
    const file = { name: freeName(all, `${base}_${name}`, extensions[type]), bytes };
    all.push(file);
    return file;
  });
}

/** @param {any} tree @param {NamedBytes[]} images */
function namedIn(tree, images) {
  for (const image of tree.images ?? []) {
    const [number] = paintingsIn({ images: [image] });
    if (number === undefined) continue;
    image.uri = encodeURIComponent(images[number].name);
    delete image.mimeType;
  }
  return new TextEncoder().encode(`${JSON.stringify(tree, undefined, 2)}\n`);
}

/**
 * The files of a result with its painted images, within each .glb or beside each .gltf: levels of
 * detail may be files of their own.
 * @param {NamedBytes[]} files
 * @param {EncodedImage[]} encoded
 * @returns {NamedBytes[]}
 */
export function withImages(files, encoded) {
  const beside = filesOf(files, encoded);
  /** @type {Set<number>} */
  const named = new Set();
  const result = files.map(({ name, bytes }) => {
    if (!/\.gl(b|tf)$/i.test(name)) return { name, bytes };
    const { text, chunk } = openContainer(bytes);
    const tree = JSON.parse(text);
    if (paintingsIn(tree).length === 0) return { name, bytes }; // not even padded anew
    if (chunk) return { name, bytes: embed(tree, chunk, encoded) };
    for (const number of paintingsIn(tree)) named.add(number);
    return { name, bytes: namedIn(tree, beside) };
  });
  return [...result, ...beside.filter((_, number) => named.has(number))];
}
