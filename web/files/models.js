// SPDX-License-Identifier: MIT
// Finds the models among several files, and the files that a model refers to.
import { inWords, isGltf, isObj, readFormats, withoutGz } from 'remesher/formats';
import { gunzip, isGzip } from 'remesher/gunzip';
import { t } from '../base/i18n.js';
import { baseName, extensionOf, PageError } from './files.js';
import { treeOf } from './glb.js';

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

/** Formats whose files name no others. */
const alone = ['ply', 'stl', 'off'];

/** Whether a file is an OBJ, or a library of one: what the bytes are decides, as in the package.
 * @param {string} name @param {Uint8Array} bytes its first */
function isObjText(name, bytes) {
  const extension = extensionOf(name);
  return extension === 'mtl' || (!isGltf(bytes) && (extension === 'obj' || isObj(bytes)));
}

/** The first bytes of a file; of a .gz, those of what is packed. @param {File} file */
async function beginOf(file) {
  const begin = new Uint8Array(await file.slice(0, looked).arrayBuffer());
  const isPacked = isGzip(begin);
  if (!isPacked) return { begin, isPacked };
  try {
    const reader = file.stream().pipeThrough(new DecompressionStream('gzip')).getReader();
    const { value = begin } = await reader.read();
    await reader.cancel();
    return { begin: value.slice(0, looked), isPacked };
  } catch {
    return { begin, isPacked };  // the package reports the error
  }
}

/** Opens a model. Scans can be too large to be read here: only the package, which reads them block
 * by block in its worker, needs all of a file that names no others, and of an OBJ.
 * @param {PathedFile} item @returns {Promise<Omit<Model, 'resources'>>} */
async function openModel(item) {
  const { path, file } = item;
  const { begin, isPacked } = await beginOf(file);
  const name = isPacked ? withoutGz(path) : path;
  const isAlone = alone.includes(extensionOf(name)) && !isGltf(begin) && !isObj(begin);
  if (isAlone || (!isPacked && isObjText(name, begin))) {
    return { name, bytes: begin, content: file, size: file.size };
  }
  const { bytes } = await read(item);
  return { name, bytes, content: isPacked ? bytes : file, size: bytes.length };
}

/** @param {string} text of an OBJ or of a library */
function namesIn(text) {
  // trim() is separate: matching blanks at both ends would take time quadratic in their number.
  const lines = text.matchAll(/^[ \t]*(mtllib|map_\w+|bump)[ \t](.*)$/gim);
  return Array.from(lines).flatMap(([, keyword, rest]) => {
    const words = rest.trim().split(/\s+/);
    // one name with blanks, or several; an image stands behind options
    return keyword === 'mtllib' ? [rest.trim(), ...words] : words.slice(-1);
  });
}

/** The files named inside a model: buffers and images of a glTF, the libraries of an OBJ.
 * @param {string} name @param {Uint8Array} bytes @returns {string[]} */
export function referencesOf(name, bytes) {
  if (isObjText(name, bytes)) return namesIn(new TextDecoder().decode(bytes));
  if (!isGltf(bytes)) return [];
  try {
    const gltf = treeOf(bytes);
    const uris = [...(gltf.buffers ?? []), ...(gltf.images ?? [])].map((item) => item?.uri);
    return uris.filter((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
  } catch {
    return [];  // the reader reports the error better
  }
}

/** Bytes of an OBJ that are searched at once, so that the page can react. */
const portion = 2 ** 20;

/** @param {Blob} file an OBJ @returns {Promise<string[]>} */
async function namesInLong(file) {
  const decoder = new TextDecoder();
  const names = [];
  let rest = '';
  for (let at = 0; at < file.size; at += portion) {
    const bytes = await file.slice(at, at + portion).arrayBuffer();
    const text = rest + decoder.decode(bytes, { stream: true });
    const end = Math.max(text.lastIndexOf('\n'), text.lastIndexOf('\r')) + 1;
    names.push(...namesIn(text.slice(0, end)));
    rest = text.slice(end, end + portion);
  }
  return [...names, ...namesIn(rest)];
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
 * @param {Omit<Model, 'resources'>} model @param {PathedFile[]} others
 * @returns {Promise<NamedBytes[]>} */
async function resourcesOf(model, others) {
  /** @type {Map<string, NamedBytes>} */
  const found = new Map();
  const add = async (/** @type {string[]} */ references) => {
    for (const reference of references) {
      const fits = others.map((other) => ({ other, fit: likeness(other.path, reference) }));
      const best = fits.sort((a, b) => b.fit - a.fit)[0];
      if (!best?.fit || found.has(reference)) continue;
      const { name, bytes } = await read(best.other);
      found.set(reference, { name: reference, bytes });
      await add(referencesOf(name, bytes));
    }
  };
  const { name, bytes, content } = model;
  const isLong = content instanceof Blob && isObjText(name, bytes);
  if (others.length) await add(isLong ? await namesInLong(content) : referencesOf(name, bytes));
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
