// SPDX-License-Identifier: MIT
// What visitors may rely on: the page works without a network, from any folder, survives a lost
// graphics card, asks before work is thrown away, and stays small. What becomes of large models is
// in tests/integration/page/web_large.test.js.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { brotliCompressSync, constants } from 'node:zlib';

import { timeLeft } from '../../web/base/format.js';
import { glbOf, openGlb } from '../../web/files/glb.js';
import { countIn, thinnedGlb } from '../../web/view/thinned_glb.js';
import { drop, opened, settled, visit } from '../support/browser_page.js';
import { builtPage } from '../support/built_page.js';
import { gltfParts, objText, torus } from '../support/shape_files.js';
import { filesUnder, root } from '../support/tree.js';

const folder = await builtPage();
const sight = { hash: '#model=gear&vertices=500', unseen: true, isKept: true,
  viewport: { width: 800, height: 480 } };
const { site, page } = await visit(sight);

const quality = { params: { [constants.BROTLI_PARAM_QUALITY]: 10 } };
/** The bytes of each file that has been packed with brotli. @type {Map<string, number>} */
const sizes = new Map();

/** The bytes of some files of the page, packed with brotli. @param {string[]} files */
function packed(files) {
  for (const file of files.filter((other) => !sizes.has(other))) {
    sizes.set(file, brotliCompressSync(readFileSync(join(folder, file)), quality).length);
  }
  return files.reduce((sum, file) => sum + sizes.get(file), 0);
}

test('a first visit loads at most 300 kB of scripts, all that there is has 352', async () => {
  const first = await site.browser.newPage({ locale: 'de-DE' });
  const loaded = new Set(['offline.js']);  // which keeps the page for the next visit
  first.on('request', (request) => {
    const { pathname } = new URL(request.url());
    if (pathname.endsWith('.js')) loaded.add(pathname.slice(1));
  });
  await first.goto(site.url);
  await settled(first);
  await first.waitForSelector('#distances:not([hidden])', { state: 'attached' });
  await first.close();
  for (const name of ['index', 'de', 'survey_worker', 'whole_script']) {
    assert.ok([...loaded].some((file) => file.includes(`/${name}-`)), `${name} is loaded`);
  }
  assert.ok(packed([...loaded]) < 300_000, `${packed([...loaded])} bytes`);
  const all = filesUnder(folder.slice(folder.indexOf('build/')), /\.js$/)
    .filter((file) => !/(de|en)coder/.test(file))  // with the WebAssembly inside
    .map((file) => join(root, file).slice(folder.length + 1));
  assert.ok(packed(all) < 352_000, `${packed(all)} bytes`);
});

