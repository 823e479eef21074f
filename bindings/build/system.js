// SPDX-License-Identifier: MIT
// Everything that the build asks about its computer, as one value, so that tests can make up
// systems.
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
 * @property {(command: string, words: readonly string[]) => string} ask a program's output; '' if
 *   the program is missing or fails
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

/** The package manager whose package names help a user of this system. @param {System} system */
export function packageManager(system) {
  if (system.environment.IN_NIX_SHELL) return 'nix';
  if (system.platform === 'darwin') return 'brew';
  if (system.platform !== 'linux') return 'none';
  return distributions.find(([, pattern]) => pattern.test(system.osRelease))?.[0] ?? 'none';
}

/** Ubuntu and distributions based on it. @param {System} system */
export const isUbuntu = ({ osRelease }) => /^(ID|ID_LIKE)=.*\bubuntu\b/m.test(osRelease);

/** Systems whose compilers give no warnings: Debian 12 and 13. @param {System} system */
export const isKnown = ({ osRelease }) =>
  /^ID=debian$/m.test(osRelease) && /^VERSION_ID="?1[23]"?$/m.test(osRelease);

/** @param {string | undefined} list @param {System} system */
const splitPath = (list, system) =>
  (list ?? '').split(system.platform === 'win32' ? ';' : ':').filter(Boolean);

/**
 * A program's path; undefined if PATH does not have it.
 * @param {System} system
 * @param {string} name
 */
export function findProgram(system, name) {
  const endings = system.platform === 'win32' ? ['.exe', '.bat', '.cmd'] : [''];
  return splitPath(system.environment.PATH ?? system.environment.Path, system)
    .flatMap((folder) => endings.map((ending) => join(folder, name + ending)))
    .find(system.exists);
}

/** Folders that may have headers; the user's own come first. @param {System} system */
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
 * The folder to include from; undefined if no folder has the header. Eigen's headers may lie in a
 * subfolder eigen3.
 * @param {System} system
 * @param {string} header
 */
export function findHeader(system, header) {
  return includeFolders(system).flatMap((folder) => [folder, join(folder, 'eigen3')])
    .find((folder) => system.exists(join(folder, header)));
}
