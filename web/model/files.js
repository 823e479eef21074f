// SPDX-License-Identifier: MIT
// From whatever was dropped or picked (files, folders) to one model with the files it refers to.

import { formats, inWords, withoutGz } from 'remesher/formats';
import { gunzip } from 'remesher/gunzip';

/** @typedef {{ name: string, bytes: Uint8Array }} NamedBytes */
/** others: the names of models that came along and were left aside.
 * @typedef {NamedBytes & { resources: NamedBytes[], others: string[] }} Model */
/** @typedef {{ path: string, file: File }} PathedFile */

/** A fault that the visitor can mend: what is wrong, and what to do. */
export class PageError extends Error {
  /** @param {string} message @param {string} [hint] */
  constructor(message, hint) {
    super(message);
    this.name = 'PageError';
    this.hint = hint;
  }
}

/** @param {string} name */
export const extensionOf = (name) => name.slice(name.lastIndexOf('.') + 1).toLowerCase();

/** @param {string} path */
const baseName = (path) => path.slice(path.lastIndexOf('/') + 1);

/** Out of its .gz, if it is in one.
 * @param {PathedFile} item @returns {Promise<NamedBytes>} */
async function read({ path, file }) {
  return gunzip({ name: path, bytes: new Uint8Array(await file.arrayBuffer()) });
}

/** The files named inside a model: buffers and images of a glTF, the libraries of an OBJ.
 * @param {string} extension @param {Uint8Array} bytes @returns {string[]} */
function referencesOf(extension, bytes) {
  if (extension === 'obj' || extension === 'mtl') {
    const text = new TextDecoder().decode(bytes);
    // What follows is trimmed apart: blanks on both sides would cost their number squared.
    const lines = text.matchAll(/^[ \t]*(?:mtllib|map_\w+|bump)[ \t](.*)$/gim);
    return Array.from(lines, ([, words]) => words.trim().split(/\s+/).pop() ?? '');
  }
  if (extension !== 'gltf') return [];
  try {
    const gltf = JSON.parse(new TextDecoder().decode(bytes));
    const uris = [...(gltf.buffers ?? []), ...(gltf.images ?? [])].map((item) => item?.uri);
    return uris.filter((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
  } catch {
    return [];  // the reader says better what is wrong with it
  }
}

/** How well a dropped file fits a name inside the model: its whole path, or only its last part.
 * @param {string} path @param {string} reference */
function likeness(path, reference) {
  const wanted = decodeURIComponent(reference).replaceAll('\\', '/').toLowerCase();
  const given = path.toLowerCase();
  if (given === wanted || given.endsWith(`/${wanted}`)) return 2;
  return baseName(given) === baseName(wanted) ? 1 : 0;
}

/** Gives each dropped file the name that the model uses for it.
 * @param {NamedBytes} model @param {NamedBytes[]} others @returns {NamedBytes[]} */
function resourcesOf(model, others) {
  /** @type {Map<string, NamedBytes>} */
  const found = new Map();
  const visit = (/** @type {NamedBytes} */ file) => {
    for (const reference of referencesOf(extensionOf(file.name), file.bytes)) {
      const fits = others.map((other) => ({ other, fit: likeness(other.name, reference) }));
      const best = fits.sort((a, b) => b.fit - a.fit)[0];
      if (!best?.fit || found.has(reference)) continue;
      found.set(reference, { name: reference, bytes: best.other.bytes });
      visit(best.other);
    }
  };
  visit(model);
  return [...found.values()];
}

/** When several models come at once, that of the earlier format wins.
 * @param {PathedFile[]} items @returns {Promise<Model>} */
export async function modelFrom(items) {
  /** @type {readonly string[]} */
  const known = formats;
  const rank = (/** @type {PathedFile} */ item) =>
    known.indexOf(extensionOf(withoutGz(item.path)));
  const models = items.filter((item) => rank(item) >= 0).sort((a, b) => rank(a) - rank(b));
  if (!models.length) {
    const names = items.map((item) => baseName(item.path)).slice(0, 3).join(', ');
    throw new PageError(`${names || 'That'} is not a model this page can read`,
      `Drop a ${inWords(known.map((format) => `.${format}`))} file.`);
  }
  const [chosen, ...rest] = models;
  const model = await read(chosen);
  const others = await Promise.all(items.filter((item) => item !== chosen).map(read));
  return {
    name: baseName(model.name),
    bytes: model.bytes,
    resources: resourcesOf(model, others),
    others: rest.map((item) => baseName(item.path)),
  };
}

/** @param {FileSystemEntry} entry @returns {Promise<PathedFile[]>} */
async function filesBelow(entry) {
  if (entry.isFile) {
    const file = await new Promise((resolve, reject) => {
      /** @type {FileSystemFileEntry} */ (entry).file(resolve, reject);
    });
    return [{ path: entry.fullPath.replace(/^\//, ''), file }];
  }
  const reader = /** @type {FileSystemDirectoryEntry} */ (entry).createReader();
  const found = [];
  for (;;) {  // a reader hands out its entries in portions; an empty one is the last
    /** @type {FileSystemEntry[]} */
    const portion = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (!portion.length) return found;
    for (const child of portion) found.push(...await filesBelow(child));
  }
}

/** @param {Iterable<File>} files @returns {PathedFile[]} */
export function pickedFiles(files) {
  return Array.from(files, (file) => ({ path: file.webkitRelativePath || file.name, file }));
}

/** What a drop holds, folders walked through.
 * @param {DataTransfer} transfer @returns {Promise<PathedFile[]>} */
export async function droppedFiles(transfer) {
  // Both lists must be taken now: the transfer is empty after the first wait.
  const entries = Array.from(transfer.items, (item) => item.webkitGetAsEntry?.() ?? null);
  const plain = pickedFiles(transfer.files);
  const folders = entries.filter((entry) => entry?.isDirectory);
  if (!folders.length) return plain;
  const nested = await Promise.all(entries.map((entry) => (entry ? filesBelow(entry) : [])));
  return nested.flat();
}
