// SPDX-License-Identifier: MIT
// What the papers name is there: links, files and modules. tests/integration/site.test.js has the
// site that is made of them.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';

import { deadLinks, papers } from '../support/papers.js';
import { filesUnder, readText, root } from '../support/tree.js';

/** Headings of Markdown, as they are named in links. */
const headingsOf = (file) => [...readText(file).matchAll(/^#+ (.+)$/gm)].map(([, text]) =>
  text.toLowerCase().replace(/[^\p{L}\p{N} _-]/gu, '').replaceAll(' ', '-'));

test('no link between the papers leads nowhere', () => {
  const dead = papers.flatMap((paper) => {
    const links = readText(paper).matchAll(/\]\(([^)\s]+)\)/g);
    return deadLinks(paper, [...links].map(([, link]) => link), headingsOf);
  });
  assert.deepEqual(dead, []);
});

test('the files and folders that the papers name exist', () => {
  const made = /^(build|dist)\//;
  const missing = papers.flatMap((paper) =>
    [...readText(paper).matchAll(/`((?:\.ci|bindings|src|tests|web)\/[\w./-]+)`/g)]
      .map(([, path]) => path)
      .filter((path) => !made.test(path) && !existsSync(join(root, path)))
      .map((path) => `${paper}: ${path}`));
  assert.deepEqual(missing, []);
});

test('the modules that src/README.md names exist', () => {
  const folders = new Set(filesUnder('src', /\.h$/).map((file) => dirname(file)));
  const missing = [...readText('src/README.md').matchAll(/`([\w/]+)\/(\{[\w,]+\}|\w+)`/g)]
    .filter(([, folder]) => folders.has(`src/${folder}`))
    .flatMap(([, folder, names]) => names.replace(/[{}]/g, '').split(',')
      .map((name) => `src/${folder}/${name}`))
    .filter((path) => !['', '.h', '.cpp'].some((end) => existsSync(join(root, path + end))));
  assert.deepEqual(missing, []);
});
