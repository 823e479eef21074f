// SPDX-License-Identifier: MIT
// What the rest of the build wants to know of the computer it runs on, as one value: tests make up
// others.
import { existsSync, readFileSync, realpathSync } from 'node:fs';
import { join } from 'node:path';

import { ask } from './say.js';

/**
 * @typedef {object} System
 * @property {NodeJS.Platform} platform
 * @property {string} osRelease the contents of /etc/os-release, if there is one
 * @property {Record<string, string | undefined>} environment
 * @property {boolean} isRoot
 * @property {(path: string) => boolean} exists
 * @property {(path: string) => string} realPath
 * @property {(command: string, words: readonly string[]) => string} ask what a program prints;
 *   nothing if it is not there or fails
 */

/** @returns {System} */
export function thisSystem() {
  const osRelease = '/etc/os-release';
  return {
    platform: process.platform,
    osRelease: existsSync(osRelease) ? readFileSync(osRelease, 'utf8') : '',
    environment: process.env,
    isRoot: process.getuid?.() === 0,
    exists: existsSync,
    realPath: realpathSync,
    ask,
  };
}

/** @typedef {'apt' | 'dnf' | 'pacman' | 'apk' | 'brew' | 'nix' | 'none'} Manager */

/** @type {[Manager, RegExp][]} */
const distributions = [
  ['apt', /^(ID|ID_LIKE)=.*\b(debian|ubuntu)\b/m],
  ['dnf', /^(ID|ID_LIKE)=.*\b(fedora|rhel)\b/m],
  ['pacman', /^(ID|ID_LIKE)=.*\barch\b/m],
  ['apk', /^ID=.*\balpine\b/m],
  ['nix', /^ID=.*\bnixos\b/m],
];

/** Whose names of packages a user of this system wants to read. @param {System} system */
export function packageManager(system) {
  if (system.environment.IN_NIX_SHELL) return 'nix';
  if (system.platform === 'darwin') return 'brew';
  if (system.platform !== 'linux') return 'none';
  return distributions.find(([, pattern]) => pattern.test(system.osRelease))?.[0] ?? 'none';
}

/** Ubuntu, and what is made of it. @param {System} system */
export const isUbuntu = ({ osRelease }) => /^(ID|ID_LIKE)=.*\bubuntu\b/m.test(osRelease);

/** Whose compilers have been held to no warnings: Debian 12 and 13. @param {System} system */
export const isKnown = ({ osRelease }) =>
  /^ID=debian$/m.test(osRelease) && /^VERSION_ID="?1[23]"?$/m.test(osRelease);

/** @param {string | undefined} list @param {System} system */
const splitPath = (list, system) =>
  (list ?? '').split(system.platform === 'win32' ? ';' : ':').filter(Boolean);

/**
 * Where a program is; nothing if it is not on the path.
 * @param {System} system
 * @param {string} name
 */
export function findProgram(system, name) {
  const endings = system.platform === 'win32' ? ['.exe', '.bat', '.cmd'] : [''];
  return splitPath(system.environment.PATH ?? system.environment.Path, system)
    .flatMap((folder) => endings.map((ending) => join(folder, name + ending)))
    .find(system.exists);
}

/** Where headers may lie, those the user names first. @param {System} system */
export function includeFolders(system) {
  const { environment } = system;
  const nixFlags = (environment.NIX_CFLAGS_COMPILE ?? '').matchAll(/-isystem\s+(\S+)/g);
  return [
    ...splitPath(environment.REMESHER_INCLUDE, system), ...splitPath(environment.CPATH, system),
    ...[...nixFlags].map(([, folder]) => folder),
    ...(environment.HOMEBREW_PREFIX ? [join(environment.HOMEBREW_PREFIX, 'include')] : []),
    '/opt/homebrew/include', '/usr/local/include', '/opt/local/include', '/usr/include',
  ];
}

/**
 * The folder to include from; nothing if no folder has the header. Eigen has one of its own.
 * @param {System} system
 * @param {string} header
 */
export function findHeader(system, header) {
  return includeFolders(system).flatMap((folder) => [folder, join(folder, 'eigen3')])
    .find((folder) => system.exists(join(folder, header)));
}
