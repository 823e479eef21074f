// SPDX-License-Identifier: MIT
// Models opened before: only their names, unless the visitor lets the browser keep the files.
import { clear, createStore, get, set } from 'idb-keyval';
import { Setting, switchSetting } from '../base/memory.js';

/** @typedef {import('../files/files.js').PathedFile} PathedFile */

const most = 8;
/** Letters of a name: no file system takes longer ones. */
const longestName = 1024;

/** @param {unknown} name @returns {name is string} */
const isName = (name) =>
  typeof name === 'string' && name.length > 0 && name.length <= longestName;

const recent = new Setting('recent', (text) => {
  const names = JSON.parse(text);
  const isFit = Array.isArray(names) && names.length > 0 && names.length <= most
    && names.every(isName);
  return isFit ? /** @type {string[]} */ (names) : undefined;
});
const keeping = switchSetting('keep-files', 'on');

/** @returns {string[]} the latest first */
export const recentNames = () => recent.recall() ?? [];

export const keepsFiles = () => keeping.recall() !== undefined;

/** The database is opened at its first use: most visitors never need it. */
const store = () => createStore('remesher', 'files');

/** @param {string} name of the model @param {PathedFile[]} items the model and its other files */
export async function addRecent(name, items) {
  const names = [name, ...recentNames().filter((other) => other !== name)].slice(0, most);
  recent.remember(JSON.stringify(names.filter(isName)));
  if (keepsFiles()) await set(name, items, store()).catch(() => {});
}

/** @param {any} item @returns {item is PathedFile} */
const isPathedFile = (item) => typeof item?.path === 'string' && item.file instanceof File;

/** @param {string} name @returns {Promise<PathedFile[] | undefined>} */
export async function keptFiles(name) {
  const items = keepsFiles() ? await get(name, store()).catch(() => undefined) : undefined;
  return Array.isArray(items) && items.every(isPathedFile) ? items : undefined;
}

/** @param {boolean} keeps true: files are kept from now on; false: all kept files are deleted */
export async function setKeepsFiles(keeps) {
  keeping.remember(keeps ? 'on' : null);
  if (!keeps) await clear(store()).catch(() => {});
}

export async function forgetRecent() {
  recent.remember(null);
  await clear(store()).catch(() => {});
}
