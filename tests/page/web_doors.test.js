// SPDX-License-Identifier: MIT
// The way of most visitors: a purpose, one number, the verdict, the download, in a large window;
// tests/integration/page/small_screens.test.js has the others. The hints of a first visit go
// away.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { strFromU8, unzipSync } from 'fflate';

import { barriers } from '../support/barriers.js';
import { overlappingBoxes } from '../support/broken_shapes.js';
import { drop, opened, saved, settled, visit } from '../support/browser_page.js';
import { choose, download, eachPurpose, ring, said, verdict } from '../support/doors.js';
import { plate } from '../support/machine_parts.js';
import { placesOf } from '../support/mesh_files.js';
import { glbBytes, torus } from '../support/shape_files.js';
import { stl } from '../support/shapes.js';

const { page, complaints } = await visit({ hash: '#model=gear&vertices=300', isFirst: true,
  unseen: true, viewport: { width: 1440, height: 900 } });

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

test('each purpose, from the door to the file', () => eachPurpose(page, [1440, 900]));

test('the number is turned, by slider and by hand, and the result follows', async () => {
  await page.setViewportSize({ width: 1024, height: 768 });
  const first = await page.inputValue('#amount');
  await page.focus('#amount-slider');
  await page.keyboard.press('End');
  assert.notEqual(await page.inputValue('#amount'), first);
  await page.fill('#amount', '300');
  await page.press('#amount', 'Enter');
  await page.waitForFunction(() => /purpose=quads.*faces=300/.test(location.hash));
  await page.waitForTimeout(500);  // longer than a slider has to rest
  const quads = said(await verdict(page), 'quads');
  assert.ok(quads > 270 && quads <= 300, `${quads}`);
});

test('what is broken is repaired without remeshing, and said', async () => {
  await drop(page, { 'cadsoup.stl': stl(overlappingBoxes()) });
  await opened(page, 'cadsoup.stl');
  await page.click('#repair-only');
  const text = await verdict(page);
  assert.match(text, /Closed/);
  assert.match(text, /28 triangles, 24 before/);
  // The walls inside are gone, and said to be; what is seen is where it was.
  assert.match(text, /lies exactly on the original/);
  const { name, surface } = await download(page);
  assert.equal(name, 'cadsoup-repaired.stl');
  assert.equal(surface.faces.length, 28);
  assert.equal(placesOf(surface.positions).length, 16);
  assert.equal(await page.isVisible('#expert .takeaway'), false, 'out of sight');
  await page.click('#other-formats');
  assert.ok(await page.isVisible('.takeaway'));
  await page.click('#expert > summary');
});

test('while another result is made, the one before cannot be saved as if it were it', async () => {
  const wasSavable = await page.evaluate(async () => {
    const isSavable = () => [...document.querySelectorAll('.savers button')]
      .some((button) => !button.disabled);
    document.getElementById('purpose-simulation').click();
    let was = isSavable();
    while (document.body.dataset.state !== 'idle') {
      await new Promise(requestAnimationFrame);
      was ||= document.body.dataset.state !== 'idle' && isSavable();
    }
    return was;
  });
  assert.equal(wasSavable, false);
  await verdict(page);
  assert.equal(await page.locator('.savers button:enabled').count(), 3, 'and two for solvers');
});

test('another edge length is no wish to see creases; too long a one is said so', async () => {
  await page.fill('#amount', '50');
  await page.press('#amount', 'Enter');
  await page.waitForSelector('#error:visible');
  await settled(page);
  assert.match(await page.textContent('#error'), /shorter edge length/);
  assert.equal(await page.getAttribute('#features', 'aria-pressed'), 'false');
});

test('what closes a hole is surface that was added, not shape that was lost', async () => {
  const { positions, indices } = ring;
  await drop(page, { 'open.stl': stl({ positions, indices: indices.slice(0, -360) }) });
  await opened(page, 'open.stl');
  const text = await choose(page, 'print');
  assert.match(text, /Closed.*\nSurface was added.*\n/);
  assert.match(text, /Repaired: 2 holes closed\./);
  assert.doesNotMatch(text, /lost/);
  assert.match(await page.textContent('#verdict-short'), /^Closed · surface added · /);
});

test('a model that has fewer vertices than its shape needs is opened all the same', async () => {
  const box = (x, y) => [0, 1].flatMap((k) => [0, 1].flatMap((j) => [0, 1].map((i) =>
    `v ${x + i} ${y + j} ${k}`)));
  const sides = ['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'];
  const further = sides.map((side) => side.replace(/\d/g, (v) => ` ${Number(v) + 8}`));
  await drop(page, { 'touching.obj': [...box(0, 0), ...box(1, 1),
    ...[...sides, ...further].map((side) => `f ${side}`), ''].join('\n') });
  await opened(page, 'touching.obj');
  const text = await verdict(page);
  assert.equal(await page.isVisible('#error'), false);
  assert.match(text, /^Closed, but more than two triangles meet at 1 edge\./);
  assert.match(await page.textContent('#landmark-nonManifold'), /^1 non-manifold edge$/);
});

test('where edges are too long for wide angles, shorter ones are offered, and help', async () => {
  await drop(page, { 'plate.stl': stl(plate()) });
  await opened(page, 'plate.stl');
  await page.evaluate(() => {
    location.hash = 'purpose=simulation&edgeLength=5.8&minAngle=20&adaptivity=0.3&gradation=1.3'
      + '&featureAngle=30';
  });
  await page.click('.verdict button:text-is("Half the edge length")');
  assert.equal(await page.inputValue('#amount'), '2.9');
  const text = await verdict(page);
  assert.match(text, /Smallest angle [2-5]\d\.\d°/);
  assert.doesNotMatch(text, /narrow|damage/);
});

test('a unit is kept with the model, and numbers follow it; glTF is metres', async () => {
  const bytes = stl(ring);
  await drop(page, { 'inch.stl': bytes });
  await opened(page, 'inch.stl');
  assert.equal(await page.inputValue('#unit'), 'none', 'nothing says it');
  assert.match(await verdict(page), / units \(/);
  await page.selectOption('#unit', 'in');
  await page.click('#purpose-simulation');
  assert.match(await page.textContent('.amount label'), /, in$/);
  assert.match(await verdict(page), / in \(/);
  assert.match(await page.textContent('#visit-largest'), / in \(/);
  // Experts see lengths in the same unit, and percentages as lengths, too.
  assert.match(await page.textContent('#target-kind option[value=edgeLength]'), /, in$/);
  assert.equal(await page.textContent('label[for=option-maxEdge] .unit'), ', in');
  assert.match(await page.textContent('label[for=option-maxError] .unit'),
    / \(1 % = 0\.0808 in\)$/);
  await page.click('#expert > summary');
  await page.click('.command > summary');
  assert.match(await page.textContent('.command code >> nth=0'), / --units in$/);
  const written = await saved(page, '.takeaway button:text-is("3MF")');
  assert.match(strFromU8(unzipSync(written.bytes)['3D/3dmodel.model']), / unit="inch"/);
  await settled(page);
  await page.click('#expert > summary');
  await drop(page, { 'inches.3mf': written.bytes });
  await opened(page, 'inches.3mf');
  assert.equal(await page.inputValue('#unit'), 'in', 'the file says so');
  const large = { ...ring, positions: ring.positions.map((x) => 20 * x) };
  await drop(page, { 'large.stl': stl(large) });
  await opened(page, 'large.stl');
  assert.equal(await page.inputValue('#unit'), 'mm');
  assert.match(await page.textContent('#model-size'), /^112 × 112 × 32 .*assumed$/);
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
