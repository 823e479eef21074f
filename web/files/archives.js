// SPDX-License-Identifier: MIT
// ZIP archives, in and out.
import { unzip, zip } from 'fflate';
import { fileSize } from '../base/format.js';
import { t } from '../base/i18n.js';
import { extensionOf, PageError, pathedFile } from './files.js';

/** @typedef {import('./files.js').PathedFile} PathedFile */
/** @typedef {import('./files.js').NamedBytes} NamedBytes */

/** Largest unpacked size of one archive: a ZIP bomb is refused before it is unpacked. */
const largestContent = 2 ** 30;

/** Folders, hidden files and macOS metadata: entries to skip. @param {string} path */
const isByTheWay = (path) => path.endsWith('/') || /(?:^|\/)(?:__MACOSX\/|\.)/.test(path);

/** @param {string} name @param {Uint8Array} bytes @returns {Promise<PathedFile[]>} */
async function unpack(name, bytes) {
  let total = 0;
  const filter = (/** @type {{ name: string, originalSize: number }} */ entry) => {
    if (isByTheWay(entry.name)) return false;
    total += entry.originalSize;
    if (total <= largestContent) return true;
    throw new PageError(t('error.zipTooLarge', { name, size: fileSize(largestContent) }),
      t('error.zipTooLarge.hint'));
  };
  /** @type {Record<string, Uint8Array>} */
  const entries = await new Promise((resolve, reject) => {
    unzip(bytes, { filter }, (error, data) => (error
      ? reject(new PageError(t('error.zip', { name }), t('error.zip.hint'))) : resolve(data)));
  });
  return Object.entries(entries).map(([path, content]) =>
    pathedFile(path, /** @type {BlobPart} */ (content)));
}

/** The files, each archive replaced by its contents.
 * @param {PathedFile[]} items @returns {Promise<PathedFile[]>} */
export async function unpacked(items) {
  const lists = await Promise.all(items.map(async (item) => (extensionOf(item.path) === 'zip'
    ? unpack(item.path, new Uint8Array(await item.file.arrayBuffer())) : [item])));
  return lists.flat();
}

/** @param {string} name @param {NamedBytes[]} files @returns {Promise<NamedBytes>} */
export function packed(name, files) {
  const entries = Object.fromEntries(files.map((file) => [file.name, file.bytes]));
  return new Promise((resolve, reject) => {
    zip(entries, { level: 6, mtime: '1980-01-01' }, (error, bytes) =>
      (error ? reject(error) : resolve({ name, bytes })));
  });
}
