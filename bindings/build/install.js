// SPDX-License-Identifier: MIT
// Installs missing tools with apt, which needs no questions. On other systems, says which tools are
// missing and how to get them.
import { advice, missingNeeds } from './needs.js';
import { ask, BuildError, run, say } from './say.js';
import { Stamp } from './stamp.js';
import { isUbuntu, packageManager } from './system.js';

/** @typedef {import('./system.js').System} System */

const isInArchive = (/** @type {string} */ name) => ask('apt-cache', ['show', name]) !== '';

/** @param {System} system @param {readonly import('./needs.js').Need[]} needs */
async function installDebianPackages(system, needs) {
  say(`Installing what is missing: ${needs.map(({ name }) => name).join(', ')}`);
  const [command, ...first] = [...(system.isRoot ? [] : ['sudo', '-n']), 'env',
    'DEBIAN_FRONTEND=noninteractive', 'apt-get'];
  await run(command, [...first, 'update', '-qq']);
  const packages = needs.filter(({ ubuntu }) => !(ubuntu && isUbuntu(system)))
    .flatMap(({ lighter, packages: { apt = '' } }) =>
      (lighter && isInArchive(lighter) ? lighter : apt).split(' '));
  await run(command, [...first, 'install', '-y', '-qq', '--no-install-recommends', ...packages]);
}

/**
 * @param {System} system
 * @param {readonly import('./needs.js').Part[]} parts to be built
 */
export async function installTools(system, parts) {
  let missing = missingNeeds(system, parts);
  if (missing.length > 0 && packageManager(system) === 'apt') {
    await installDebianPackages(system, missing);
    missing = missingNeeds(system, parts);
  }
  if (missing.length === 0) return;
  throw new BuildError(['Building needs more than there is; only to use remesher, a plain',
    'npm install remesher will do.', ...advice(system, missing)].join('\n'));
}

export async function installNpmPackages() {
  const stamp = new Stamp('node_modules/.remesher-lock', ['package-lock.json']);
  if (stamp.isCurrent()) return;
  say('Installing npm packages');
  await run('npm', ['ci', '--no-audit', '--no-fund']);
  stamp.set();
}
