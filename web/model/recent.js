// SPDX-License-Identifier: MIT
// Models opened before: only their names, unless the visitor lets the browser keep the files.
import { clear, createStore, get, set } from 'idb-keyval';
import { recall, remember } from '../base/memory.js';

/** @typedef {import('../files/files.js').PathedFile} PathedFile */

const most = 8;
const setting = 'keep-files';

/** @returns {string[]} the latest first */
export function recentNames() {
  try {
    const names = JSON.parse(recall('recent') ?? '[]');
    return Array.isArray(names) ? names.filter((name) => typeof name === 'string') : [];
  } catch {
    return [];
  }
}

export const keepsFiles = () => recall(setting) === 'on';

/** The database is opened at its first use: most visitors never need it. */
const store = () => createStore('remesher', 'files');

/** @param {string} name of the model @param {PathedFile[]} items the model and its other files */
export async function addRecent(name, items) {
  const names = [name, ...recentNames().filter((other) => other !== name)].slice(0, most);
  remember('recent', JSON.stringify(names));
  if (keepsFiles()) await set(name, items, store()).catch(() => {});
}

/** @param {string} name @returns {Promise<PathedFile[] | undefined>} */
export async function keptFiles(name) {
  return keepsFiles() ? get(name, store()).catch(() => undefined) : undefined;
}

/** @param {boolean} keeps true: files are kept from now on; false: all kept files are deleted */
export async function setKeepsFiles(keeps) {
  remember(setting, keeps ? 'on' : null);
  if (!keeps) await clear(store()).catch(() => {});
}

export async function forgetRecent() {
  remember('recent', null);
  await clear(store()).catch(() => {});
}
