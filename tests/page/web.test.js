// SPDX-License-Identifier: MIT
// The page as a visitor meets it: built, served, and used in Chromium.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { drop, openPage, reportRow, saved, settled, visit } from '../support/browser_page.js';
import { glbBytes, gltfParts, objText, torus } from '../support/shape_files.js';

const shape = torus(24, 12);

/** One page that most tests share, each leaving it idle. */
const { site, page, complaints } = await visit(
  { hash: '#model=bunny&vertices=1200', viewport: { width: 800, height: 480 } });

/** Asks for a number of vertices and waits for the result. */
async function remeshTo(vertices) {
  await page.fill('#target', String(vertices));
  await page.click('form button[type=submit]');
  await settled(page);
}

test('the sample is remeshed on arrival to the count in the address', async () => {
  assert.deepEqual(await reportRow(page, 'Vertices'), ['1,839', '1,200']);
  // A closed surface of genus 0 has 2 V - 4 triangles.
  assert.deepEqual(await reportRow(page, 'Triangles'), ['3,674', '2,396']);
  assert.equal(await page.textContent('#result-count'), '1,200');
});

test('a dropped OBJ is remeshed to exactly as many vertices as were asked for', async () => {
  await drop(page, { 'ring.obj': objText(shape) });
  await settled(page);
  assert.equal(await page.textContent('#model-name'), 'ring.obj');
  await remeshTo(500);
  assert.deepEqual(await reportRow(page, 'Vertices'), ['288', '500']);
  assert.match(page.url(), /#vertices=500$/);
});

test('downloads have the vertices that the report tells of', async () => {
  const obj = await saved(page, 'text="OBJ"');
  assert.equal(obj.name, 'ring-500.obj');
  assert.equal(String(obj.bytes).match(/^v /gm).length, 500);
  const off = await saved(page, 'text="OFF"');
  assert.match(String(off.bytes), /^OFF\s+500 1000 /);
  const glb = await saved(page, '.takeaway button:text-is("GLB")');
  const jsonLength = glb.bytes.readUInt32LE(12);
  const gltf = JSON.parse(glb.bytes.subarray(20, 20 + jsonLength));
  const { attributes } = gltf.meshes[0].primitives[0];
  assert.ok(gltf.accessors[attributes.POSITION].count >= 500);
});

test('a dropped GLB is shown and remeshed', async () => {
  await drop(page, { 'ring.glb': glbBytes(shape) });
  await settled(page);
  assert.equal(await page.textContent('#model-name'), 'ring.glb');
  assert.equal(await page.isVisible('#error'), false);
  assert.deepEqual(await reportRow(page, 'Vertices'), ['288', '288']);
});

test('a glTF finds the buffer dropped with it', async () => {
  const { json, buffer } = gltfParts(shape);
  json.buffers[0].uri = 'parts/ring.bin';
  await drop(page, { 'Ring.bin': buffer, 'ring.gltf': JSON.stringify(json) });
  await settled(page);
  assert.equal(await page.isVisible('#error'), false);
  assert.equal(await page.textContent('#original-count'), '288');
});

test('a file that cannot be read is named, and the model stays', async () => {
  for (const files of [{ 'notes.txt': 'hello' }, { 'broken.glb': 'no glTF at all' },
    { 'empty.obj': '' }, { 'points.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' }]) {
    await drop(page, files);
    await page.waitForSelector('#error:visible');
    await settled(page);
    const text = await page.textContent('#error');
    assert.match(text, new RegExp(Object.keys(files)[0].replace('.', '\\.')));
    assert.doesNotMatch(text, /\[object|undefined/);
    assert.equal(await page.textContent('#model-name'), 'ring.gltf');
    assert.equal(await page.isVisible('#result table'), true);
  }
});

test('an option out of range is explained', async () => {
  await remeshTo(2);
  assert.match(await page.textContent('#error'), /2/);
  await remeshTo(300);
  assert.equal(await page.isVisible('#error'), false);
});

test('cancelling keeps the last result', async () => {
  const rows = await reportRow(page, 'Vertices');
  await page.fill('#target', '300000');
  await page.click('form button[type=submit]');
  await page.click('#cancel');
  await settled(page);
  assert.equal(await page.isVisible('#error'), false);
  assert.equal(await page.textContent('#status'), 'Cancelled');
  assert.deepEqual(await reportRow(page, 'Vertices'), rows);
  assert.equal(await page.isVisible('form button[type=submit]'), true);
});

test('keys and buttons toggle the wireframe', async () => {
  const pressed = () => page.getAttribute('#wireframe', 'aria-pressed');
  const picture = () => page.locator('#canvas').screenshot();
  await page.focus('#canvas');
  const [first, lines] = [await pressed(), await picture()];
  await page.keyboard.press('w');
  assert.notEqual(await pressed(), first);
  assert.notDeepEqual(await picture(), lines);
  await page.click('#wireframe');
  assert.equal(await pressed(), first);
});

test('the space bar shows the original while it is held', async () => {
  await page.focus('#canvas');
  await page.keyboard.down(' ');
  assert.equal(await page.isVisible('.tag-right'), false);
  await page.keyboard.up(' ');
  assert.equal(await page.isVisible('.tag-right'), true);
});

test('every option of the table is in the form', async () => {
  const { optionTable } = await import('remesher/options');
  await page.click('.more > summary');
  for (const { name, flag, form } of optionTable) {
    if (!flag || form === false) continue;
    const selector = `#option-${name}, .target option[value=${name}]`;
    assert.equal(await page.locator(selector).count(), 1, name);
  }
});

test('on a wide screen the panel scrolls, and the page never', async () => {
  const narrow = page.viewportSize();
  await page.setViewportSize({ width: 1000, height: 480 });
  const [panel, whole, screen] = await page.evaluate(() => [
    document.querySelector('.panel').scrollHeight, document.documentElement.scrollHeight,
    innerHeight]);
  await page.setViewportSize(narrow);
  assert.ok(panel > screen);
  assert.equal(whole, screen);
});

test('nothing can be sent elsewhere', async () => {
  const blocked = await page.evaluate(() => new Promise((resolve) => {
    addEventListener('securitypolicyviolation', (event) => resolve(event.violatedDirective));
    fetch('https://example.com/').catch(() => {});
  }));
  assert.equal(blocked, 'connect-src');
  // The refusal itself is all that the page had to complain about.
  assert.deepEqual(complaints.filter((text) => !text.includes('example.com')), []);
});

test('a telephone shows all without scrolling sideways, and errors where one looks', async () => {
  const phone = await openPage(site,
    { hash: '#vertices=400', viewport: { width: 390, height: 844 }, hasTouch: true });
  await settled(phone.page);
  assert.equal(await phone.page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.deepEqual(phone.complaints, []);
  await drop(phone.page, { 'broken.glb': 'no model' });
  const error = await phone.page.waitForSelector('#error:not([hidden])');
  const { y, height } = await error.boundingBox();
  assert.ok(y >= 0 && y + height <= 844, `from ${y} to ${y + height}`);
  await phone.page.close();
});

test('without WebGL the page says so and remeshes all the same', async () => {
  const blind = await openPage(site, {
    hash: '#vertices=1500',
    prepare: () => { HTMLCanvasElement.prototype.getContext = () => null; },
  });
  await settled(blind.page);
  assert.match(await blind.page.textContent('#stage-message'), /cannot show 3-D/);
  assert.deepEqual(await reportRow(blind.page, 'Vertices'), ['1,839', '1,500']);
  await blind.page.close();
});
