// SPDX-License-Identifier: MIT
// What the page shows beside the surfaces: distances, creases, borders and faults, the triangle
// under the pointer, and the places that warnings speak of.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { decode } from 'fast-png';
import { SphereGeometry } from 'three';

import { drop, opened, reportRow, settled, visit } from '../../support/browser_page.js';
import { GltfMaker } from '../../support/gltf.js';
import { ktx2 } from '../../support/ktx2.js';
import { objText, torus } from '../../support/shape_files.js';
import { torus as torusMesh } from '../../support/shapes.js';

const { page, complaints } = await visit(
  { hash: '#model=gear&vertices=600', viewport: { width: 800, height: 480 } });

const picture = () => page.locator('#canvas').screenshot();

/** Opens a shape from its text. */
async function open(name, text) {
  await drop(page, { [name]: text });
  await opened(page, name);
}

const number = (text) => Number(text.replace(/[^\d.].*/, ''));

test('there is one largest distance, wherever it is named, and it is one click away', async () => {
  await page.waitForSelector('#distances:not([hidden])');
  const [, reported] = await reportRow(page, 'Largest distance');
  assert.match(reported, /^(?:< )?[\d.]+ %$/);
  const ends = (/** @type {string} */ text) => text.replace(/[()]/g, '').endsWith(` ${reported}`);
  assert.ok(ends(await page.textContent('#visit-largest')));
  const earlier = await picture();
  await page.click('#visit-largest');
  await page.waitForSelector('#legend:not([hidden]) .legend-marks span >> nth=1');
  assert.match(await page.textContent('#legend'), /Distance to the original.*%/);
  const most = await page.textContent('#legend .legend-marks span >> nth=1');
  assert.ok(ends(` ${most}`), `${most} beside ${reported}`);
  assert.equal(await page.getAttribute('[data-shading=distance]', 'aria-pressed'), 'true');
  assert.notDeepEqual(await picture(), earlier);
});

test('every view is a picture of its own, by button and by key', async () => {
  await page.click('[data-do=fit]');
  await page.click('#wireframe');
  const pictures = [];
  for (const view of ['plain', 'flat', 'normals', 'angles', 'distance']) {
    await page.click(`[data-shading=${view}]`);
    await page.waitForTimeout(150);
    pictures.push(String(await picture()));
  }
  // On a gear, whose faces are all flat, smooth is flat.
  assert.ok(new Set(pictures).size >= 4);
  assert.equal(await page.isDisabled('[data-shading=textured]'), true);
  await page.focus('#canvas');
  await page.keyboard.press('5');
  assert.equal(await page.getAttribute('[data-shading=angles]', 'aria-pressed'), 'true');
  await page.keyboard.press('w');
});

test('creases are counted as the angle changes', async () => {
  await page.focus('#canvas');
  await page.keyboard.press('e');
  const creases = async () => Number(await page.getAttribute('#features', 'data-count'));
  // A section has eight corners; of those around a tooth's flank some bend less.
  const first = await creases();
  assert.ok(first >= 8 * 56, `${first} creases`);
  await page.keyboard.press('e');
  await page.click('.more > summary');
  await page.fill('#option-featureAngle', '120');
  assert.equal(await page.getAttribute('#features', 'aria-pressed'), 'true');
  assert.equal(await creases(), 0);
  await page.fill('#option-featureAngle', 'off');
  assert.equal(await creases(), 0);
  await page.fill('#option-featureAngle', '');
  assert.equal(await creases(), first);
  await settled(page);
});

test('a pointer finds its triangle', async () => {
  await page.click('[data-do=fit]');
  const box = await page.locator('#canvas').boundingBox();
  await page.mouse.move(box.x + 0.635 * box.width, box.y + 0.4 * box.height);
  await page.mouse.move(box.x + 0.64 * box.width, box.y + 0.4 * box.height);
  await page.waitForSelector('#probe:not([hidden])');
  const text = await page.textContent('#probe');
  const angles = /Angles ([\d.]+)° ([\d.]+)° ([\d.]+)°/.exec(text).slice(1).map(Number);
  assert.ok(Math.abs(angles[0] + angles[1] + angles[2] - 180) < 0.3, text);
  assert.match(text, /Edges .*\nDistance .*%/);
  await page.mouse.move(5, 5);
});

