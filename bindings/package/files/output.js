// SPDX-License-Identifier: MIT
// Where results go: the file that the user named, and its companions below the same folder and
// nowhere else. Nothing is written over a file that was read, nor over a companion that is there
// already with other contents, unless the user forces it.

import {
  accessSync, constants, lstatSync, readFileSync, realpathSync, statSync,
} from 'node:fs';
import { basename, dirname, isAbsolute, join, relative, sep } from 'node:path';

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { Drafts, otherNamePattern, removeLeftovers } from './drafts.js';
import { undoneIfInterrupted } from './interruptions.js';
import { Lock } from './lock.js';
import { plainPaths } from './plain_names.js';
import { codeOf, kindOf, reason } from './reasons.js';

/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */

/**
 * @typedef {object} Output
 * @property {string} path of the main file
 * @property {string[]} inputs files that were read
 * @property {boolean} force whether companions that are there already may be replaced
 */

/** @param {string} path @param {string} why @param {string} [hint] */
function unwritable(path, why, hint = 'Choose another output.') {
  return new RemeshError('OUTPUT_UNWRITABLE', `${legible(path)} cannot be written: ${why}.`, hint);
}

/** Undefined: there is no such file. @param {string} path */
function lookAt(path) {
  try {
    return statSync(path);
  } catch (error) {
    if (['ENOENT', 'ENOTDIR'].includes(codeOf(error))) return undefined;
    throw unwritable(path, reason(error));
  }
}

/** A link would be replaced, and its target is not there. @param {string} path */
function refuseLostLink(path) {
  if (lstatSync(path, { throwIfNoEntry: false })?.isSymbolicLink()) {
    throw unwritable(path, 'it is a link that leads nowhere', 'Remove the link.');
  }
}

/** @param {string} path @param {Output} output */
function refuseInputs(path, { inputs }) {
  const there = lookAt(path);
  const isInput = there && inputs.some((input) => {
    const stats = lookAt(input);
    return stats?.ino === there.ino && stats.dev === there.dev;
  });
  if (isInput) throw unwritable(path, 'it is one of the files that were read');
}

/**
 * Fails early, before work that may take long.
 * @param {Output} output
 */
export function requireOutput(output) {
  const { path } = output;
  // Node shows bytes of a name that are not UTF-8 so: the file would get another name.
  if (path.includes('\ufffd')) throw unwritable(path, 'its name is not UTF-8');
  try {
    accessSync(dirname(path), constants.W_OK);
  } catch (error) {
    throw unwritable(path, reason(error));
  }
  const folder = lookAt(dirname(path));
  if (!folder?.isDirectory()) throw unwritable(path, 'a part of its path is not a folder');
  const there = lookAt(path);
  if (!there) refuseLostLink(path);
  if (there && !there.isFile()) throw unwritable(path, `it is ${kindOf(there)}`);
  refuseInputs(path, output);
}

/**
 * Throws if the innermost existing folder on the way to a companion is reached through a link that
 * leads out.
 * @param {string} folder of the output @param {string} place of a companion
 */
function requireWithin(folder, place) {
  let at = dirname(place);
  while (at !== folder && !lookAt(at)) at = dirname(at);
  const way = relative(realpathSync(folder), realpathSync(at));
  if (way === '..' || way.startsWith(`..${sep}`) || isAbsolute(way)) {
    throw unwritable(place, 'a link leads out of the output’s folder');
  }
}

/**
 * Whether a companion is the .bin of a .gltf that is about to be replaced: it is replaced, too. A
 * killed run may have left a .gltf that calls its .bin by another name.
 * @param {string} path of the main file @param {string} place of a companion
 */
function isOwnData(path, place) {
  const stem = basename(path).replace(/\.gltf$/i, '');
  if (basename(place) !== `${stem}.bin` || !lookAt(path)) return false;
  const text = readFileSync(path);
  return text.includes(`"${encodeURIComponent(basename(place))}"`)
    || (text.includes('.part.bin"') && otherNamePattern(place).test(text.toString('latin1')));
}

/**
 * Whether the companion is there already, byte by byte.
 * @param {{ place: string, bytes: Uint8Array }} companion @param {Output} output
 */
function isThere({ place, bytes }, output) {
  const there = lookAt(place);
  if (!there) {
    refuseLostLink(place);
    return false;
  }
  if (!there.isFile()) throw unwritable(place, `it is ${kindOf(there)}`);
  if (there.size === bytes.length && readFileSync(place).equals(bytes)) return true;
  refuseInputs(place, output);
  if (output.force || isOwnData(output.path, place)) return false;
  throw unwritable(place, 'it is there already, with other contents',
    'Give --force to replace it, or choose another folder.');
}

/** @param {NamedBytes} companion @param {Output} output */
function placed({ name, bytes }, { path }) {
  const { paths, why } = plainPaths(name, 'stays');
  if (!paths) throw unwritable(join(dirname(path), basename(name)), why);
  const place = join(dirname(path), paths[0]);
  requireWithin(dirname(path), place);
  return { place, bytes };
}

/** @param {NamedBytes[]} files @param {Output} output */
async function writeDrafts([main, ...others], output) {
  const all = others.map((file) => placed(file, output));
  const companions = all.filter((companion) => !isThere(companion, output));
  const drafts = new Drafts([...companions, { place: output.path, bytes: main.bytes }]);
  await undoneIfInterrupted(() => drafts.discard(), async () => {
    try {
      await drafts.write();
      drafts.move();
    } catch (error) {
      drafts.discard();
      throw error;
    }
  });
  [output, ...all.map(({ place }) => ({ path: place }))].forEach(({ path }) =>
    removeLeftovers(path));
}

/**
 * Writes all files or none.
 * @param {NamedBytes[]} files the main one first; it takes the name that `output` says
 * @param {Output} output
 */
export async function writeOutput(files, output) {
  requireOutput(output);
  const lock = new Lock(output.path);
  const unlock = () => lock.release();
  try {
    await undoneIfInterrupted(unlock, async () => {
      try {
        if (files.length > 1) await lock.acquire();
        await writeDrafts(files, output);
      } finally {
        unlock();  // while signals are still handled
      }
    });
  } catch (error) {
    throw error instanceof RemeshError ? error : unwritable(output.path, reason(error));
  }
}
