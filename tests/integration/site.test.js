// SPDX-License-Identifier: MIT
// The documentation as a site: the reference has all that is public, the site has the papers and
// needs nothing from elsewhere, and no link leads nowhere.
import assert from 'node:assert/strict';
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { inflateSync } from 'node:zlib';

import * as remesher from 'remesher';
import * as arrays from 'remesher/arrays';
import * as gltfTransform from 'remesher/gltf-transform';
import * as options from 'remesher/options';
import * as pool from 'remesher/pool';
import * as three from 'remesher/three';

import { documentation } from '../../web/documentation.js';
import { barriers } from '../support/barriers.js';
import { buildDocs } from '../support/built_docs.js';
import { builtPage } from '../support/built_page.js';
import { startChromium } from '../support/chromium.js';
import { serve } from '../support/line_of_page.js';
import { deadLinks, papers } from '../support/papers.js';
import { filesUnder, readText, root } from '../support/tree.js';

const reference = 'build/docs';
// Not made again as long as what it is made of is the same.
buildDocs();

const browser = await startChromium({ isLean: true });
after(() => browser.close());

/** The places a page has names for. */
const idsOf = (file) => [...readText(file).matchAll(/\sid="([^"]+)"/g)].map(([, id]) => id);

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

/** What the scripts of the site read, as TypeDoc packs it: an array or an object. */
function packed(name) {
  const [, text] = /"([\w+/=]+)"/.exec(readText(`${reference}/assets/${name}.js`));
  return JSON.parse(String(inflateSync(Buffer.from(text, 'base64'))));
}

/** The entries of the navigation, however deep. */
const flat = (entries) => entries.flatMap((entry) => [entry, ...flat(entry.children ?? [])]);

test('the navigation has every paper and every entry by name, and leads somewhere', () => {
  const navigation = packed('navigation');
  assert.deepEqual(navigation.map(({ text }) => text),
    ['Guides', 'Recipes', 'Reference', 'Modules', 'Project']);
  const [guides, recipes, papersToLookUp, modules, project] = navigation.map(({ children }) =>
    children.map(({ text }) => text));
  const headingOf = (file) => readText(file).match(/^# (.+)$/m)[1];
  const wanted = (files) => files.map(headingOf).sort();
  assert.deepEqual(recipes.sort(), wanted(filesUnder('docs/recipes', /\.md$/)));
  assert.deepEqual(guides.sort(),
    wanted(['docs/README.md', ...filesUnder('docs/guides', /\.md$/)]));
  assert.deepEqual([...papersToLookUp, ...project].sort(), ['Options', ...wanted([...papers
    .filter((file) => !/^README|docs\/(README|recipes|guides)/.test(file)), 'tests/README.md'])]
    .sort());
  const { name, exports } = JSON.parse(readText('package.json'));
  assert.deepEqual(modules, Object.keys(exports).filter((path) => exports[path].types)
    .map((path) => join(name, path)));
  const dead = flat(navigation).flatMap(({ path }) => path ?? [])
    .filter((path) => !existsSync(join(root, reference, decodeURIComponent(path.split('#')[0]))));
  assert.deepEqual(dead, []);
});

test('no paper is linked as bare Markdown', () => {
  assert.deepEqual(filesUnder(`${reference}/media`, /\.md$/), []);
});

test('the site fits a phone, is searched, and asks for nothing elsewhere', async () => {
  const { url, close } = await serve(join(root, reference), "'unsafe-inline'");
  const page = await browser.newPage({ viewport: { width: 390, height: 844 } });
  const complaints = [];
  page.on('console', (message) => complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => {
    if (!request.url().startsWith(url)) complaints.push(request.url());
  });
  for (const file of filesUnder(reference, /(documents\/.*|index|RemeshOptions)\.html$/)) {
    const address = `${url}/${encodeURI(file.slice(reference.length + 1))}`;
    await page.goto(address, { waitUntil: 'domcontentloaded' });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 390, `${file}: ${width}`);
  }
  await page.click('#tsd-search-trigger');
  await page.fill('#tsd-search-input', 'density');
  await page.click('#tsd-search-results a:has-text("A density of your own")');
  await page.waitForSelector('h1:has-text("A density of your own")');
  assert.deepEqual(complaints.filter((text) => !/favicon/.test(text)), []);
  await page.close();
  close();
});