test('borders, faults and flips of the input are counted and shown', async () => {
  const fault = (lines) => `${lines.join('\n')}\n`;
  const sheet = ['v 0 0 0', 'v 1 0 0', 'v 1 1 0', 'v 0 1 0', 'v 2 0 0', 'v 2 1 0', 'v 1 0 1',
    'v 1 -2.4e-16 0'];
  // Two squares side by side, but for rounding, a fin on their common edge, and one triangle
  // turned over.
  await open('faults.obj', fault([...sheet, 'f 1 2 3', 'f 1 3 4', 'f 8 5 6', 'f 8 3 6',
    'f 2 3 7']));
  await page.waitForSelector('#landmark-nonManifold');
  assert.match(await page.textContent('#landmark-nonManifold'), /^1 /);
  assert.match(await page.textContent('#landmark-flipped'), /^1 /);
  assert.match(await page.textContent('#landmark-boundary'), /^8 /);
  const earlier = await picture();
  await page.click('#landmark-nonManifold');
  await page.waitForFunction(() => document.getElementById('status').textContent
    .includes('at that place'));
  assert.notDeepEqual(await picture(), earlier);
});

/** The mean place of the distances among the bars, of which the last is the largest distance. */
const meanBar = () => page.locator('.distance-bin').evaluateAll((bars) => {
  const shares = bars.map(({ style }) => parseFloat(style.height) ** 2);  // heights are their roots
  const sum = shares.reduce((all, share) => all + share);
  return shares.reduce((mean, share, i) => mean + i * share / sum, 0);
});

test('a model far from the origin is measured as the same one near it', async () => {
  const ring = torus(24, 12);
  const positions = ring.positions.map(([x, y, z]) =>
    [x + 431234.5, y + 5412345.75, z + 312.25]);
  const reported = [];
  for (const [name, shape] of [['near.obj', ring], ['far.obj', { ...ring, positions }]]) {
    await open(name, objText(shape));
    await page.waitForSelector('#distances:not([hidden])');
    assert.ok(await page.isHidden('#landmarks'), 'no fault is seen where there is none');
    reported.push([await meanBar(), await page.getAttribute('#features', 'data-count')]);
  }
  const [[bar, creases], [farBar, farCreases]] = reported;
  assert.equal(farCreases, creases);
  assert.ok(Math.abs(farBar - bar) < 3, `${reported}`);
});

test('the largest distance inside of triangles has no second number beside it', async () => {
  // Places between the samples of a survey: around a coarse ring they are the farthest.
  for (const [m, n] of [[24, 12], [30, 8], [40, 24]]) {
    await open('ring.obj', objText(torus(m, n)));
    await page.waitForSelector('#distances:not([hidden])');
    const [, reported] = await reportRow(page, 'Largest distance');
    assert.ok((await page.textContent('#visit-largest')).endsWith(`(${reported})`), reported);
  }
});

test('dragging on the distances sets the largest error', async () => {
  await open('ring.obj', objText(torus(24, 12)));
  await page.waitForSelector('#distances:not([hidden])');
  await page.focus('#error-handle');
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => location.hash.includes('maxError='));
  await settled(page);
  const asked = Number(await page.inputValue('#option-maxError'));
  const reported = number((await reportRow(page, 'Largest distance'))[1]);
  assert.ok(asked > 0 && reported <= asked, `${reported} % within ${asked} %`);
});

