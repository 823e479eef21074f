// SPDX-License-Identifier: MIT
// What there is to read: the reference has all that is public, and no link leads nowhere. Links to
// other hosts are not followed.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { before, test } from 'node:test';

import * as remesher from 'remesher';
import * as arrays from 'remesher/arrays';
import * as gltfTransform from 'remesher/gltf-transform';
import * as options from 'remesher/options';
import * as pool from 'remesher/pool';
import * as three from 'remesher/three';

import { Stamp } from '../bindings/build/stamp.js';
import { filesUnder, readText, root } from './support/tree.js';

const reference = 'build/docs';
const papers =
  ['README.md', 'CHANGELOG.md', 'CONTRIBUTING.md', 'SECURITY.md', 'src/README.md',
    ...filesUnder('docs', /\.md$/)];

/** It is made of declarations, options and papers, and not again as long as they are the same. */
before(() => {
  const stamp = new Stamp('build/docs.stamp', [...papers, 'package.json',
    'node_modules/.package-lock.json', ...filesUnder('dist', /\.d\.m?ts$/),
    ...filesUnder('bindings', /\.js$/)]);
  if (stamp.isCurrent() && existsSync(join(root, reference))) return;
  execFileSync(process.execPath, ['bindings/build/docs.js'], { cwd: root, stdio: 'pipe' });
  stamp.set();
});

/** The places a page has names for. */
const idsOf = (file) => [...readText(file).matchAll(/\sid="([^"]+)"/g)].map(([, id]) => id);

/** Headings of Markdown, as they are named in links. */
const headingsOf = (file) => [...readText(file).matchAll(/^#+ (.+)$/gm)].map(([, text]) =>
  text.toLowerCase().replace(/[^\p{L}\p{N} _-]/gu, '').replaceAll(' ', '-'));

/** Links of a file that lead to no file, or to no place in it. */
function deadLinks(file, links, placesOf) {
  return links.filter((link) => !/^[a-z]+:/.test(link)).filter((link) => {
    const [path, place] = link.split('#').map(decodeURIComponent);
    const target = path === '' ? file : normalize(join(dirname(file), path));
    if (!existsSync(join(root, target))) return true;
    return Boolean(place) && /\.(html|md|svg)$/.test(target) && !placesOf(target).includes(place);
  }).map((link) => `${file}: ${link}`);
}

test('the reference has a page for every public function, and text on it', () => {
  const names = { remesher, remesher_arrays: arrays, remesher_options: options, remesher_pool: pool,
    'remesher_gltf-transform': gltfTransform, remesher_three: three };
  for (const [module, exported] of Object.entries(names)) {
    // What the main entry has, too, has its page there.
    const own = Object.entries(exported).filter(([name, value]) => value instanceof Function
      && (exported === remesher || remesher[name] !== value));
    for (const [name, value] of own) {
      const folder = /^class /.test(Function.prototype.toString.call(value))
        ? 'classes' : 'functions';
      const page = readText(`${reference}/${folder}/${module}.${name}.html`);
      assert.match(page, /tsd-comment[^>]*>\s*<p>\w/, `${name} says what it does`);
    }
  }
});

test('the reference has every option, in its table and in its type', () => {
  const table = readText(`${reference}/documents/Options.html`);
  const type = readText(`${reference}/interfaces/remesher.RemeshOptions.html`);
  for (const { name, flag } of options.optionTable) {
    assert.ok(table.includes(`<code>${name}</code>`), name);
    if (flag) assert.ok(table.includes(`<code>${flag}</code>`), flag);
    assert.ok(type.includes(`id="${name.toLowerCase()}"`), `${name} in RemeshOptions`);
  }
});

test('no link of the reference leads nowhere', () => {
  const pages = filesUnder(reference, /\.html$/);
  const dead = pages.flatMap((page) => {
    const links = readText(page).matchAll(/\s(?:href|src)="([^"]*)"/g);
    return deadLinks(page, [...links].map(([, link]) => link.replaceAll('&amp;', '&')), idsOf);
  });
  assert.ok(pages.length > 30, 'there are pages');
  assert.deepEqual(dead, []);
});

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
