// SPDX-License-Identifier: MIT
// Finds the models among several files, and the files that a model refers to.
import { inWords, isGltf, isObj, readFormats, withoutGz } from 'remesher/formats';
import { gunzip, isGzip } from 'remesher/gunzip';
import { t } from '../base/i18n.js';
import { baseName, extensionOf, PageError } from './files.js';
import { openGlb } from './glb.js';

/** @typedef {import('./files.js').NamedBytes} NamedBytes */
/** @typedef {import('./files.js').PathedFile} PathedFile */
/** `content`: what the package reads; `bytes`: the first of it, all if other files are named in it;
 * `size`: of the file, in bytes.
 * @typedef {NamedBytes & { content: Blob | Uint8Array, size: number, resources: NamedBytes[] }}
 *   Model */

/** @type {readonly string[]} */
const known = readFormats;

/** Reads a file, and decompresses a .gz.
 * @param {PathedFile} item @returns {Promise<NamedBytes>} */
async function read({ path, file }) {
  return gunzip({ name: path, bytes: new Uint8Array(await file.arrayBuffer()) });
}

/** Bytes that tell the kind of a file. */
const looked = 65536;

/** Formats whose files name no others: only the package reads them, block by block. */
const alone = ['ply', 'stl', 'off'];

/** Opens a model; scans can be too large to be read here.
 * @param {PathedFile} item @returns {Promise<Omit<Model, 'resources'>>} */
async function openModel(item) {
  const { path, file } = item;
  const begin = new Uint8Array(await file.slice(0, looked).arrayBuffer());
  if (alone.includes(extensionOf(path)) && !isGltf(begin) && !isObj(begin) && !isGzip(begin)) {
    return { name: path, bytes: begin, content: file, size: file.size };
  }
  const { name, bytes } = await read(item);
  return { name, bytes, content: bytes, size: bytes.length };
}

/** The files named inside a model: buffers and images of a glTF, the libraries of an OBJ. What the
 * bytes are decides, as in the package.
 * @param {string} extension @param {Uint8Array} bytes @returns {string[]} */
export function referencesOf(extension, bytes) {
  if (extension === 'mtl' || (!isGltf(bytes) && (extension === 'obj' || isObj(bytes)))) {
    const text = new TextDecoder().decode(bytes);
    // trim() is separate: matching blanks at both ends would take time quadratic in their number.
    const lines = text.matchAll(/^[ \t]*(?:mtllib|map_\w+|bump)[ \t](.*)$/gim);
    return Array.from(lines, ([, words]) => words.trim().split(/\s+/).pop() ?? '');
  }
  if (!isGltf(bytes)) return [];
  try {
    const isBinary = bytes[0] === 'g'.charCodeAt(0);
    const gltf = isBinary ? openGlb(bytes).tree : JSON.parse(new TextDecoder().decode(bytes));
    const uris = [...(gltf.buffers ?? []), ...(gltf.images ?? [])].map((item) => item?.uri);
    return uris.filter((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
  } catch {
    return [];  // the reader reports the error better
  }
}

/** The file name that a reference encodes. @param {string} reference */
function plainName(reference) {
  try {
    return decodeURIComponent(reference);
  } catch {
    return reference;  // a lone % is an ordinary character
  }
}

/** How well a file fits a reference in the model: 2 for the whole path, 1 for the name only.
 * @param {string} path @param {string} reference */
function likeness(path, reference) {
  const wanted = plainName(reference).replaceAll('\\', '/').toLowerCase();
  const given = path.toLowerCase();
  if (given === wanted || given.endsWith(`/${wanted}`)) return 2;
  return baseName(given) === baseName(wanted) ? 1 : 0;
}

/** Reads only the files that the model refers to, and gives each the name that the model uses.
 * @param {NamedBytes} model @param {PathedFile[]} others @returns {Promise<NamedBytes[]>} */
async function resourcesOf(model, others) {
  /** @type {Map<string, NamedBytes>} */
  const found = new Map();
  const visit = async (/** @type {NamedBytes} */ file) => {
    for (const reference of referencesOf(extensionOf(file.name), file.bytes)) {
      const fits = others.map((other) => ({ other, fit: likeness(other.path, reference) }));
      const best = fits.sort((a, b) => b.fit - a.fit)[0];
      if (!best?.fit || found.has(reference)) continue;
      const { name, bytes } = await read(best.other);
      found.set(reference, { name: reference, bytes });
      await visit({ name, bytes });
    }
  };
  await visit(model);
  return [...found.values()];
}

/** The format's place in the list, -1 if the file is no model. @param {PathedFile} item */
const rank = ({ path }) => known.indexOf(extensionOf(withoutGz(path)));

/** Formats of other programs, by what opens them. */
const foreign = { cad: ['step', 'stp', 'iges', 'igs', 'x_t', 'x_b', 'sldprt', 'ipt', '3dm', 'f3d'],
  scene: ['fbx', 'blend', 'dae', '3ds', 'max', 'ma', 'mb', 'c4d', 'usd', 'usda', 'usdc', 'usdz',
    'abc', 'x3d', 'wrl', 'skp'] };

/** Says how to convert what other programs have made. @param {PathedFile[]} items */
function refuseForeign(items) {
  for (const [kind, extensions] of Object.entries(foreign)) {
    const found = items.find(({ path }) => extensions.includes(extensionOf(path)));
    if (!found) continue;
    throw new PageError(t('error.foreign', { name: baseName(found.path) }),
      t(/** @type {'error.foreign.cad'} */ (`error.foreign.${kind}`)));
  }
}

/** The models among some files, richer formats first. Of a single file that has no known name the
 * reader says what it is. Throws if there is none.
 * @param {PathedFile[]} items @returns {PathedFile[]} */
export function modelsAmong(items) {
  const models = items.filter((item) => rank(item) >= 0).sort((a, b) => rank(a) - rank(b));
  if (models.length) return models;
  refuseForeign(items);
  if (items.length === 1) return items;
  const names = items.map(({ path }) => baseName(path)).slice(0, 3).join(', ');
  throw new PageError(names ? t('error.noModel', { names }) : t('error.empty'),
    t('error.noModel.hint', { formats: inWords(known.map((format) => `.${format}`)) }));
}

/** A model with the files that it refers to.
 * @param {PathedFile} chosen @param {PathedFile[]} items @returns {Promise<Model>} */
export async function modelFrom(chosen, items) {
  const model = await openModel(chosen);
  const others = items.filter((item) => item !== chosen);
  return { ...model, name: baseName(model.name), resources: await resourcesOf(model, others) };
}