test('every address in the page is relative to it', () => {
  const html = readFileSync(join(folder, 'index.html'), 'utf8');
  const addresses = [...html.matchAll(/(?:src|href)="([^"]+)"/g)].map(([, address]) => address)
    .filter((address) => !address.startsWith('data:'));
  assert.ok(addresses.length >= 3);
  for (const address of addresses) assert.match(address, /^\.\//);
  const manifest = JSON.parse(readFileSync(join(folder, 'app.webmanifest'), 'utf8'));
  assert.deepEqual([manifest.start_url, manifest.scope, manifest.display],
    ['./', './', 'standalone']);
});

test('a graphics card that is lost comes back', async () => {
  const message = page.locator('#stage-message');
  await page.evaluate(() => {
    const context = document.getElementById('canvas').getContext('webgl2');
    globalThis.card = context.getExtension('WEBGL_lose_context');
    globalThis.card.loseContext();
  });
  await message.waitFor({ state: 'visible' });
  assert.match(await message.textContent(), /comes back/);
  await page.evaluate(() => globalThis.card.restoreContext());
  await message.waitFor({ state: 'hidden' });
  await page.waitForFunction(() => Number(document.getElementById('canvas').dataset.calls) > 0);
});

test('in the background, without frames, the page goes on and shows its result later', async () => {
  await page.evaluate(() => {
    globalThis.frames = [];
    globalThis.shownFrames = globalThis.requestAnimationFrame;
    globalThis.requestAnimationFrame = (callback) => globalThis.frames.push(callback);
  });
  const triangles = () => page.getAttribute('#canvas', 'data-triangles');
  const earlier = await triangles();
  await page.fill('#target', '700');
  await page.click('form button[type=submit]');
  await page.waitForSelector('#result-count:text-is("700")');
  await settled(page);
  assert.equal(await triangles(), earlier);
  await page.evaluate(() => {
    globalThis.requestAnimationFrame = globalThis.shownFrames;
    for (const callback of globalThis.frames) callback(performance.now());
  });
  await page.waitForFunction((old) =>
    document.getElementById('canvas').dataset.triangles !== old, earlier);
});

test('leaving asks when a result of one’s own file was not taken home', async () => {
  const asks = () => page.evaluate(() => {
    const event = new Event('beforeunload', { cancelable: true });
    dispatchEvent(event);
    return event.defaultPrevented;
  });
  assert.equal(await asks(), false, 'a sample');
  await drop(page, { 'mine.obj': objText(torus(16, 8)) });
  await opened(page, 'mine.obj');
  assert.equal(await asks(), true);
  await Promise.all([page.waitForEvent('download'),
    page.click('.takeaway button:text-is("GLB")')]);
  await settled(page);
  assert.equal(await asks(), false, 'it was taken home');
});

/** A GLB with a torus in two places, a colour for each vertex, and the bytes of an image. */
function colouredTorus(mesh) {
  const { json, buffer } = gltfParts(mesh);
  const colours = Buffer.alloc(4 * mesh.positions.length);
  mesh.positions.forEach((_, v) => colours.writeUInt16LE(v, 4 * v));
  const image = Buffer.from('an image');
  const [before, middle] = [buffer.length, buffer.length + colours.length];
  json.nodes.push({ mesh: 0, translation: [9, 0, 0] });
  json.scenes[0].nodes.push(1);
  json.images = [{ mimeType: 'image/png', bufferView: 3 }];
  json.bufferViews.push(
    { buffer: 0, byteOffset: before, byteLength: colours.length, byteStride: 4 },
    { buffer: 0, byteOffset: middle, byteLength: image.length });
  json.accessors.push({ bufferView: 2, componentType: 5121, normalized: true, type: 'VEC3',
    count: mesh.positions.length });
  json.meshes[0].primitives[0].attributes.COLOR_0 = 2;
  json.buffers[0].byteLength += colours.length + image.length;
  return glbOf(json, [buffer, colours, image]);
}

test('what is drawn is a part of the triangles, spread over all of them', async () => {
  const mesh = torus(120, 40);
  const glb = colouredTorus(mesh);
  const { all, isPlain } = countIn(openGlb(glb).tree);
  assert.deepEqual([all, isPlain], [2 * mesh.triangles.length, true]);
  const { bytes, thinned, parts: [{ kept, vertices }], wholes: [whole] } =
    await thinnedGlb(glb, 4000);
  assert.equal(thinned.all, all);
  assert.ok(thinned.shown > 2000 && thinned.shown <= 4000, `${thinned.shown}`);
  assert.deepEqual([...whole.corners], mesh.triangles.flat());
  assert.equal(vertices, mesh.positions.length);
  const { tree, binary } = openGlb(bytes);
  const [{ primitives: [{ attributes, indices, extras }] }] = tree.meshes;
  assert.equal(extras.whole, 0);
  const viewOf = (accessor) => tree.bufferViews[tree.accessors[accessor].bufferView];
  const at = (accessor) => binary.byteOffset + viewOf(accessor).byteOffset;
  const places = new Float32Array(binary.buffer, at(attributes.POSITION), 3 * kept.length);
  const colours = new DataView(binary.buffer, at(attributes.COLOR_0), 4 * kept.length);
  kept.forEach((v, i) => {
    assert.deepEqual([...places.subarray(3 * i, 3 * i + 3)], mesh.positions[v].map(Math.fround));
    assert.equal(colours.getUint16(4 * i, true), v);
  });
  const { count } = tree.accessors[indices];
  assert.equal(2 * count / 3, thinned.shown);
  assert.equal(Math.max(...new Uint32Array(binary.buffer, at(indices), count)), kept.length - 1);
  assert.ok(tree.accessors[attributes.NORMAL].count === kept.length);
  const { byteOffset, byteLength } = tree.bufferViews[tree.images[0].bufferView];
  assert.equal(Buffer.from(binary.subarray(byteOffset, byteOffset + byteLength)).toString(),
    'an image');
  const far = mesh.positions.filter((place) => ![...kept].some((v) =>
    Math.hypot(...mesh.positions[v].map((x, k) => x - place[k])) < 0.3));
  assert.deepEqual(far, []);
});

test('the time that is left is shown once it is known', () => {
  assert.equal(timeLeft(500, 0.5), null);
  assert.equal(timeLeft(10_000, 0.01), null);
  assert.equal(timeLeft(3000, 0.75), 1000);
});

test('after the first visit the page needs no network', async () => {
  await page.evaluate(async () => {
    const { active } = await navigator.serviceWorker.ready;
    if (active.state === 'activated') return;
    await new Promise((resolve) => { active.addEventListener('statechange', resolve); });
  });
  await site.stop();
  await page.goto(`${site.url}#model=scan&vertices=1000`);
  await page.reload();
  await settled(page);
  assert.equal(await page.textContent('#result-count'), '1,000');
  assert.equal(await page.isVisible('#error'), false);
});
