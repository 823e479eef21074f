// SPDX-License-Identifier: MIT
// clang-tidy over the native sources, two at a time. A file is looked at again only when it, a
// header it includes or the rules have changed since it was last found clean.
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';

import { filesUnder, readText, root } from './tree.js';

const cache = join(root, 'build/tidy');
const flags = ['-p', 'build/test', '--quiet', '--extra-arg=-Wno-unknown-warning-option'];

/** The file and all of ours that it includes. */
function withIncludes(file, found = new Set()) {
  if (found.has(file) || !existsSync(join(root, file))) return found;
  found.add(file);
  for (const [, included] of readText(file).matchAll(/^#include "(.+)"/gm)) {
    withIncludes(`src/${included}`, found);
  }
  return found;
}

function keyOf(file) {
  const hash = createHash('sha256').update(readText('.clang-tidy'));
  for (const part of withIncludes(file)) hash.update(part).update(readText(part));
  return join(cache, hash.digest('hex'));
}

async function tidy(file) {
  const key = keyOf(file);
  if (existsSync(key)) return '';
  try {
    await promisify(execFile)('clang-tidy', [...flags, file], { cwd: root });
  } catch (error) {
    return error.stdout || String(error);
  }
  mkdirSync(cache, { recursive: true });
  writeFileSync(key, '');
  return '';
}

/** Complaints, as clang-tidy words them; empty if there are none. */
export async function tidyAll() {
  const files = filesUnder('src', /\.cpp$/);
  const complaints = [];
  const worker = async () => {
    for (let file = files.pop(); file; file = files.pop()) complaints.push(await tidy(file));
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  return complaints.filter(Boolean).join('\n');
}