test('figures of how it works show what the engine makes, and follow the hand', async () => {
  const { url, close } = await serve(join(root, reference), "'unsafe-inline'");
  const page = await browser.newPage({ viewport: { width: 800, height: 900 } });
  await page.goto(`${url}/documents/How_it_works.html`);
  const figures = page.locator('figure[data-scene]');
  const count = await figures.count();
  assert.ok(count >= 5);
  await page.waitForFunction((all) => document.querySelectorAll('figure canvas').length === all,
    count);
  for (let i = 0; i < count; ++i) {
    const canvas = figures.nth(i).locator('canvas');
    await canvas.scrollIntoViewIfNeeded();
    const before = await canvas.screenshot();
    const { x, y, width, height } = await canvas.boundingBox();
    await page.mouse.move(x + 0.7 * width, y + 0.46 * height);  // where planes have a corner
    await page.mouse.down();
    await page.mouse.move(x + 0.73 * width, y + 0.55 * height, { steps: 4 });
    await page.mouse.up();
    assert.notDeepEqual(await canvas.screenshot(), before, await figures.nth(i).textContent());
  }
  await page.close();
  close();
});

test('each guide has one live figure, made anew by the hand', async () => {
  const { url, close } = await serve(join(root, reference), "'unsafe-inline'");
  const page = await browser.newPage({ viewport: { width: 390, height: 844 } });
  const complaints = [];
  page.on('console', (message) => complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  for (const file of filesUnder('docs/guides', /\.md$/)) {
    const title = readText(file).match(/^# (.+)$/m)[1].replaceAll(/[^\w.]/g, '_');
    await page.goto(`${url}/documents/${title}.html`);
    const figure = page.locator('figure[data-scene^=job-]');
    assert.equal(await figure.count(), 1, file);
    await figure.scrollIntoViewIfNeeded();
    const words = () => figure.locator('> output').textContent();
    await page.waitForFunction(() => /\d/.test(document.querySelector('figure > output').value));
    const before = await words();
    assert.deepEqual(await barriers(page), [], file);
    const slider = figure.locator('input[type=range]').first();
    if (await slider.count() === 0) continue;
    await slider.focus();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
    await page.waitForFunction((old) =>
      document.querySelector('figure > output').value !== old, before);
  }
  assert.deepEqual(complaints.filter((text) => !/favicon/.test(text)), []);
  await page.close();
  close();
});

test('the search finds guides before properties', async () => {
  const { url, close } = await serve(join(root, reference), "'unsafe-inline'");
  const page = await browser.newPage();
  await page.goto(`${url}/index.html`);
  await page.click('#tsd-search-trigger');
  for (const [word, guide] of [['quads', 'Quads'], ['repair', 'Printing'], ['holes', 'Printing'],
    ['units', 'Printing'], ['vertices', 'Quads'], ['guides', 'Quads']]) {
    await page.fill('#tsd-search-input', word);
    await page.waitForFunction((wanted) => [...document.querySelectorAll('#tsd-search-results a')]
      .some(({ textContent }) => textContent.trim() === wanted), guide);
    const found = (await page.locator('#tsd-search-results a').allTextContents())
      .map((text) => text.trim());
    const property = found.findIndex((text) => /^remesher\.[A-Z]\w+\./.test(text));
    assert.ok(property < 0 || found.indexOf(guide) < property, `${word}: ${found}`);
  }
  await page.close();
  close();
});

test('the page leads to it where it lies beside it, and nowhere where it does not', async () => {
  const built = await builtPage();
  const bare = readFileSync(join(built, 'index.html'), 'utf8');
  const folder = mkdtempSync(join(tmpdir(), 'remesher-docs-'));
  cpSync(built, folder, { recursive: true });
  const plugin = documentation(join(root, reference));
  plugin.configResolved({ build: { outDir: folder } });
  writeFileSync(join(folder, 'index.html'), plugin.transformIndexHtml(bare));
  plugin.closeBundle();
  assert.throws(() => plugin.transformIndexHtml('<p></p>'), /no link/);
  const { url, close } = await serve(folder);
  const page = await browser.newPage({ javaScriptEnabled: false });  // the link needs none
  await page.goto(url);
  const [docs] = await Promise.all([page.waitForEvent('popup'), page.click('#reading a')]);
  await docs.waitForSelector('h1:has-text("remesher")', { state: 'attached' });
  assert.equal(new URL(docs.url()).pathname, '/docs/index.html');
  await page.setContent(bare);
  assert.ok(await page.isHidden('#reading'));
  close();
  rmSync(folder, { recursive: true });
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
