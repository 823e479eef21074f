// SPDX-License-Identifier: MIT
// How models come into the page: archives, several at once, folders, the clipboard, addresses, the
// list of those opened before, and the samples.
import assert from 'node:assert/strict';
import { gzipSync } from 'node:zlib';
import { test } from 'node:test';

import { unzipSync, zipSync } from 'fflate';

import { cancelAtOnce, drop, opened, saved, settled, visit } from '../../support/browser_page.js';
import { gltfParts, objText, torus } from '../../support/shape_files.js';

const ring = objText(torus(16, 8));
const text = (content) => new TextEncoder().encode(content);

const { page, complaints } = await visit(
  { hash: '#model=bunny&vertices=400', unseen: true, viewport: { width: 800, height: 500 } });

/** Waits for a model of that name, remeshed without an error. */
async function arrived(name) {
  await opened(page, name);
  assert.equal(await page.isVisible('#error'), false);
}

const shownVertices = () => page.textContent('#original-count');

test('a zipped glTF is found with its buffer, whatever lies beside it', async () => {
  const { json, buffer } = gltfParts(torus(16, 8));
  json.buffers[0].uri = 'data/ring%20one.bin';
  await drop(page, { 'export.zip': zipSync({
    'ring/scene.gltf': text(JSON.stringify(json)), 'ring/data/Ring one.bin': buffer,
    '__MACOSX/ring/._scene.gltf': text('nothing'), 'ring/readme.txt': text('hello'),
  }) });
  await arrived('scene.gltf');
  assert.equal(await shownVertices(), '128');
});

test('of several models one is chosen by name and size', async () => {
  await drop(page, { 'one.obj': ring, 'two.obj': objText(torus(20, 10)), 'notes.txt': 'no model' });
  await page.waitForSelector('#chooser[open]');
  assert.deepEqual(await page.locator('#chooser-list button').allTextContents(),
    [`one.obj${sizeOf(ring)}`, `two.obj${sizeOf(objText(torus(20, 10)))}`]);
  await page.click('#chooser-list >> text=two.obj');
  await arrived('two.obj');
  assert.equal(await shownVertices(), '200');
});

/** As the page writes it. */
const sizeOf = (content) => new Intl.NumberFormat('en', { style: 'unit', unit: 'kilobyte',
  maximumSignificantDigits: 3 }).format(content.length / 1000);

test('closing the chooser leaves all as it was', async () => {
  await drop(page, { 'one.obj': ring, 'two.obj': ring });
  await page.waitForSelector('#chooser[open]');
  await page.keyboard.press('Escape');
  await arrived('two.obj');
  assert.equal(await shownVertices(), '200');
});

test('all of several models are remeshed into one ZIP, a bad one being named', async () => {
  await page.fill('#target', '150');
  await drop(page, { 'batch.zip': zipSync({ 'a/one.obj': text(ring), 'b/one.obj': text(ring),
    'b/bad.glb': text('no glTF') }) });
  await page.waitForSelector('#chooser[open]');
  const { name, bytes } = await saved(page, '#chooser-all');
  await settled(page);
  assert.equal(name, 'remeshed.zip');
  const files = unzipSync(bytes);
  assert.deepEqual(Object.keys(files).sort(), ['a/one-150.obj', 'b/one-150.obj', 'report.json']);
  for (const path of ['a/one-150.obj', 'b/one-150.obj']) {
    assert.equal(String(Buffer.from(files[path])).match(/^v /gm).length, 150);
  }
  const reports = JSON.parse(new TextDecoder().decode(files['report.json']));
  assert.deepEqual(reports.map(({ report }) => report?.output.vertices), [undefined, 150, 150]);
  assert.match(await page.textContent('#error'), /1 of 3 .*bad\.glb/);
});

test('a folder is walked through', async () => {
  const { json, buffer } = gltfParts(torus(12, 6));
  json.buffers[0].uri = 'mesh.bin';
  await page.evaluate(async ([gltf, base64]) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const files = [['folder/model/deep.gltf', gltf], ['folder/model/mesh.bin', bytes]]
      .map(([path, content]) => {
        const file = new File([content], path.split('/').pop());
        return Object.defineProperty(file, 'webkitRelativePath', { value: path });
      });
    const input = document.getElementById('folder-input');
    Object.defineProperty(input, 'files', { value: files, configurable: true });
    input.dispatchEvent(new Event('change'));
    delete input.files;
  }, [JSON.stringify(json), Buffer.from(buffer).toString('base64')]);
  await arrived('deep.gltf');
  assert.equal(await shownVertices(), '72');
});

