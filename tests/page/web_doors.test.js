// SPDX-License-Identifier: MIT
// The way of most visitors: a purpose, one number, the verdict, the download. Each purpose is
// driven by real events in three sizes of windows, its file opened by a reader of the tests' own
// and compared with what was said. What a first visit is told goes away.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { unzipSync } from 'fflate';

import { barriers, beside } from '../support/barriers.js';
import { overlappingBoxes } from '../support/broken_shapes.js';
import { drop, opened, saved, settled, visit } from '../support/browser_page.js';
import { placesOf, readSurface } from '../support/mesh_files.js';
import { glbBytes, objText, torus } from '../support/shape_files.js';
import { stl, torus as torusArrays } from '../support/shapes.js';

const { page, complaints } = await visit({ hash: '#model=gear&vertices=300', isFirst: true,
  unseen: true, viewport: { width: 1440, height: 900 } });

const sizes = { desktop: [1440, 900], small: [1024, 768], phone: [390, 844] };
const ring = torusArrays({ columns: 40, rows: 20 });

/** The verdict's sentences, once the result is final and its distances are known. */
async function verdict() {
  await settled(page);
  await page.waitForFunction(() => !document.getElementById('download').disabled
    && document.querySelector('#distances:not([hidden])'));
  return (await page.locator('.verdict li').allTextContents()).join('\n');
}

/** Chooses a purpose as visitors do, and waits for its result. */
async function choose(purpose) {
  await page.click(`#purpose-${purpose}`);
  assert.equal(await page.getAttribute(`#purpose-${purpose}`, 'aria-pressed'), 'true');
  return verdict();
}

/** The file behind the button, which is in view without scrolling. */
async function download() {
  await page.evaluate(() => scrollTo(0, 0));
  const { top, bottom } = await page.locator('#download').evaluate((button) =>
    button.getBoundingClientRect());
  const { height } = page.viewportSize();
  assert.ok(top > 0 && bottom <= height, `the button from ${top} to ${bottom} of ${height}`);
  const label = await page.textContent('#download');
  const { name, bytes } = await saved(page, '#download');
  await settled(page);
  const files = name.endsWith('.zip') ? unzipSync(bytes) : { [name]: bytes };
  return { name, bytes, label, surface: readSurface(files) };
}

const number = (text) => Number(text.replaceAll(',', ''));
/** The number before a word in the verdict. */
const said = (text, word) => number(new RegExp(`([\\d,]+) ${word}`).exec(text)?.[1] ?? 'none');

test('three hints, one after the other, go away when read or followed', async () => {
  const hint = page.locator('#callout');
  assert.match(await hint.textContent(), /what the model is for/);
  assert.deepEqual(await barriers(page), []);
  await page.click('#purpose-quads');
  assert.match(await hint.textContent(), /Drag to turn/);
  await page.click('#callout button');
  assert.match(await hint.textContent(), /never leaves this computer/);
  await page.click('#callout button');
  assert.equal(await hint.count(), 0);
  await page.reload();
  await settled(page);
  assert.equal(await hint.count(), 0);
});

