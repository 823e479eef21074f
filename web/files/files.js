// SPDX-License-Identifier: MIT
// Files from a visitor: dropped or picked, also whole folders.

/** @typedef {{ name: string, bytes: Uint8Array }} NamedBytes */
/** @typedef {{ path: string, file: File }} PathedFile */

/** An error that the visitor can mend, with a hint how. */
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
export const baseName = (path) => path.slice(path.lastIndexOf('/') + 1);

/** @param {string} path @param {BlobPart} content @returns {PathedFile} */
export const pathedFile = (path, content) =>
  ({ path, file: new File([content], baseName(path)) });

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
  for (;;) {  // a reader returns its entries in portions; the last portion is empty
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

/** All files of a drop or a clipboard, also those inside folders.
 * @param {DataTransfer} transfer @returns {Promise<PathedFile[]>} */
export async function droppedFiles(transfer) {
  // Both lists must be read now: the transfer is empty after the first await.
  const entries = Array.from(transfer.items, (item) => item.webkitGetAsEntry?.() ?? null);
  const plain = pickedFiles(transfer.files);
  const folders = entries.filter((entry) => entry?.isDirectory);
  if (!folders.length) return plain;
  const nested = await Promise.all(entries.map((entry) => (entry ? filesBelow(entry) : [])));
  return nested.flat();
}

/** Formats of pasted text, by its beginning. */
const beginnings = /** @type {[string, RegExp][]} */ ([
  ['off', /^\s*(?:ST|C|N)*OFF\b/], ['ply', /^ply\b/], ['stl', /^\s*solid\b[^]*\bfacet\b/],
  ['gltf', /^\s*\{[^]*"asset"/], ['obj', /^v[ \t]+\S/m],
]);

/** A model that was pasted as text, or null. @param {string} text */
export function pastedText(text) {
  const [format] = beginnings.find(([, pattern]) => pattern.test(text)) ?? [];
  return format ? pathedFile(`pasted.${format}`, text) : null;
}