test('turning the model draws two meshes with their lines and nothing else', async () => {
  const { calls, triangles } = await page.evaluate(() =>
    ({ ...document.getElementById('canvas').dataset }));
  assert.ok(Number(calls) <= 8, `${calls} calls`);
  assert.ok(Number(triangles) <= 4 * 576 + 100, `${triangles} triangles`);
  assert.deepEqual(complaints, []);
});

test('quads: nearly as many as asked for, exactly on request, in their own figures', async () => {
  await open('ring.obj', objText(torus(24, 12)));
  await page.click('#purpose-quads');
  await page.selectOption('.target select', 'vertices');
  await page.fill('#target', '400');
  await page.dispatchEvent('#target', 'change');
  await page.waitForFunction(() => /^(39|40|41)\d$/.test(
    document.getElementById('result-count').textContent));
  await settled(page);
  await page.waitForSelector('#dot-key');
  assert.match(await page.textContent('#target-hint'), /^Within 4 %; /);
  const [triangles, halves] = await reportRow(page, 'Triangles');
  const count = number((await reportRow(page, 'Quads'))[1]);
  assert.deepEqual([triangles, number(halves)], ['576', 2 * count]);
  assert.ok(Math.abs(count - 400) <= 16, `${count} quads`);
  assert.match((await reportRow(page, 'Angles off 90°, mean'))[1], /^\d+\.\d°$/);
  await page.click('[data-shading=angles]');
  assert.match(await page.textContent('#legend'), /Smallest angles.*Of quads: angles off 90°/);
  await page.check('#option-exact');
  await settled(page);
  assert.match(await page.textContent('#target-hint'), /^Exactly; /);
  assert.equal((await reportRow(page, 'Vertices'))[1], '400');
  assert.match(await page.textContent('.command'), /--quads --exact/);
  await page.fill('#target', '60');
  await page.dispatchEvent('#target', 'change');
  await settled(page);
  // Quads have no preference that keeps more of the shape.
  assert.match(await page.textContent('#shape-lost'), /original\. More vertices keep it\. /);
  await page.click('#preset-even');
  await settled(page);
});

/** A ball around the origin, and one inside it that faces the same way; with a hole, if wished. */
function ballInBall({ missing = 0 } = {}) {
  const parts = [1, 0.5].map((radius) => new SphereGeometry(radius, 16, 10).toNonIndexed());
  parts[0].setDrawRange(0, parts[0].attributes.position.count - 3 * missing);
  const places = parts.flatMap(({ attributes: { position }, drawRange }) =>
    [...position.array.subarray(0, 3 * Math.min(position.count, drawRange.count))]);
  const faces = Array.from({ length: places.length / 9 }, (_, t) => [3 * t, 3 * t + 1, 3 * t + 2]);
  return `${places.map((x, i) => (i % 3 ? ` ${x}` : `\nv ${x}`)).join('')}\n`
    + faces.map((face) => `f ${face.map((v) => v + 1).join(' ')}\n`).join('');
}

test('pieces where none belong are listed, and shown in their place', async () => {
  await open('inner.obj', ballInBall());
  await page.waitForSelector('#landmark-innerShells');
  assert.match(await page.textContent('#landmark-innerShells'), /^1 inner/);
  const earlier = await picture();
  await page.click('#landmark-innerShells');
  await page.waitForFunction(() => document.getElementById('status').textContent
    .includes('at that place'));
  assert.notDeepEqual(await picture(), earlier);
  assert.ok(await page.isVisible('#mend'));
});

