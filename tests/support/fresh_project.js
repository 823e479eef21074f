// SPDX-License-Identifier: MIT
// A user's new project: the package, packed as for npm, installed into a separate folder.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync }
  from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';

import { root } from './tree.js';

/** The libraries of the adapters, their types, and the codecs of images. */
const peers = ['three', '@types/three', '@gltf-transform', '@jsquash'];

/**
 * Runs a program to its end.
 * @param {string} command
 * @param {readonly string[]} words
 * @param {string} cwd
 * @param {number} [timeout] milliseconds
 */
export function call(command, words, cwd, timeout = 120_000) {
  return execFileSync(command, words,
    { cwd, encoding: 'utf8', timeout, stdio: ['ignore', 'pipe', 'pipe'] });
}

/**
 * @returns {{ folder: string, tarball: { filename: string, size: number,
 *   files: { path: string }[] }, manifest: any, write: (name: string, text: string) => string,
 *   remove: () => void }}
 */
export function freshProject() {
  const folder = mkdtempSync(join(tmpdir(), 'remesher-project-'));
  const [tarball] = JSON.parse(
    call('npm', ['pack', '--json', '--ignore-scripts', '--pack-destination', folder], root));
  const write = (/** @type {string} */ name, /** @type {string} */ text) => {
    const path = join(folder, name);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, text);
    return path;
  };
  write('package.json', '{ "type": "module", "private": true }');
  call('npm', ['install', '--offline', '--no-audit', '--no-fund', join(folder, tarball.filename)],
    folder);
  const manifest =
    JSON.parse(readFileSync(join(folder, 'node_modules/remesher/package.json'), 'utf8'));
  return { folder, tarball, manifest, write, remove: () => rmSync(folder, { recursive: true }) };
}

/** Installs it from where it is already. @param {string} folder */
export function linkPeers(folder) {
  for (const name of peers) {
    const place = join(folder, 'node_modules', name);
    mkdirSync(dirname(place), { recursive: true });
    if (!existsSync(place)) symlinkSync(join(root, 'node_modules', name), place);
  }
}