test('the file input takes what is picked', async () => {
  await page.setInputFiles('#file-input',
    { name: 'picked.obj.gz', mimeType: '', buffer: gzipSync(ring) });
  await arrived('picked.obj');
  assert.equal(await shownVertices(), '128');
});

/** What Ctrl+V brings. */
const paste = (content) => page.evaluate((pasted) => {
  const clipboardData = new DataTransfer();
  if (pasted.name) clipboardData.items.add(new File([pasted.content], pasted.name));
  else clipboardData.setData('text/plain', pasted.content);
  document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
}, content);

test('a model is shown even when its run is cancelled at once', async () => {
  await cancelAtOnce(page);
  await drop(page, { 'large.obj': objText(torus(60, 40)) });
  await arrived('large.obj');
  assert.equal(await shownVertices(), '2,400');
  await page.waitForFunction(() =>
    Number(document.getElementById('canvas').dataset.triangles) >= 4800);
  assert.equal(await page.isVisible('#result'), false);
});

test('files and text are pasted', async () => {
  await paste({ name: 'copied.obj', content: ring });
  await arrived('copied.obj');
  await paste({ content: ring });
  await arrived('pasted.obj');
  await paste({ content: 'a shopping list' });
  await arrived('pasted.obj');
});

test('an archive that unfolds too far, and one that is none, are refused', async () => {
  const bytes = Buffer.from(zipSync({ 'a.obj': new Uint8Array(10) }));
  bytes.writeUInt32LE(3e9, bytes.indexOf('PK\x01\x02') + 24);  // what its directory claims
  for (const [files, complaint] of [[{ 'bomb.zip': bytes }, /bomb\.zip unfolds to more than 1/],
    [{ 'none.zip': 'hello' }, /none\.zip cannot be unpacked/],
    [{ 'empty.zip': zipSync({}) }, /no file/]]) {
    await drop(page, files);
    await page.waitForSelector('#error:visible');
    await settled(page);
    assert.match(await page.textContent('#error'), complaint);
  }
});

test('names of opened files are listed, files kept only when that is asked for', async () => {
  const names = () => page.locator('#samples optgroup').nth(1).locator('option')
    .allTextContents();
  assert.equal((await names())[0], 'pasted.obj');
  await page.selectOption('#samples', 'recent:copied.obj');
  await page.waitForSelector('#error:visible');
  assert.match(await page.textContent('#error'), /only its name was kept/);
  await page.click('[data-do=settings]');
  await page.check('#keep-files');
  await page.click('#settings-close');
  await drop(page, { 'kept.obj': ring });
  await arrived('kept.obj');
  await page.reload();
  await settled(page);
  await page.selectOption('#samples', 'recent:kept.obj');
  await arrived('kept.obj');
  await page.click('[data-do=settings]');
  await page.click('#forget');
  await page.uncheck('#keep-files');
  await page.click('#settings-close');
  await page.waitForFunction(() => !document.querySelectorAll('#samples optgroup')[1]);
});

test('an address opens a file beside the page, and nothing elsewhere', async () => {
  await page.evaluate(() => { location.hash = '#model=samples/scan.obj&vertices=600'; });
  await arrived('scan.obj');
  assert.equal(await page.textContent('#result-count'), '600');
  for (const [address, complaint] of [['samples/none.obj', /none\.obj does not lie beside/],
    ['https://example.com/a.glb', /another server/]]) {
    await page.evaluate((hash) => { location.hash = hash; }, `#model=${address}`);
    await page.waitForSelector('#error:visible');
    await settled(page);
    assert.match(await page.textContent('#error'), complaint);
  }
});

test('every sample is remeshed, and says where it is from', async () => {
  for (const id of await page.locator('#samples optgroup >> nth=0 >> option')
    .evaluateAll((options) => options.map(({ value }) => value))) {
    await page.selectOption('#samples', id);
    await page.waitForFunction((wanted) => location.hash.includes(`model=${wanted}`), id);
    await settled(page);
    assert.equal(await page.isVisible('#error'), false, id);
    assert.match(await page.textContent('#model-origin'), /public domain/, id);
    assert.equal(await page.isVisible('#result table'), true, id);
  }
});

test('the page had nothing to complain about', () => {
  assert.deepEqual(complaints.filter((line) => !line.includes('404')), []);
});