test('what is broken is mended by one click, and said; each mode has its sentence', async () => {
  await open('shells.obj', ballInBall({ missing: 20 }));
  assert.match(await page.textContent('#option-repair-help'), /a hole stays a hole/);
  assert.equal(await page.isVisible('#option-gap'), false);
  await page.click('#repair-only');
  await settled(page);
  await page.waitForSelector('#repaired');
  assert.match(await page.textContent('.command'), /npx remesher repair shells\.obj -o/);
  await page.click('#mend');
  await settled(page);
  await page.waitForSelector('#repaired');
  assert.match(await page.textContent('#repaired'), /^Repair: .*(hole|shell)/);
  assert.equal(await page.inputValue('#option-repair'), 'auto');
  assert.match(await page.textContent('.command'), /--max-error \S+ .*--repair auto/);
  // Without a bound, which takes its time on a lattice.
  await page.click('#repair-only');
  await settled(page);
  await page.selectOption('#option-repair', 'wrap');
  assert.match(await page.textContent('#option-repair-help'), /openings wider than the gap/);
  await page.locator('#handle-gap').fill('20');
  assert.equal(await page.inputValue('#option-gap'), '20');
  assert.equal(await page.isVisible('#option-holesUpTo'), false);
  await settled(page);
  await page.waitForFunction(() => /Repair: wrap/.test(document.querySelector('#repaired h2')
    ?.textContent ?? ''));
  await settled(page);
});

test('printing and simulation repair', async () => {
  await open('ring.obj', objText(torus(24, 12)));
  for (const purpose of ['print', 'simulation']) {
    await page.click(`#purpose-${purpose}`);
    assert.equal(await page.inputValue('#option-repair'), 'auto');
    await settled(page);
  }
  await page.click('#preset-even');
  assert.equal(await page.inputValue('#option-repair'), '');
  await settled(page);
});

test('a cut shows what is inside, as deep as it goes', async () => {
  // Only what is drawn counts: not what lies over it, nor the ring of what keys reach.
  await page.evaluate(() => {
    document.querySelector('#canvas').style.outline = 'none';
    for (const part of document.querySelectorAll('.foot, .cutting')) part.style.opacity = '0';
  });
  await page.click('[data-do=fit]');
  await page.focus('#canvas');
  await page.waitForTimeout(300);
  const whole = String(await picture());
  await page.keyboard.press('x');
  assert.equal(await page.getAttribute('#cut', 'aria-pressed'), 'true');
  await page.waitForTimeout(300);
  const half = String(await picture());
  await page.locator('#cut-depth').fill('0.9');
  await page.waitForTimeout(300);
  const deep = String(await picture());
  assert.equal(new Set([whole, half, deep]).size, 3);
  await page.focus('#canvas');
  await page.keyboard.press('x');
  assert.equal(await page.isVisible('#cut-depth'), false);
  let again = '';
  for (let looks = 0; looks < 20 && again !== whole; looks += 1) {
    await page.waitForTimeout(300);
    again = String(await picture());
  }
  assert.ok(again === whole, 'without a cut all is as it was');
  assert.deepEqual(complaints, []);
});

test('a KTX2 texture is shown', async () => {
  const { positions, indices } = torusMesh({ columns: 24, rows: 12 });
  const maker = new GltfMaker();
  Object.assign(maker.tree, {
    images: [{ bufferView: maker.addView(ktx2(4, 4, () => [250, 20, 20])),
      mimeType: 'image/ktx2' }],
    textures: [{ extensions: { KHR_texture_basisu: { source: 0 } } }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0 } }],
    extensionsUsed: ['KHR_texture_basisu'],
    extensionsRequired: ['KHR_texture_basisu'],
  });
  maker.show([{ material: 0, indices: maker.addIndices(Uint16Array.from(indices)),
    attributes: { POSITION: maker.add(Float32Array.from(positions), 'VEC3'),
      TEXCOORD_0: maker.add(new Float32Array(2 * positions.length / 3), 'VEC2') } }]);
  await drop(page, { 'red.glb': maker.glb().bytes });
  await opened(page, 'red.glb');
  await page.click('[data-shading=textured]');
  await page.waitForTimeout(300);
  const { data, channels } = decode(await picture());
  let reddish = 0;
  for (let i = 0; i < data.length; i += channels) {
    reddish += data[i] > 100 && data[i] > 2 * data[i + 1] && data[i] > 2 * data[i + 2];
  }
  assert.ok(reddish > data.length / channels / 50, `${reddish} of ${data.length / channels}`);
});
