// SPDX-License-Identifier: MIT
// Whether a step is to be done again: a file remembers the hash of what it was made of.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

import { root } from './say.js';

/** Whether these contents are those of the last time; and from now on they are. */
export class Stamp {
  /** @param {string} path @param {readonly string[]} files both from the root */
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
