// SPDX-License-Identifier: MIT
// Models on the page's own server: samples, and files named in the page's address.
import { t } from '../base/i18n.js';
import { baseName, PageError, pathedFile } from './files.js';
import { referencesOf } from './models.js';

/** @typedef {import('./files.js').PathedFile} PathedFile */

/** @param {URL} url @returns {Promise<ArrayBuffer | null>} null: not there */
async function load(url) {
  const response = await fetch(url).catch(() => null);
  const isPage = response?.headers.get('content-type')?.startsWith('text/html');
  return response?.ok && !isPage ? response.arrayBuffer() : null;
}

/** A file and the files it refers to, one step deep. The reader reports missing files.
 * @param {string} path from the page, on its own server @returns {Promise<PathedFile[]>} */
export async function servedFiles(path) {
  const url = new URL(path, document.baseURI);
  const name = decodeURIComponent(url.pathname.split('/').pop() ?? path);
  if (url.origin !== location.origin) {
    throw new PageError(t('error.elsewhere', { name: path }), t('error.elsewhere.hint'));
  }
  const content = await load(url);
  if (!content) throw new PageError(t('error.notServed', { name }), t('error.notServed.hint'));
  const references = referencesOf(name, new Uint8Array(content));
  const beside = await Promise.all(references.map(async (reference) => {
    const found = await load(new URL(reference, url));
    return found && pathedFile(baseName(reference), found);
  }));
  return [pathedFile(name, content), ...beside.filter((item) => item !== null)];
}