for (const [screen, [width, height]] of Object.entries(sizes)) {
  test(`each purpose, from the door to the file: ${screen}`, async () => {
    await page.setViewportSize({ width, height });
    await drop(page, { 'ring.stl': stl(ring) });
    await opened(page, 'ring.stl');
    assert.match(await page.textContent('#model-size'), /^5\.6 × 5\.6 × 1\.6/);
    assert.ok(await beside(page) <= 0);

    const sound = await choose('print');
    assert.match(sound, /Closed.*\nSound: nothing had to be repaired/);
    const same = await download();
    assert.equal(same.name, 'ring-unchanged.stl');
    assert.ok(same.bytes.equals(Buffer.from(stl(ring))), 'byte for byte');

    await page.click('#work-remesh');
    const printed = await verdict();
    const [, most] = /At most ([\d.]+) mm|lies exactly/.exec(printed);
    assert.ok(Number(most ?? 0) <= Number(await page.inputValue('#dial')), printed);

    const lighter = await choose('asset');
    const light = await download();
    assert.equal(said(lighter, 'triangles'), light.surface.faces.length);
    assert.equal(light.surface.faces.length, number(await page.inputValue('#dial')));
    assert.match(light.name, /^ring-\d+\.stl$/);
    assert.match(light.label, /^Download STL[\d.]+ kB$/);
    assert.ok(lighter.includes(`${light.label.slice('Download STL'.length)} as STL`), lighter);

    const simulated = await choose('simulation');
    assert.match(simulated, /Smallest angle 3\d\.\d°/);
    const { surface } = await download();
    const edges = surface.faces.flatMap((face) => face.map((v, i) => Math.hypot(
      ...surface.positions[v].map((x, k) => x - surface.positions[face[(i + 1) % 3]][k]))));
    const mean = edges.reduce((sum, edge) => sum + edge) / edges.length;
    assert.ok(Math.abs(mean / Number(await page.inputValue('#dial')) - 1) < 0.1, `${mean}`);

    await drop(page, { 'ring.obj': objText(torus(40, 20)) });
    await opened(page, 'ring.obj');
    const quads = await choose('quads');
    const squared = await download();
    assert.equal(said(quads, 'quads'), squared.surface.faces.length);
    assert.ok(squared.surface.faces.every((face) => face.length === 4));
    assert.match(squared.name, /^ring-quads-\d+\.obj$/);
    assert.deepEqual(await barriers(page), []);
  });
}

test('the number is turned, by slider and by hand, and the result follows', async () => {
  await page.setViewportSize({ width: 1024, height: 768 });
  const first = await page.inputValue('#dial');
  await page.focus('#dial-slider');
  await page.keyboard.press('End');
  assert.notEqual(await page.inputValue('#dial'), first);
  await page.fill('#dial', '300');
  await page.press('#dial', 'Enter');
  await page.waitForFunction(() => /purpose=quads.*faces=300/.test(location.hash));
  await page.waitForTimeout(500);  // longer than a slider has to rest
  const quads = said(await verdict(), 'quads');
  assert.ok(quads > 270 && quads <= 300, `${quads}`);
});

test('what is broken is repaired without remeshing, and said', async () => {
  await drop(page, { 'cadsoup.stl': stl(overlappingBoxes()) });
  await opened(page, 'cadsoup.stl');
  await page.click('#repair-only');
  const text = await verdict();
  assert.match(text, /Closed/);
  assert.match(text, /28 triangles, 24 before/);
  const { name, surface } = await download();
  assert.equal(name, 'cadsoup-repaired.stl');
  assert.equal(surface.faces.length, 28);
  assert.equal(placesOf(surface.positions).length, 16);
  assert.equal(await page.isVisible('#expert .takeaway'), false, 'out of sight');
  await page.click('#other-formats');
  assert.ok(await page.isVisible('.takeaway'));
  await page.click('#expert > summary');
});

test('a unit is kept with the model, and numbers follow it; glTF is metres', async () => {
  const bytes = stl(ring);
  await drop(page, { 'inch.stl': bytes });
  await opened(page, 'inch.stl');
  await page.selectOption('#unit', 'in');
  await page.click('#purpose-simulation');
  assert.match(await page.textContent('.dial label'), /, in$/);
  assert.match(await verdict(), / in \(/);
  await drop(page, { 'small.glb': glbBytes(torus(24, 12)) });
  await opened(page, 'small.glb');
  assert.match(await page.textContent('#model-size'), / m$/);
  await drop(page, { 'inch.stl': bytes });
  await opened(page, 'inch.stl');
  assert.equal(await page.inputValue('#unit'), 'in');
});

test('files of other programs are refused with what converts them', async () => {
  for (const [name, content, what] of [['part.step', 'ISO-10303-21;', /FreeCAD/],
    ['figure.fbx', 'Kaydara FBX Binary  \0', /Blender/],
    ['part.dat', 'ISO-10303-21;\nHEADER;\n', /STEP file.*Export it/]]) {
    await drop(page, { [name]: content });
    await page.waitForSelector('#error:visible');
    await settled(page);
    const text = await page.textContent('#error');
    assert.ok(text.includes(name) && what.test(text), text);
    assert.equal(await page.textContent('#model-name'), 'inch.stl');
  }
  assert.deepEqual(complaints, []);
});
