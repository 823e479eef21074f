// SPDX-License-Identifier: MIT
// Node in any version, from the npm packages that hold nothing but its program: nothing of the
// computer's own Node is touched.
import { join } from 'node:path';

import { call } from '../support/fresh_project.js';

const platform = process.platform === 'win32' ? 'win' : process.platform;
const minutes = 60_000;

/** The npm package that holds nothing but Node for this computer. */
export const nodePackage = `node-${platform}-${process.arch}`;

/**
 * @param {string} version as npm knows it: a release line, such as 22, or a version
 * @param {string} folder a new one, which will hold it
 * @returns {string} where the program is
 */
export function installNode(version, folder) {
  call('npm', ['install', '--prefix', folder, '--no-save', '--no-audit', '--no-fund', '--silent',
    `${nodePackage}@${version}`], folder, 10 * minutes);
  return join(folder, 'node_modules', nodePackage, 'bin', platform === 'win' ? 'node.exe' : 'node');
}
