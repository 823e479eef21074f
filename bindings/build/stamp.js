// SPDX-License-Identifier: MIT
// Tells whether a step must be done again: a stamp file keeps the hash of the step's inputs.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

import { root } from './say.js';

/** isCurrent(): whether the inputs are the same as at the last set(). */
export class Stamp {
  /** @param {string} path of the stamp @param {readonly string[]} files inputs, from the root */
  constructor(path, files) {
    this.path = join(root, path);
    const hash = createHash('sha256');
    for (const file of files) hash.update(file).update(readFileSync(join(root, file)));
    this.value = hash.digest('hex');
  }

  isCurrent() {
    return existsSync(this.path) && readFileSync(this.path, 'utf8') === this.value;
  }

  set() {
    mkdirSync(dirname(this.path), { recursive: true });
    writeFileSync(this.path, this.value);
  }
}
